#include "ripstop/inflate/deviation.h"

#include <Eigen/Geometry>
#include <cmath>

#include "ripstop/base/index.h"
#include "ripstop/base/parallel.h"
#include "ripstop/geometry/triangle.h"
#include "ripstop/mesh/surface_finder.h"

namespace ripstop {
namespace {

/// The drawn tiles, for one thread: a finder builds its search structure at the first query.
class Drawing {
  public:
    explicit Drawing(const CutPlan& plan) : plan_(plan) {
        for (const FlatTile& tile : plan.tiles) finders_.emplace_back(tile.tile.mesh);
    }

    /// The signed distance of a point on tile `own` from the drawn surface; `drawn` is its own drawn place.
    double distance(const Vec3& point, const Vec3& drawn, std::size_t own) {
        double reach = (point - drawn).norm() * (1 + 1e-9) + 1e-12, signed_distance = (point - drawn).norm();
        look(own, point, reach, signed_distance);
        for (std::size_t i = 0; i < finders_.size(); ++i)
            if (i != own) look(i, point, reach, signed_distance);
        return signed_distance;
    }

  private:
    void look(std::size_t tile, const Vec3& point, double& reach, double& signed_distance) {
        const auto found = finders_[tile].nearest(point, reach);
        if (!found) return;
        reach = found->distance;
        const TriangleMesh& mesh = plan_.tiles[tile].tile.mesh;
        const int t = found->point.triangle;
        const Vec3 normal = (mesh.corner(t, 1) - mesh.corner(t, 0)).cross(mesh.corner(t, 2) - mesh.corner(t, 0));
        const Vec3 way = point - finders_[tile].surface().position(found->point);
        signed_distance = std::copysign(found->distance, normal.dot(way));
    }

    const CutPlan& plan_;
    std::vector<SurfaceFinder> finders_;
};

Eigen::VectorXd vertex_areas(const TriangleMesh& mesh) {
    Eigen::VectorXd areas = Eigen::VectorXd::Zero(mesh.vertex_count());
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k)
            areas[mesh.triangles(t, k)] += triangle_area(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)) / 3;
    return areas;
}

/// Accumulates the deviation of the tiles; `weight` is the area of a tile.
struct Sum {
    double off = 0, moved = 0, area = 0;
    Deviation most;

    void add(double area_here, double off_here, double moved_here) {
        off += area_here * off_here * off_here;
        moved += area_here * moved_here * moved_here;
        area += area_here;
        if (std::abs(off_here) > std::abs(most.max)) most.max = off_here;
        most.moved_max = std::max(most.moved_max, moved_here);
    }
    Deviation result() const {
        Deviation deviation = most;
        deviation.rms = std::sqrt(off / std::max(area, 1e-300));
        deviation.moved_rms = std::sqrt(moved / std::max(area, 1e-300));
        return deviation;
    }
};

}  // namespace

void measure_deviation(const CutPlan& plan, int threads, Inflated& inflated) {
    const int workers = threads > 0 ? threads : available_threads(), count = static_cast<int>(plan.tiles.size());
    parallel_for(workers, workers, [&](int worker) {
        Drawing drawing(plan);
        for (int i = worker; i < count; i += workers) {
            InflatedTile& tile = inflated.tiles[at(i)];
            const Points3& drawn = plan.tiles[at(i)].tile.mesh.positions;
            tile.deviation.resize(drawn.rows());
            for (Eigen::Index v = 0; v < drawn.rows(); ++v)
                tile.deviation[v] = drawing.distance(tile.positions.row(v), drawn.row(v), static_cast<std::size_t>(i));
        }
    });
    Sum all;
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        const TriangleMesh& mesh = plan.tiles[i].tile.mesh;
        InflatedTile& tile = inflated.tiles[i];
        const Eigen::VectorXd areas = vertex_areas(mesh);
        Sum here;
        for (Eigen::Index v = 0; v < areas.size(); ++v) {
            const double moved = (tile.positions.row(v) - mesh.positions.row(v)).norm();
            here.add(areas[v], tile.deviation[v], moved);
            all.add(areas[v], tile.deviation[v], moved);
        }
        tile.off = here.result();
    }
    inflated.off = all.result();
}

}  // namespace ripstop
