#include "ripstop/model/plan/cut_plan.h"

#include <algorithm>

namespace ripstop {

bool FlatTile::is_flat() const {
    const Points2& positions = flattening.positions;
    return positions.rows() == tile.mesh.vertex_count() && positions.rows() > 0 && positions.allFinite();
}

bool CutPlan::manufacturable() const {
    return findings.empty() &&
           std::all_of(tiles.begin(), tiles.end(), [](const FlatTile& tile) { return tile.verdict.manufacturable(); });
}

double CutPlan::area() const {
    double sum = 0;
    for (const FlatTile& tile : tiles) sum += tile.accuracy.area;
    return sum;
}

std::vector<Quantity> quantities(const CutPlan& plan) {
    std::vector<Quantity> counts(plan.tiles.size());
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        const FlatTile& tile = plan.tiles[i];
        Quantity& count = counts[tile.equal_to < 0 ? i : static_cast<std::size_t>(tile.equal_to)];
        ++(tile.mirrored ? count.mirrored : count.same);
    }
    return counts;
}

Tolerances CutPlan::tolerances_of(const Tile& tile) const {
    Tolerances limits = tolerances;
    if (!tile.fabric) return limits;
    if (!limits.strain_for_all) limits.strain = tile.fabric->strain_limit;
    if (!limits.shear_for_all) limits.shear = tile.fabric->shear_limit;
    return limits;
}

std::vector<Fabric> CutPlan::fabrics() const {
    std::vector<Fabric> found;
    for (const FlatTile& tile : tiles)
        if (std::find(found.begin(), found.end(), fabric_of(tile.tile)) == found.end())
            found.push_back(fabric_of(tile.tile));
    if (found.empty()) found.push_back(fabric);
    return found;
}

}  // namespace ripstop
