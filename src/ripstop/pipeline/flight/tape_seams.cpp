#include "ripstop/pipeline/flight/tape_seams.h"

#include <Eigen/Geometry>

#include "ripstop/base/index.h"

namespace ripstop {

void tape_meridians(CutPlan& plan) {
    Eigen::AlignedBox3d box;
    for (const FlatTile& tile : plan.tiles)
        for (Eigen::Index v = 0; v < tile.tile.mesh.positions.rows(); ++v)
            box.extend(Vec3(tile.tile.mesh.positions.row(v)));
    const Vec3 middle = box.center();
    for (Seam& seam : plan.seams) {
        if (seam.into) continue;
        const Tile& tile = plan.tiles[at(seam.a.tile)].tile;
        double along = 0, round = 0;
        for (const SeamPart& part : seam.a.parts) {
            const auto i = static_cast<std::size_t>(part.edge), n = tile.boundary.size();
            const Vec3 from = tile.mesh.positions.row(tile.boundary[i]),
                       to = tile.mesh.positions.row(tile.boundary[(i + 1) % n]);
            const Vec3 out = 0.5 * (from + to) - middle;
            const Vec3 round_direction = Vec3(-out.y(), out.x(), 0).normalized();
            const double share = (to - from).dot(round_direction);
            const double length = std::max((to - from).norm(), 1e-300);
            round += share * share / length;
            along += ((to - from).squaredNorm() - share * share) / length;
        }
        if (along <= round || seam.type.tape) continue;
        seam.type.name = "taped";
        seam.type.tape = true;
    }
}

void tape_seams(CutPlan& plan, TapedSeams tapes) {
    if (tapes == TapedSeams::meridians) tape_meridians(plan);
    if (tapes == TapedSeams::none)
        for (Seam& seam : plan.seams) seam.type.tape = false;
}

}  // namespace ripstop
