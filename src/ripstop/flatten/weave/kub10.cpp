#include "ripstop/flatten/weave/kub10.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "ripstop/flatten/weave/weave_frame.h"
#include "ripstop/flatten/weave/weave_reading.h"
#include "ripstop/geometry/triangle.h"

namespace ripstop {
namespace {

constexpr double steepest = 0.70710678;  ///< cosine of 45 degrees

/// The plane normal to the tile's area vector, as axes along warp and weft (columns).
Mat32 projection_plane(const Tile& tile) {
    const Vec3 sum = area_vector(tile.mesh);
    const Vec3 normal = sum.norm() > 1e-9 * surface_area(tile.mesh) ? Vec3(sum.normalized()) : Vec3(Vec3::UnitZ());
    Vec3 warp = tile.grain.direction - normal.dot(tile.grain.direction) * normal;
    warp = warp.norm() > 1e-6 ? Vec3(warp.normalized()) : Vec3(normal.unitOrthogonal());
    Mat32 axes;
    axes << warp, normal.cross(warp);
    return axes;
}

/// The crossings of a plane weave over triangles that are not too steep, sorted by distance from the centre.
std::vector<WovenNode> projected_crossings(const Tile& tile, const UnfoldedSurface& surface, const WeaveFrame& frame,
                                           const Mat32& plane) {
    const Vec2 centre = plane.transpose() * surface.position(frame.centre);
    std::map<std::pair<int, int>, SurfacePoint> found = {{{0, 0}, frame.centre}};
    for (int t = 0; t < tile.mesh.triangle_count(); ++t) {
        Eigen::Matrix<double, 2, 3> corners;  // in spacings from the centre
        for (int k = 0; k < 3; ++k)
            corners.col(k) = (plane.transpose() * tile.mesh.corner(t, k) - centre) / frame.spacing;
        Mat22 edges;
        edges << corners.col(1) - corners.col(0), corners.col(2) - corners.col(0);
        const double flat = 0.5 * edges.determinant() * frame.spacing * frame.spacing;
        if (flat < steepest * triangle_area(tile.mesh, t)) continue;
        const Vec2 low = corners.rowwise().minCoeff(), high = corners.rowwise().maxCoeff();
        const Mat22 inverse = edges.inverse();
        for (int i = static_cast<int>(std::ceil(low.x())); i <= high.x(); ++i)
            for (int j = static_cast<int>(std::ceil(low.y())); j <= high.y(); ++j) {
                const Vec2 share = inverse * (Vec2(i, j) - corners.col(0));
                const Vec3 barycentric(1 - share.sum(), share.x(), share.y());
                if (barycentric.minCoeff() >= 0) found.try_emplace({i, j}, surface.at(t, barycentric));
            }
    }
    std::vector<WovenNode> nodes;
    for (const auto& [site, at] : found) nodes.push_back({at, site.first, site.second});
    std::stable_sort(nodes.begin(), nodes.end(), [](const WovenNode& a, const WovenNode& b) {
        return a.warp * a.warp + a.weft * a.weft < b.warp * b.warp + b.weft * b.weft;
    });
    return nodes;
}

}  // namespace

Flattening flatten_kub10(const Tile& tile, const WovenOptions& options) {
    require_valid(options);
    const Adjacency adjacency(tile.mesh.triangles, tile.mesh.vertex_count());
    const UnfoldedSurface surface(tile.mesh);
    const WeaveFrame frame = make_weave_frame(tile, adjacency, surface, options.spacing);
    const std::vector<WovenNode> start = projected_crossings(tile, surface, frame, projection_plane(tile));
    const WovenFit fit = settle_woven_mesh(surface, start, frame.spacing, most_crossings(tile), options);
    return read_weave(tile, adjacency, surface, fit, frame.centre.triangle,
                      fit.at_rest ? Termination::converged : Termination::iteration_limit, weave_ending(fit));
}

}  // namespace ripstop
