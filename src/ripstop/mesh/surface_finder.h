#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>

#include "ripstop/mesh/geodesic.h"

namespace ripstop {

/// Finds nearest points on one surface, for callers that ask many surfaces about few points. A surface whose bounding
/// box is out of reach costs almost nothing; the search structure of the others is built at the first query.
class SurfaceFinder {
  public:
    struct Found {
        SurfacePoint point;
        double distance = 0;  ///< [m]
    };

    /// `mesh` must outlive it.
    explicit SurfaceFinder(const TriangleMesh& mesh) : mesh_(&mesh) {
        for (int v = 0; v < mesh.vertex_count(); ++v) box_.extend(Vec3(mesh.positions.row(v)));
    }

    /// The nearest point; empty if the surface is further away than `reach` [m]. O(#F).
    std::optional<Found> nearest(const Vec3& point, double reach) {
        if (box_.exteriorDistance(point) > reach) return std::nullopt;
        const SurfacePoint at = surface().nearest(point);
        const double distance = (surface().position(at) - point).norm();
        return distance <= reach ? std::optional<Found>({at, distance}) : std::nullopt;
    }

    const UnfoldedSurface& surface() {
        if (!surface_) surface_ = std::make_unique<UnfoldedSurface>(*mesh_);
        return *surface_;
    }

  private:
    const TriangleMesh* mesh_;
    Eigen::AlignedBox3d box_;
    std::unique_ptr<UnfoldedSurface> surface_;
};

}  // namespace ripstop
