#include "ripstop/measure/judge_zigzags.h"

#include <cmath>

#include "ripstop/base/index.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"
#include "ripstop/geometry/polygon.h"
#include "ripstop/mesh/boundary.h"
#include "ripstop/tile/find_zigzags.h"
#include "ripstop/tile/targets.h"

namespace ripstop {
namespace {

/// The compensation of the edges along a zigzag: cloth per drawn length.
double cloth_per_length(const Zigzag& zigzag, const Tile& tile) {
    if (!tile.compensation.any()) return 1;
    const Eigen::VectorXd drawn = drawn_lengths(tile), target = target_lengths(tile);
    std::vector<bool> along(static_cast<std::size_t>(tile.mesh.vertex_count()), false);
    for (std::size_t i = 0; i + (zigzag.closed ? 0 : 1) < zigzag.vertices.size(); ++i)
        along[at(zigzag.vertices[i])] = true;
    double before = 0, after = 0;
    for (Eigen::Index i = 0; i < drawn.size(); ++i) {
        if (!along[at(tile.boundary[at(i)])]) continue;
        before += drawn[i];
        after += target[i];
    }
    return after / before;
}

std::string in_mm(double length) {
    return format_fixed(length / millimetre, 1) + " mm";
}

Finding finding_of(const ZigzagWalk& walk, const Tile& tile, double limit) {
    const Zigzag& zigzag = walk.zigzag;
    return {"zigzag",
            "the edge" + (zigzag.mate.empty() ? std::string() : " along " + zigzag.mate) + zigzag.seams_text() +
                " zigzags, with teeth up to " + in_mm(zigzag.teeth) +
                " high that fold on the cloth: the curve that it stands for is " + in_mm(walk.length) +
                " long in space and " + in_mm(walk.flat_length) + " on the cloth, " +
                format_fixed(std::abs(walk.error()) / percent, 3) + " % " + (walk.error() > 0 ? "longer" : "shorter") +
                ", where it encloses " + format_fixed(walk.area, 3) + " m2 in space and " +
                format_fixed(walk.flat_area, 3) +
                " m2 on the cloth; draw a smooth seam, or cut along one with --fair-seams",
            tile.mesh.positions.row(zigzag.vertices[zigzag.vertices.size() / 2]), walk.error() / percent,
            limit / percent};
}

}  // namespace

std::vector<ZigzagWalk> walk_zigzags(const Tile& tile, const Points2& flat, const std::vector<Zigzag>& zigzags) {
    std::vector<ZigzagWalk> walks;
    if (zigzags.empty() || flat.rows() != tile.mesh.vertex_count() || !flat.allFinite()) return walks;
    const Eigen::VectorXd turning = surface_turning(tile.mesh, tile.boundary);
    double area = surface_area(tile.mesh), flat_area = signed_area(Points2(flat(tile.boundary, Eigen::all)));
    for (const Zigzag& zigzag : zigzags) {
        const FairCurve curve(layout_of(zigzag, tile, turning));
        const FairLine cloth = curve.of_image(layout_of(Points2(flat(zigzag.vertices, Eigen::all)), zigzag.closed));
        area -= curve.line().area_on_left;
        flat_area -= cloth.area_on_left;
        walks.push_back({zigzag, curve.line().length * cloth_per_length(zigzag, tile), cloth.length, 0, 0});
    }
    for (ZigzagWalk& walk : walks) {
        walk.area = area;
        walk.flat_area = flat_area;
    }
    return walks;
}

void judge_zigzags(const Tile& tile, const std::vector<ZigzagWalk>& walks, const Tolerances& tolerances,
                   Verdict& verdict) {
    for (const ZigzagWalk& walk : walks)
        if (!(std::abs(walk.error()) <= tolerances.length))
            verdict.findings.push_back(finding_of(walk, tile, tolerances.length));
}

void judge_zigzags(CutPlan& plan) {
    std::vector<const Tile*> tiles;
    for (const FlatTile& flat : plan.tiles) tiles.push_back(&flat.tile);
    std::vector<std::vector<Zigzag>> of_tile(plan.tiles.size());
    for (Zigzag& zigzag : find_zigzags(tiles, plan.seams)) of_tile[at(zigzag.tile)].push_back(std::move(zigzag));
    for (std::size_t t = 0; t < plan.tiles.size(); ++t) {
        FlatTile& flat = plan.tiles[t];
        judge_zigzags(flat.tile, walk_zigzags(flat.tile, flat.flattening.positions, of_tile[t]),
                      plan.tolerances_of(flat.tile), flat.verdict);
    }
}

}  // namespace ripstop
