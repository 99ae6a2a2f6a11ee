#include "ripstop/pattern/piece/drawn_lines.h"

#include "ripstop/geometry/simplify.h"
#include "ripstop/mesh/geodesic.h"

namespace ripstop {

std::vector<DrawnLine> draw_lines(const FlatTile& tile, double chord_error) {
    if (tile.tile.lines.empty()) return {};
    const UnfoldedSurface surface(tile.tile.mesh);
    std::vector<DrawnLine> drawn;
    for (const SurfaceLine& line : tile.tile.lines) {
        Points2 flat = Points2::Zero(line.points.rows(), 2);
        for (Eigen::Index i = 0; i < flat.rows(); ++i) {
            const SurfacePoint at = surface.nearest(line.points.row(i));
            const Vec3 weights = surface.barycentric(at);
            for (int k = 0; k < 3; ++k)
                flat.row(i) += weights[k] * tile.flattening.positions.row(tile.tile.mesh.triangles(at.triangle, k));
        }
        drawn.push_back({line.name, simplified(flat, chord_error)});
    }
    return drawn;
}

}  // namespace ripstop
