#include "ripstop/report/view/page_maps.h"

#include <algorithm>
#include <functional>

#include "ripstop/report/figures/figures.h"

namespace ripstop {
namespace {

bool has_strains(const StrainMap& strain) {
    return strain.warp.size() > 0;
}

bool has_load_tapes(const CutPlan& plan) {
    return plan.inflated && std::any_of(plan.inflated->tapes.begin(), plan.inflated->tapes.end(),
                                        [](const auto& tape) { return tape.kind == TapeKind::load; });
}

}  // namespace

const std::vector<PageMap>& page_maps() {
    using enum PageMap::Shown;
    static const std::vector<PageMap> maps{
        {"warp", "Strain along the warp", cloth, "cloth shrinks", "cloth stretches"},
        {"weft", "Strain along the weft", cloth, "cloth shrinks", "cloth stretches"},
        {"shear", "Shear between the threads", cloth, "threads open", "threads close"},
        {"area", "Area", cloth, "piece too small", "piece too large"},
        {"edges", "Edge error", both, "", "mean of the edges of each triangle", true},
        {"mismatch", "Seam mismatch", edges, "this edge is shorter", "this edge is longer"},
        {"tension", "Tension along the seams", edges, "pushed", "pulled"},
        {"deviation", "Off the drawn shape", cloth, "inside the drawn shape", "outside", false, true},
        {"flight-tension", "Tension of the cloth", cloth, "", "the larger principal tension", true, true},
        {"flight-warp", "Stress along the warp", cloth, "", "pulled", true, true},
        {"flight-weft", "Stress along the weft", cloth, "", "pulled", true, true},
        {"flight-shear", "Shear stress", cloth, "", "either way", true, true},
        {"flight-strain-warp", "Warp in flight", cloth, "folded", "stretched", false, true},
        {"flight-strain-weft", "Weft in flight", cloth, "folded", "stretched", false, true},
        {"flight-strain-shear", "Shear in flight", cloth, "threads open", "threads close", false, true},
        {"state", "Wrinkles", cloth, "", "", false, true},
        {"tapes", "Force in the load tapes", edges, "", "the largest along each seam", true, true}};
    return maps;
}

const PageMap& page_map(std::string_view id) {
    return *std::find_if(page_maps().begin(), page_maps().end(), [&](const auto& map) { return map.id == id; });
}

std::vector<std::string_view> maps_of(const CutPlan& plan, const std::vector<StrainMap>& strains) {
    const bool is_strained = std::any_of(strains.begin(), strains.end(), has_strains);
    const bool is_drawn = std::any_of(plan.tiles.begin(), plan.tiles.end(), std::mem_fn(&FlatTile::is_flat));
    const bool is_held = std::any_of(plan.tiles.begin(), plan.tiles.end(),
                                     [](const auto& tile) { return tile.flattening.seam_tension.size() > 0; });
    std::vector<std::string_view> ids;
    for (const PageMap& map : page_maps()) {
        const bool is_there = map.id == "tapes"      ? has_load_tapes(plan)
                              : map.is_in_flight     ? plan.inflated.has_value()
                              : map.id == "mismatch" ? !plan.walks.empty()
                              : map.id == "tension"  ? is_held
                              : map.id == "edges"    ? is_drawn
                                                     : is_strained;
        if (is_there) ids.push_back(map.id);
    }
    if (ids.empty()) ids.push_back("edges");
    return ids;
}

std::string_view first_map(const CutPlan& plan, const std::vector<StrainMap>& strains) {
    const std::vector<std::string_view> ids = maps_of(plan, strains);
    const bool tiles_pass = std::all_of(plan.tiles.begin(), plan.tiles.end(),
                                        [](const FlatTile& tile) { return tile.verdict.manufacturable(); });
    const bool seams_pass = std::all_of(plan.walks.begin(), plan.walks.end(), [](const auto& walk) { return walk.ok; });
    std::string_view preferred = "warp";
    if (tiles_pass && !seams_pass) preferred = "mismatch";
    if (tiles_pass && seams_pass && plan.inflated) preferred = "deviation";
    return std::find(ids.begin(), ids.end(), preferred) != ids.end() ? preferred : ids.front();
}

}  // namespace ripstop
