#include "ripstop/report/picture/piece_png.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "ripstop/base/text/units.h"
#include "ripstop/report/view/page_drawing.h"
#include "ripstop/report/view/piece_view.h"
#include "ripstop/report/words/page_words.h"

namespace ripstop {
namespace {

constexpr double card_margin = 28;
constexpr double title_size = 22;

std::string millimetres(double length, int decimals = 1, bool is_signed = false) {
    return page_figure(length / millimetre, decimals, is_signed) + "\u00a0mm";
}
std::string percent_text(double ratio, int decimals = 2) {
    return page_figure(ratio / percent, decimals, true) + "\u00a0%";
}
std::string degrees_text(double angle, int decimals) {
    return page_figure(angle / degree, decimals) + "°";
}

/// The strip at the top with verdict and name.
std::string head(double width, const std::string& name, const std::string& word, bool is_good) {
    const double verdict = text_width(word, 16, true);
    return "<rect width=\"" + svg_number(width) + "\" height=\"6\" fill=\"" + (is_good ? page_good : page_bad) +
           "\"/>\n" + verdict_mark({card_margin + 16, 42}, is_good) +
           text_within({card_margin + 22, 42}, name, width - 2 * card_margin - verdict - 40,
                       {title_size, "start", page_ink, true}) +
           svg_text({width - card_margin, 42}, word, {16, "end", is_good ? page_good : page_bad, true});
}

std::string pattern_words(const CutPlan& plan, std::size_t i) {
    const FlatTile& tile = plan.tiles[i];
    if (tile.equal_to >= 0)
        return "cut like " + plan.tiles[static_cast<std::size_t>(tile.equal_to)].tile.name +
               (tile.mirrored ? ", turned over" : "");
    const Quantity count = quantities(plan)[i];
    std::string words = count.same > 1 ? std::to_string(count.same) + " cut alike" : "";
    if (count.mirrored > 0) words += (words.empty() ? "" : ", ") + std::to_string(count.mirrored) + " turned over";
    return words.empty() ? "cut once" : words;
}

std::vector<std::string> figures(const PieceSource& source, std::size_t i) {
    const FlatTile& tile = source.plan.tiles[i];
    const Accuracy& a = tile.accuracy;
    const Tolerances limits = source.plan.tolerances_of(tile.tile);
    const Vec2 size = piece_extent(tile, source.pieces[i]).size() / millimetre;
    const std::string limit = short_figure(limits.strain / percent) + "\u00a0%";
    return {fmt::format("Piece {} × {}\u00a0mm, {}  ·  area {}\u00a0m² ({} on the cloth)  ·  outline {} ({})",
                        page_figure(size.x(), 0), page_figure(size.y(), 0), pattern_words(source.plan, i),
                        page_figure(a.area, a.area < 1 ? 4 : 2), percent_text(a.area_error, 3),
                        millimetres(a.perimeter), percent_text(a.perimeter_error, 3)),
            fmt::format("Strain along the warp {} to {}, the weft {} to {} (limit ±{})  ·  shear up to {} (limit {})",
                        percent_text(a.warp_strain_min), percent_text(a.warp_strain_max),
                        percent_text(a.weft_strain_min), percent_text(a.weft_strain_max), limit,
                        degrees_text(a.shear_max, 2), degrees_text(limits.shear, 1)),
            fmt::format("{}; grain: {}; {} triangles{}; {}", source.plan.fabric_of(tile.tile).name,
                        tile.tile.grain.source, page_figure(tile.tile.mesh.triangle_count(), 0),
                        tile.tile.remeshed ? " (remeshed)" : "", tile.method)};
}

/// The mate of each edge of a tile: `S12 to G02P03: 1200.0 mm, its mate 1200.1 mm (−0.10 mm)`.
std::vector<std::string> sewn_edges(const CutPlan& plan, std::size_t tile) {
    std::vector<std::pair<int, std::string>> edges;
    for (std::size_t i = 0; i < plan.walks.size(); ++i)
        for (const bool is_b : {false, true}) {
            const Seam& seam = plan.seams[i];
            const SeamSide &own = is_b ? seam.b : seam.a, &mate = is_b ? seam.a : seam.b;
            if (own.tile != static_cast<int>(tile) || own.parts.empty()) continue;
            const double here = is_b ? plan.walks[i].flat_b : plan.walks[i].flat_a;
            const double there = is_b ? plan.walks[i].flat_a : plan.walks[i].flat_b;
            edges.emplace_back(own.parts.front().edge,
                               seam.id + " to " + plan.tiles[static_cast<std::size_t>(mate.tile)].tile.name + ": " +
                                   millimetres(here) + ", its mate " + millimetres(there) + " (" +
                                   millimetres(here - there, 2, true) + ")");
        }
    std::stable_sort(edges.begin(), edges.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::string> lines;
    for (auto& [edge, line] : edges) lines.push_back(std::move(line));
    return lines;
}

/// The map `id`, or the edge error if there are no strains.
const MapView& strain_view(const PieceSource& source, std::size_t tile, std::string_view id) {
    const auto warp =
        std::find_if(source.maps.begin(), source.maps.end(), [](const auto& view) { return view.map->id == "warp"; });
    const bool is_strained = warp != source.maps.end() && warp->cloth[tile].size() > 0;
    return view_of(source.maps, is_strained ? id : "edges");
}

/// The height of a drawn piece that is at most `width` wide and `tallest` high.
double drawn_height(const Vec2& size, double width, double tallest) {
    const double scale = std::min(width / std::max(size.x(), 1e-9), tallest / std::max(size.y(), 1e-9));
    return std::max(140.0, scale * size.y()) + 40;
}

/// A chart of the distance between the sides along the seam, with the limit, in a box at `at`.
std::string drift_chart(const SeamWalk& walk, const std::string& second, const Vec2& at, double width) {
    constexpr double half = 44;
    double top = std::max(walk.limit, walk.drift_max);
    for (const MatchMark& notch : walk.notches) top = std::max(top, std::abs(notch.drift));
    top = std::isfinite(top) && top > 0 ? 1.15 * top : 1;
    const auto place = [&](double s, double drift) {
        return Vec2(at.x() + s / walk.length * width, at.y() + half - drift / top * half);
    };
    std::vector<Vec2> points{place(0, 0)};
    std::string dots;
    for (const MatchMark& notch : walk.notches) {
        points.push_back(place(notch.at, notch.drift));
        dots += "<circle cx=\"" + svg_number(points.back().x()) + "\" cy=\"" + svg_number(points.back().y()) +
                "\" r=\"2.5\" fill=\"" + page_ink + "\"/>\n";
    }
    points.push_back(place(walk.length, walk.mismatch()));
    const double band = walk.limit / top * half;
    std::string svg = "<rect x=\"" + svg_number(at.x()) + "\" y=\"" + svg_number(at.y() + half - band) + "\" width=\"" +
                      svg_number(width) + "\" height=\"" + svg_number(2 * band) + "\" fill=\"#dcefe5\"/>\n";
    svg += svg_stroke({place(0, 0), place(walk.length, 0)}, "#77838f", 1);
    svg += svg_stroke(points, walk.ok ? page_good : page_bad, 2) + dots;
    svg += text_within(at + Vec2(0, 2 * half + 16),
                       "How far " + second +
                           " is ahead along the seam, from its start (the ring) on, from notch to notch; green: "
                           "what is allowed, ±" +
                           millimetres(walk.limit, 2),
                       width - 160, {12, "start", page_soft});
    return svg + svg_text(at + Vec2(width, 2 * half + 16), millimetres(walk.mismatch(), 2, true) + " at its end",
                          {12, "end", walk.ok ? page_good : page_bad, true});
}

std::vector<std::string> seam_figures(const CutPlan& plan, std::size_t i) {
    const Seam& seam = plan.seams[i];
    const SeamWalk& walk = plan.walks[i];
    const auto name = [&](const SeamSide& s) { return plan.tiles[static_cast<std::size_t>(s.tile)].tile.name; };
    std::vector<std::string> lines{
        fmt::format("As drawn {}  ·  on {}, edge {}: {}  ·  on {}, edge {}: {}", millimetres(walk.length), name(seam.a),
                    seam.a.chain + 1, millimetres(walk.flat_a), name(seam.b), seam.b.chain + 1,
                    millimetres(walk.flat_b)),
        fmt::format("Mismatch {} ({})  ·  farthest apart {} at {}, allowed {}  ·  sewn {}, allowance {} and {}\u00a0mm",
                    millimetres(walk.mismatch(), 2, true), percent_text(walk.mismatch_ratio(), 3),
                    millimetres(walk.drift_max, 2), millimetres(walk.drift_max_at, 0), millimetres(walk.limit, 2),
                    seam.type.name, short_figure(seam.allowance(seam.a) / millimetre),
                    short_figure(seam.allowance(seam.b) / millimetre))};
    if (!walk.is_certain())
        lines.push_back("The meshes leave " + millimetres(walk.uncertainty, 2) +
                        " of its length uncertain; finer meshes would make it certain.");
    return lines;
}

}  // namespace

const MapView& telling_map(const PieceSource& source, std::size_t tile) {
    for (const Finding& finding : source.plan.tiles[tile].verdict.findings)
        for (const auto& [code, map] : {std::pair{"warp_strain", "warp"},
                                        {"weft_strain", "weft"},
                                        {"shear", "shear"},
                                        {"area", "area"},
                                        {"chain", "edges"},
                                        {"perimeter", "edges"}})
            if (finding.code == code) return strain_view(source, tile, map);
    return strain_view(source, tile, "warp");
}

std::string tile_png(const PieceSource& source, std::size_t i) {
    constexpr double width = 1000, tallest = 560, room = width - 2 * card_margin;
    constexpr std::size_t most_findings = 3, rows = 4;
    const FlatTile& tile = source.plan.tiles[i];
    std::vector<std::string> wrong;
    for (const Finding& finding : tile.verdict.findings) wrong.push_back(finding.message);
    std::string svg = head(width, tile.tile.name, tile_word(tile), tile.verdict.manufacturable());
    double y = 70;
    const TextStyle text{13, "start", page_ink};
    svg += text_lines({card_margin, y}, wrong, most_findings, room, text);
    y += 13 * line_step * static_cast<double>(std::min(most_findings, wrong.size())) + (wrong.empty() ? 0 : 6);
    svg += text_lines({card_margin, y}, figures(source, i), 3, room, {12.5, "start", page_soft});
    y += 3 * 12.5 * line_step;

    const MapView& map = telling_map(source, i);
    const PieceSight sight{source.plan, i, source.pieces[i], map};
    const double height = drawn_height(piece_extent(tile, source.pieces[i]).size(), room - 32, tallest);
    const PieceView view = piece_view(sight, {card_margin, y}, {width - card_margin, y + height});
    svg += view.svg;
    y += height + 14;
    if (!view.pixels.empty())
        svg += map_legend({width / 2, y}, map) + scale_bar({card_margin, y + 34}, view.to_page.scale, 160);
    y += legend_size.y() + 20;

    const std::vector<std::string> sewn = sewn_edges(source.plan, i);
    const double column = room / 2;
    const auto half = static_cast<std::ptrdiff_t>(std::min(rows, (sewn.size() + 1) / 2));
    svg +=
        text_lines({card_margin, y}, {sewn.begin(), sewn.begin() + half}, rows, column - 10, {12, "start", page_ink});
    svg +=
        text_lines({card_margin + column, y}, {sewn.begin() + half, sewn.end()}, rows, column, {12, "start", page_ink});
    y += 12 * line_step * static_cast<double>(half);
    const Eigen::Vector2i size(static_cast<int>(width), static_cast<int>(y + 4));
    return png_picture(page_svg(size, svg), view.pixels);
}

std::string seam_png(const PieceSource& source, std::size_t i) {
    constexpr double width = 1200, tallest = 460, room = width - 2 * card_margin;
    const CutPlan& plan = source.plan;
    const Seam& seam = plan.seams[i];
    const SeamWalk& walk = plan.walks[i];
    std::vector<std::size_t> tiles{static_cast<std::size_t>(seam.a.tile)};
    if (seam.b.tile != seam.a.tile) tiles.push_back(static_cast<std::size_t>(seam.b.tile));
    const std::string between = tiles.size() == 1
                                    ? plan.tiles[tiles[0]].tile.name + " is sewn to itself"
                                    : plan.tiles[tiles[0]].tile.name + " to " + plan.tiles[tiles[1]].tile.name;
    std::string svg = head(width, "Seam " + seam.id + ": " + between, seam_word(walk), walk.ok);
    svg += text_lines({card_margin, 72}, seam_figures(plan, i), 3, room, {13, "start", page_ink});
    svg += drift_chart(walk, plan.tiles[tiles.back()].tile.name, {card_margin, 130}, room);
    const double top = 262, each = room / static_cast<double>(tiles.size());
    double height = 0, scale = std::numeric_limits<double>::infinity();  // one scale, so the pieces are comparable
    for (const std::size_t tile : tiles) {
        const Vec2 extent = piece_extent(plan.tiles[tile], source.pieces[tile]).size();
        height = std::max(height, drawn_height(extent, each - 60, tallest));
        scale = std::min(scale, fitting_scale(extent, {each - 14, drawn_height(extent, each - 60, tallest)}));
    }
    std::vector<PlacedPixels> pixels;
    const MapView& map = strain_view(source, tiles[0], "warp");
    for (std::size_t k = 0; k < tiles.size(); ++k) {
        const double left = card_margin + static_cast<double>(k) * each;
        PieceSight sight{plan, tiles[k], source.pieces[tiles[k]], map};
        sight.has_band = false;
        sight.seam = static_cast<int>(i);
        sight.scale = scale;
        const PieceView view = piece_view(sight, {left, top}, {left + each - 14, top + height});
        pixels.insert(pixels.end(), view.pixels.begin(), view.pixels.end());
        svg += text_within({left + each / 2 - 7, top - 4}, plan.tiles[tiles[k]].tile.name, each - 20,
                           {15, "middle", page_ink, true}) +
               view.svg;
    }
    if (!pixels.empty()) svg += scale_bar({card_margin, top + height + 48}, scale, 160);
    svg += map_legend({width / 2, top + height + 14}, map);
    const Eigen::Vector2i size(static_cast<int>(width), static_cast<int>(top + height + legend_size.y() + 24));
    return png_picture(page_svg(size, svg), pixels);
}

}  // namespace ripstop
