#include "ripstop/report/view/page_maps.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ripstop/base/text/units.h"
#include "ripstop/report/figures/cloth_map.h"
#include "ripstop/report/figures/figures.h"
#include "ripstop/report/figures/seam_drift.h"
#include "ripstop/report/view/page_colours.h"

namespace ripstop {
namespace {

bool has_strains(const StrainMap& strain) {
    return strain.warp.size() > 0;
}

const Eigen::VectorXd* strains_of(const StrainMap& strain, std::string_view id) {
    if (id == "warp") return &strain.warp;
    if (id == "weft") return &strain.weft;
    if (id == "shear") return &strain.shear;
    return id == "area" ? &strain.area : nullptr;
}

double cloth_limit(const CutPlan& plan, const Tile& tile, const PageMap& map) {
    if (map.id == "area") return plan.tolerances.area;
    return map.id == "shear" ? plan.tolerances_of(tile).shear : plan.tolerances_of(tile).strain;
}

/// The largest tension of all seams, rounded up to 1, 2 or 5: nothing says what a seam may bear [N].
double tension_limit(const CutPlan& plan) {
    double largest = 1e-9;
    for (const FlatTile& tile : plan.tiles)
        for (const double tension : tile.flattening.seam_tension)
            if (std::isfinite(tension)) largest = std::max(largest, std::abs(tension));
    const double decade = std::pow(10, std::floor(std::log10(largest)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * decade >= largest * (1 - 1e-9)) return factor * decade;
    return 10 * decade;
}

using Places = std::vector<std::vector<std::uint16_t>>;

Places unknown_edges(const CutPlan& plan) {
    Places places;
    for (const FlatTile& tile : plan.tiles) places.emplace_back(tile.tile.boundary.size(), page_places::unknown);
    return places;
}

Places mismatch_places(const CutPlan& plan) {
    Places places = unknown_edges(plan);
    for (std::size_t i = 0; i < plan.walks.size(); ++i)
        for (const bool is_b : {false, true}) {
            const SeamWalk& walk = plan.walks[i];
            const SeamSide& side = is_b ? plan.seams[i].b : plan.seams[i].a;
            double walked = 0;
            for (const SeamPart& part : side.parts) {
                const double middle = walked + part.length / 2;
                const double drift = drift_at(walk, is_b ? walk.length - middle : middle);
                places[static_cast<std::size_t>(side.tile)][static_cast<std::size_t>(part.edge)] =
                    page_place((is_b ? drift : -drift) / walk.limit);
                walked += part.length;
            }
        }
    return places;
}

Places stepped_places(const CutPlan& plan, const PageMap& map) {
    Places places = unknown_edges(plan);
    const double limit = map.id == "tension" ? tension_limit(plan) : plan.tolerances.length;
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        const FlatTile& tile = plan.tiles[i];
        if (!is_drawable(tile)) continue;
        Eigen::VectorXd values = tile.flattening.seam_tension;
        if (map.id == "edges")
            values = edge_lengths(tile.flattening.positions, closed(tile.tile.boundary)).array() /
                         target_lengths(tile.tile).array() -
                     1;
        for (Eigen::Index e = 0; e < std::min(values.size(), static_cast<Eigen::Index>(places[i].size())); ++e)
            places[i][static_cast<std::size_t>(e)] = page_place(values[e] / limit);
    }
    return places;
}

/// The smallest and the largest limit of the tiles, in the legend's unit.
template <class Limit>
std::array<double, 2> range(const CutPlan& plan, const Limit& limit) {
    if (plan.tiles.empty()) return {0, 0};
    std::array<double, 2> found{limit(plan.tiles[0].tile), limit(plan.tiles[0].tile)};
    for (const FlatTile& tile : plan.tiles)
        found = {std::min(found[0], limit(tile.tile)), std::max(found[1], limit(tile.tile))};
    return found;
}

PageLegend both_ways(const std::string& most, const std::string& note) {
    return {"−" + most, "+" + most, note};
}

}  // namespace

const std::vector<PageMap>& page_maps() {
    static const std::vector<PageMap> maps{
        {"warp", "Strain along the warp", "cloth shrinks", "cloth stretches", true},
        {"weft", "Strain along the weft", "cloth shrinks", "cloth stretches", true},
        {"shear", "Shear between the threads", "threads open", "threads close", true},
        {"area", "Area", "piece too small", "piece too large", true},
        {"edges", "Edge error", "", "mean of the edges of each triangle", true, true, true},
        {"mismatch", "Seam mismatch", "this edge is shorter", "this edge is longer", false, true},
        {"tension", "Tension along the seams", "pushed", "pulled", false, true}};
    return maps;
}

const PageMap& page_map(std::string_view id) {
    const auto found =
        std::find_if(page_maps().begin(), page_maps().end(), [&](const auto& map) { return map.id == id; });
    return *found;
}

std::vector<std::string_view> maps_of(const CutPlan& plan, const std::vector<StrainMap>& strains) {
    const bool is_strained = std::any_of(strains.begin(), strains.end(), has_strains);
    const bool is_drawn = std::any_of(plan.tiles.begin(), plan.tiles.end(), is_drawable);
    const bool is_held = std::any_of(plan.tiles.begin(), plan.tiles.end(),
                                     [](const auto& tile) { return tile.flattening.seam_tension.size() > 0; });
    std::vector<std::string_view> ids;
    for (const PageMap& map : page_maps()) {
        const bool is_there = map.id == "mismatch"  ? !plan.walks.empty()
                              : map.id == "tension" ? is_held
                              : map.id == "edges"   ? is_drawn
                                                    : is_strained;
        if (is_there) ids.push_back(map.id);
    }
    if (ids.empty()) ids.push_back("edges");
    return ids;
}

std::string_view first_map(const CutPlan& plan, const std::vector<StrainMap>& strains) {
    const std::vector<std::string_view> ids = maps_of(plan, strains);
    const auto fails = [](const auto& judged) { return !judged.verdict.manufacturable(); };
    const bool only_seams =
        std::none_of(plan.tiles.begin(), plan.tiles.end(), fails) &&
        std::any_of(plan.walks.begin(), plan.walks.end(), [](const auto& walk) { return !walk.ok; });
    const std::string_view preferred = only_seams ? "mismatch" : "warp";
    return std::find(ids.begin(), ids.end(), preferred) != ids.end() ? preferred : ids.front();
}

std::vector<std::uint16_t> cloth_places(const CutPlan& plan, std::size_t tile, const StrainMap& strain,
                                        const PageMap& map) {
    const FlatTile& flat = plan.tiles[tile];
    const auto count = static_cast<std::size_t>(flat.tile.mesh.triangle_count());
    std::vector<std::uint16_t> places(count, page_places::unknown);
    if (!map.is_of_cloth || !is_drawable(flat)) return places;
    const Eigen::VectorXd* values = strains_of(strain, map.id);
    if (values && values->size() != static_cast<Eigen::Index>(count)) return places;
    const double limit = cloth_limit(plan, flat.tile, map);
    for (std::size_t t = 0; t < count; ++t) {
        const double value =
            values ? (*values)[static_cast<Eigen::Index>(t)] : mean_edge_error(flat, static_cast<int>(t));
        places[t] = page_place(value / limit);
    }
    return places;
}

std::vector<std::vector<std::uint16_t>> edge_places(const CutPlan& plan, const PageMap& map) {
    if (!map.is_of_edges) return {};
    return map.id == "mismatch" ? mismatch_places(plan) : stepped_places(plan, map);
}

PageLegend page_legend(const CutPlan& plan, const PageMap& map) {
    if (map.id == "mismatch")
        return both_ways(fmt::format("{:.4g} mm", plan.tolerances.length / millimetre),
                         "how far the two sides are apart, for each metre of seam");
    if (map.id == "tension") {
        PageLegend legend = both_ways(fmt::format("{:.4g} N", tension_limit(plan)),
                                      "the force that holds each edge at its length; scale: the largest there is");
        legend.is_pinned = false;
        return legend;
    }
    const auto [least, most] = range(plan, [&](const Tile& tile) { return cloth_limit(plan, tile, map); });
    if (map.id == "shear")
        return both_ways(fmt::format("{:.4g}°", most / degree),
                         least == most
                             ? ""
                             : fmt::format("limits of the fabrics: {:.4g} to {:.4g}°", least / degree, most / degree));
    const std::string note = map.id == "edges" ? fmt::format("band along the seams: pinned to ±{:.4g} % of length",
                                                             plan.tolerances.length / percent)
                                               : "";
    const std::string low = fmt::format("{:.6g}", least / percent), high = fmt::format("{:.6g}", most / percent);
    if (low == high) return both_ways(high + " %", note);
    return {"− limit", fmt::format("+ limit ({} to {} %)", low, high), note};
}

}  // namespace ripstop
