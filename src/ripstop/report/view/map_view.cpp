#include "ripstop/report/view/map_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "ripstop/base/text/units.h"
#include "ripstop/report/view/page_colours.h"
#include "ripstop/report/words/inflated_says.h"

namespace ripstop {
namespace {

constexpr double share_within = 0.99;
constexpr double smallest_scale = 1e-3;  ///< of a map with the limit 0, in its unit

struct MapUnit {
    double size = 1;
    std::string_view text;
};

MapUnit unit_of(const PageMap& map) {
    if (map.id == "shear" || map.id == "flight-strain-shear") return {degree, "°"};
    if (map.id == "mismatch" || map.id == "deviation") return {millimetre, " mm"};
    if (map.id == "tension" || map.id == "tapes") return {1, " N"};
    if (map.is_in_flight && !map.id.starts_with("flight-strain")) return {1, " N/m"};
    return {percent, " %"};
}

const SafetyFactor* judged(const CutPlan& plan, std::string_view part) {
    for (const SafetyFactor& each : plan.inflated->safety)
        if (each.part == part) return &each;
    return nullptr;
}

/// The load allowed for a part as strong as the one judged.
double allowed_load(const SafetyFactor& factor) {
    return factor.load * factor.factor / factor.required;
}

/// The limit for a tile's triangles; empty if there is none.
std::optional<double> allowed_on_cloth(const CutPlan& plan, const Tile& tile, const PageMap& map) {
    const Tolerances limits = plan.tolerances_of(tile);
    if (!map.is_of_cloth() || map.is_of_states()) return {};
    if (map.id == "area") return plan.tolerances.area;
    if (map.id == "shear" || map.id == "flight-strain-shear") return limits.shear;
    if (map.id == "deviation") return deviation_limit(*plan.inflated);
    if (!map.is_in_flight || map.id.starts_with("flight-strain")) return limits.strain;
    const SafetyFactor* cloth = judged(plan, "cloth");
    if (!cloth) return {};
    return allowed_load(*cloth) * plan.fabric_of(tile).strength / cloth->strength;
}

std::optional<double> allowed_on_edges(const CutPlan& plan, const PageMap& map) {
    if (map.id == "edges" || map.id == "mismatch") return plan.tolerances.length;
    const SafetyFactor* tapes = map.id == "tapes" ? judged(plan, "load tapes") : nullptr;
    return tapes ? std::optional(allowed_load(*tapes)) : std::nullopt;
}

std::vector<double> sizes_of(const std::vector<Eigen::VectorXd>& values) {
    std::vector<double> sizes;
    for (const Eigen::VectorXd& each : values)
        for (const double value : each)
            if (std::isfinite(value)) sizes.push_back(std::abs(value));
    return sizes;
}

/// The quantile `share` of the sizes.
double below_which(std::vector<double> sizes, double share) {
    if (sizes.empty()) return 0;
    const auto at = sizes.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(sizes.size() - 1));
    std::nth_element(sizes.begin(), at, sizes.end());
    return *at;
}

/// Rounds up to 1, 2 or 5 times a power of ten.
double rounded_up(double value) {
    const double decade = std::pow(10, std::floor(std::log10(value)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * decade >= value * (1 - 1e-9)) return factor * decade;
    return 10 * decade;
}

/// The limits of all tiles, with their minimum and maximum.
struct Allowed {
    std::vector<double> cloth;  ///< per tile; empty if there is no limit
    std::optional<double> edges;
    double least = 0, most = 0;  ///< of the limits that the legend states

    bool is_known() const { return most > 0; }
};

Allowed allowed_of(const CutPlan& plan, const PageMap& map) {
    Allowed allowed;
    for (const FlatTile& tile : plan.tiles)
        if (const auto limit = allowed_on_cloth(plan, tile.tile, map)) allowed.cloth.push_back(*limit);
    allowed.edges = allowed_on_edges(plan, map);
    if (!allowed.cloth.empty()) {
        const auto [least, most] = std::minmax_element(allowed.cloth.begin(), allowed.cloth.end());
        allowed.least = *least;
        allowed.most = *most;
    } else if (allowed.edges && !map.is_of_cloth()) {
        allowed.least = allowed.most = *allowed.edges;
    }
    return allowed;
}

bool lies_beyond(const Eigen::VectorXd& values, double limit) {
    return std::any_of(values.begin(), values.end(), [&](double value) { return std::abs(value) > limit; });
}

bool is_exceeded(const MapView& view, const Allowed& allowed) {
    for (std::size_t i = 0; i < allowed.cloth.size(); ++i)
        if (lies_beyond(view.cloth[i], allowed.cloth[i])) return true;
    return allowed.edges && std::any_of(view.edges.begin(), view.edges.end(),
                                        [&](const auto& edges) { return lies_beyond(edges, *allowed.edges); });
}

std::string figure_text(double value, const MapUnit& unit) {
    return fmt::format("{:.4g}{}", value / unit.size, unit.text);
}

/// About three significant digits; 0 if below any meaningful value.
std::string measured_text(double value, const MapUnit& unit) {
    const double shown = value / unit.size;
    if (shown < 1e-6) return fmt::format("0{}", unit.text);
    return shown >= 100 ? fmt::format("{:.0f}{}", shown, unit.text) : fmt::format("{:.3g}{}", shown, unit.text);
}

std::string range_text(const Allowed& allowed, const MapUnit& unit) {
    const std::string most = figure_text(allowed.most, unit);
    const std::string least = fmt::format("{:.4g}", allowed.least / unit.size);
    return fmt::format("{:.4g}", allowed.most / unit.size) == least ? most : fmt::format("{} to {}", least, most);
}

void set_ends(MapScale& scale, const PageMap& map, const std::string& most) {
    scale.low = map.is_unsigned ? "0" : fmt::format("−{}", most);
    scale.middle = std::string(map.is_unsigned ? 0 : 1, '0');
    scale.high = map.is_unsigned ? most : fmt::format("+{}", most);
}

/// The note of a map that holds in any scale.
std::string own_note(const CutPlan& plan, const PageMap& map) {
    if (map.id == "mismatch") return "distance between the two sides per metre of seam";
    if (map.id == "tension") return "the force that holds each edge at its length";
    if (map.id.starts_with("flight-strain")) return "from the cloth as cut";
    if (map.is_of_states())
        return fmt::format("{:.1f} % of the cloth is wrinkled: pulled one way and folded across it; {:.1f} % is slack",
                           plan.inflated->wrinkled / percent, plan.inflated->slack / percent);
    return {};
}

std::string joined(const std::vector<std::string>& parts) {
    std::string text;
    for (const std::string& part : parts) {
        if (part.empty()) continue;
        if (!text.empty()) text += "; ";
        text += part;
    }
    return text;
}

std::string band_note(const PageMap& map, double limit) {
    return map.shown == PageMap::Shown::both ? fmt::format("band along the seams: ±{:.4g} % of length", limit / percent)
                                             : "";
}

/// The reason for the ends of the scale, if it is a tolerance.
std::string reason(const PageMap& map) {
    if (map.id == "deviation") return "allowed: 0.3 % of the height";
    if (map.id == "tapes" || (map.is_in_flight && map.is_unsigned))
        return "allowed: the usable strength divided by the required factor";
    return map.id == "area" || map.is_of_edges() ? "the tolerance" : "the limit of the fabric";
}

MapScale tolerance_scale(const CutPlan& plan, const PageMap& map, const Allowed& allowed) {
    MapScale scale{"tolerance", allowed.cloth, allowed.edges.value_or(1), true};
    const MapUnit unit = unit_of(map);
    const bool is_one = allowed.least >= allowed.most * (1 - 1e-9);
    set_ends(scale, map, is_one ? figure_text(allowed.most, unit) : "limit");
    scale.note = joined({own_note(plan, map),
                         is_one ? reason(map) : fmt::format("{}, {}", reason(map), range_text(allowed, unit)),
                         allowed.edges ? band_note(map, *allowed.edges) : ""});
    return scale;
}

/// The values by which a map's colours are stretched: of the stresses the tension's, so that they can be compared.
std::vector<double> sizes_on_cloth(const CutPlan& plan, const MapView& view) {
    const PageMap& map = *view.map;
    const bool is_stress = map.is_in_flight && map.is_of_cloth() && map.is_unsigned;
    if (!is_stress || map.id == "flight-tension") return sizes_of(view.cloth);
    std::vector<Eigen::VectorXd> tensions;
    for (std::size_t i = 0; i < plan.tiles.size(); ++i)
        tensions.push_back(cloth_values(plan, i, {}, page_map("flight-tension")));
    return sizes_of(tensions);
}

MapScale there_scale(const CutPlan& plan, const MapView& view, const Allowed& allowed) {
    const PageMap& map = *view.map;
    const MapUnit unit = unit_of(map);
    const auto ending = [&](double reach, double least) {
        return rounded_up(std::max({reach, least, smallest_scale * (least > 0 ? 0 : unit.size)}) / unit.size) *
               unit.size;
    };
    const std::vector<double> edges = sizes_of(view.edges);
    const std::vector<double> cloth = sizes_on_cloth(plan, view);
    MapScale scale{"there"};
    const double on_cloth = ending(below_which(cloth, share_within), allowed.least / 100);
    scale.cloth.assign(map.is_of_cloth() ? plan.tiles.size() : 0, on_cloth);
    scale.edges = ending(below_which(edges, 1), allowed.edges.value_or(0) / 100);
    set_ends(scale, map, figure_text(map.is_of_cloth() ? on_cloth : scale.edges, unit));
    const double most = below_which(map.is_of_cloth() ? sizes_of(view.cloth) : edges, 1);
    scale.note = joined({own_note(plan, map), fmt::format("at most {}", measured_text(most, unit)),
                         allowed.is_known() ? fmt::format("{} allowed", range_text(allowed, unit)) : "",
                         band_note(map, scale.edges)});
    return scale;
}

}  // namespace

MapView map_view(const CutPlan& plan, const std::vector<StrainMap>& strains, const PageMap& map) {
    MapView view{&map, {}, edge_values(plan, map), {}};
    for (std::size_t i = 0; i < plan.tiles.size(); ++i)
        view.cloth.push_back(cloth_values(plan, i, i < strains.size() ? strains[i] : StrainMap(), map));
    if (map.is_of_states()) {
        view.scales = {{"there"}};
        view.scales[0].note = own_note(plan, map);
        return view;
    }
    const Allowed allowed = allowed_of(plan, map);
    view.scales = {there_scale(plan, view, allowed)};
    if (!allowed.is_known()) return view;
    view.scales.push_back(tolerance_scale(plan, map, allowed));
    if (is_exceeded(view, allowed)) std::swap(view.scales[0], view.scales[1]);
    return view;
}

std::vector<MapView> map_views(const CutPlan& plan, const std::vector<StrainMap>& strains) {
    std::vector<MapView> views;
    for (const std::string_view id : maps_of(plan, strains)) views.push_back(map_view(plan, strains, page_map(id)));
    return views;
}

const MapView& view_of(const std::vector<MapView>& views, std::string_view id) {
    return *std::find_if(views.begin(), views.end(), [&](const MapView& view) { return view.map->id == id; });
}

std::vector<std::uint16_t> cloth_places(const CutPlan& plan, const MapView& view, std::size_t tile, std::size_t scale) {
    const auto count = static_cast<std::size_t>(plan.tiles[tile].tile.mesh.triangle_count());
    std::vector<std::uint16_t> places(count, page_places::unknown);
    const Eigen::VectorXd& values = view.cloth[tile];
    const MapScale& ends = view.scales[scale];
    for (std::size_t t = 0; t < static_cast<std::size_t>(values.size()); ++t) {
        const double value = values[static_cast<Eigen::Index>(t)];
        places[t] = view.map->is_of_states() ? static_cast<std::uint16_t>(page_places::taut + static_cast<int>(value))
                                             : page_place(value / ends.cloth[tile], ends.has_beyond);
    }
    return places;
}

std::vector<std::uint16_t> edge_places(const MapView& view, std::size_t tile, std::size_t scale) {
    if (view.edges.empty()) return {};
    const MapScale& ends = view.scales[scale];
    std::vector<std::uint16_t> places;
    for (const double value : view.edges[tile])
        places.push_back(std::isfinite(value) ? page_place(value / ends.edges, ends.has_beyond) : page_places::unknown);
    return places;
}

}  // namespace ripstop
