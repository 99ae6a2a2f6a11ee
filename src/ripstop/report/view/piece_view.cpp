#include "ripstop/report/view/piece_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "ripstop/base/text/units.h"
#include "ripstop/io/text/escape.h"
#include "ripstop/io/text/sheet.h"
#include "ripstop/mesh/boundary.h"
#include "ripstop/report/figures/figures.h"
#include "ripstop/report/figures/seam_drift.h"
#include "ripstop/report/view/page_colours.h"
#include "ripstop/report/view/page_drawing.h"
#include "ripstop/report/view/piece_marks.h"
#include "ripstop/report/view/raster.h"
#include "ripstop/tile/targets.h"

namespace ripstop {
namespace {

constexpr double cloth_pixels_per_unit = 2;
constexpr double ring_margin = 16;                          ///< space for rings and lines beyond the piece
constexpr double readable_letter = 5, largest_letter = 26;  ///< of letters [page units]

Pixels cloth_pixels(const PieceSight& sight, const PageView& view, const Vec2& upper_left, const Vec2& size) {
    const FlatTile& tile = sight.plan.tiles[sight.tile];
    Pixels pixels;
    pixels.width = static_cast<int>(std::ceil(cloth_pixels_per_unit * size.x()));
    pixels.height = static_cast<int>(std::ceil(cloth_pixels_per_unit * size.y()));
    pixels.colours.assign(static_cast<std::size_t>(pixels.width) * static_cast<std::size_t>(pixels.height), 0xffffff);
    const std::vector<std::uint16_t> places = cloth_places(sight.plan, sight.map, sight.tile);
    for (std::size_t t = 0; t < places.size(); ++t) {
        std::array<Vec3, 3> corners;
        for (int k = 0; k < 3; ++k) {
            const int vertex = tile.tile.mesh.triangles(static_cast<Eigen::Index>(t), k);
            const Vec2 at = cloth_pixels_per_unit * (view.at(tile.flattening.positions.row(vertex)) - upper_left);
            corners[static_cast<std::size_t>(k)] = Vec3(at.x(), at.y(), 0);
        }
        const std::uint32_t colour = page_colours()[places[t]];
        each_pixel(pixels.width, pixels.height, corners,
                   [&](int place, double) { pixels.colours[static_cast<std::size_t>(place)] = colour; });
    }
    return pixels;
}

std::vector<Vec2> on_page(const Points2& points, const PageView& view) {
    std::vector<Vec2> result;
    for (const auto& row : points.rowwise()) result.push_back(view.at(row));
    return result;
}

std::string stroke(const std::string& path, const std::string& colour, double width, const std::string& more = {}) {
    if (path.empty()) return {};
    return "<path fill=\"none\" stroke=\"" + colour + "\" stroke-width=\"" + svg_number(width) + "\" " + more +
           " d=\"" + path + "\"/>\n";
}

std::string edge_band(const PieceSight& sight, const PageView& view) {
    const FlatTile& tile = sight.plan.tiles[sight.tile];
    if (!sight.has_band || sight.map.edges.empty()) return {};
    const std::vector<std::uint16_t> edges = edge_places(sight.map, sight.tile);
    const std::vector<int> loop = closed(tile.tile.boundary);
    const std::vector<Vec2> points = on_page(tile.flattening.positions(loop, Eigen::all), view);
    std::map<std::uint16_t, std::string> paths;
    for (std::size_t i = 0; i < edges.size(); ++i) paths[edges[i]] += path_of({points[i], points[i + 1]});
    std::string svg = stroke(path_of(points), page_ink, 9);
    for (const auto& [place, path] : paths) {
        const bool is_beyond = place == page_places::above || place == page_places::below;
        svg += stroke(path, page_colour(place), is_beyond ? 8 : 6.5);
    }
    return svg;
}

std::string label(const Label& label, const PageView& view) {
    const double size = std::min(largest_letter, 1.35 * label.height * view.scale);
    if (size < readable_letter) return {};
    const Vec2 at = view.at(label.middle);
    const std::string place = svg_pair(at);
    return "<text x=\"" + svg_number(at.x()) + "\" y=\"" + svg_number(at.y() + 0.36 * size) + "\" font-size=\"" +
           svg_number(size) + "\" text-anchor=\"middle\" fill=\"" + page_ink +
           "\" fill-opacity=\"0.85\" transform=\"rotate(" + svg_number(-label.turn / degree) + " " + place +
           ")\" stroke=\"#ffffff\" stroke-opacity=\"0.85\" stroke-width=\"" + svg_number(0.2 * size) +
           "\" paint-order=\"stroke\">" + xml_text(label.text) + "</text>\n";
}

std::string piece_lines(const PatternPiece& piece, const PageView& view) {
    std::string notches, drawn;
    for (const PieceNotch& notch : piece.notches)
        for (const auto& [from, to] : notch.slits()) notches += path_of({view.at(from), view.at(to)});
    for (const DrawnLine& line : piece.lines) drawn += path_of(on_page(line.points, view));
    std::string svg = stroke(path_of(on_page(piece.outline(), view), true), page_ink, 1.5) +
                      stroke(path_of(on_page(piece.sew_line, view), true), page_ink, 1, "stroke-dasharray=\"5 3\"") +
                      stroke(notches, page_ink, 2.2, "stroke-linecap=\"round\"") +
                      stroke(drawn, "#57308a", 1, "stroke-dasharray=\"2 2\"");
    const std::vector<Vec2> arrow = on_page(grain_arrow(piece), view);
    if (arrow.size() == 4) {
        const Vec2 along = (arrow[1] - arrow[0]).normalized(), across(-along.y(), along.x());
        const double head = std::min(14.0, 0.2 * (arrow[1] - arrow[0]).norm());
        const Vec2 left = arrow[1] - head * along + 0.35 * head * across;
        const Vec2 right = arrow[1] - head * along - 0.35 * head * across;
        const std::string path = path_of({arrow[0], arrow[1]}) + path_of({left, arrow[1], right});
        svg += stroke(path, "#ffffff", 4, "stroke-opacity=\"0.55\"") + stroke(path, "#57308a", 1.6);
    }
    for (const Label& text : piece.labels) svg += label(text, view);
    return svg;
}

std::string proposed_seam(const FlatTile& tile, const PageView& view) {
    std::vector<Vec2> ends = proposed_ends(tile);
    for (Vec2& end : ends) end = view.at(end);
    const std::string path = path_of(ends);
    return stroke(path, "#ffffff", 6) + stroke(path, "#111111", 3, "stroke-dasharray=\"9 5\"");
}

std::string rings(const FlatTile& tile, const PageView& view) {
    std::string svg;
    for (const FindingMark& mark : finding_marks(tile)) {
        const Vec2 p = view.at(tile.flattening.positions.row(mark.vertex));
        for (const auto& [colour, width] : {std::pair{"#ffffff", "6"}, std::pair{page_bad, "2.5"}})
            svg += "<circle cx=\"" + svg_number(p.x()) + "\" cy=\"" + svg_number(p.y()) +
                   "\" r=\"12\" fill=\"none\" stroke=\"" + colour + "\" stroke-width=\"" + width + "\"/>\n";
    }
    return svg;
}

std::string chosen_seam(const PieceSight& sight, const PageView& view) {
    if (sight.seam < 0) return {};
    const FlatTile& tile = sight.plan.tiles[sight.tile];
    const Seam& seam = sight.plan.seams[static_cast<std::size_t>(sight.seam)];
    const std::vector<int> loop = closed(tile.tile.boundary);
    const Eigen::VectorXd drawn = drawn_lengths(tile.tile);
    std::string path, starts;
    for (const SeamSide* side : {&seam.a, &seam.b}) {
        if (side->tile != static_cast<int>(sight.tile) || side->parts.empty()) continue;
        std::vector<Vec2> points;
        for (std::size_t i = 0; i < side->parts.size(); ++i) {
            const auto edge = static_cast<std::size_t>(side->parts[i].edge);
            const auto [from, to] = share_of_edge(*side, i, drawn[side->parts[i].edge]);
            const Vec2 a = view.at(tile.flattening.positions.row(loop[edge])),
                       b = view.at(tile.flattening.positions.row(loop[edge + 1]));
            if (i == 0) points.push_back(a + from * (b - a));
            points.push_back(a + to * (b - a));
        }
        path += path_of(points);
        const Vec2 start = side == &seam.a ? points.front() : points.back();
        starts += "<circle cx=\"" + svg_number(start.x()) + "\" cy=\"" + svg_number(start.y()) +
                  "\" r=\"6\" fill=\"#ffffff\" stroke=\"" + page_chosen + "\" stroke-width=\"3\"/>\n";
    }
    return stroke(path, "#ffffff", 9) + stroke(path, page_chosen, 5) + starts;
}

}  // namespace

PieceExtent piece_extent(const FlatTile& tile, const PatternPiece* piece) {
    PieceExtent extent;
    if (tile.is_flat())
        extent = {tile.flattening.positions.colwise().minCoeff(), tile.flattening.positions.colwise().maxCoeff()};
    if (piece && piece->outline().rows() > 0) {
        extent.lower = extent.lower.cwiseMin(piece->lower());
        extent.upper = extent.upper.cwiseMax(piece->upper());
    }
    return extent;
}

double fitting_scale(const Vec2& size, const Vec2& room) {
    return (room - Vec2::Constant(2 * ring_margin)).cwiseQuotient(size.cwiseMax(1e-9)).minCoeff();
}

PieceView piece_view(const PieceSight& sight, const Vec2& upper_left, const Vec2& lower_right) {
    const FlatTile& tile = sight.plan.tiles[sight.tile];
    const Vec2 middle = (upper_left + lower_right) / 2;
    PieceView view;
    if (!tile.is_flat()) {
        view.svg = text_within(middle, "This tile could not be laid flat, so there is no piece.",
                               lower_right.x() - upper_left.x(), {16, "middle", page_bad});
        return view;
    }
    const PieceExtent extent = piece_extent(tile, sight.piece);
    view.to_page.scale = sight.scale > 0 ? sight.scale : fitting_scale(extent.size(), lower_right - upper_left);
    view.to_page.origin = middle;
    view.to_page.origin += middle - view.to_page.at((extent.lower + extent.upper) / 2);
    const Vec2 size = view.to_page.scale * extent.size();
    const Vec2 corner = (middle - size / 2).array().floor();
    view.pixels.push_back(
        {cloth_pixels(sight, view.to_page, corner, size + Vec2::Ones()), corner, cloth_pixels_per_unit});
    view.svg = edge_band(sight, view.to_page);
    if (sight.piece) view.svg += piece_lines(*sight.piece, view.to_page);
    view.svg += proposed_seam(tile, view.to_page);
    view.svg += sight.seam < 0 ? rings(tile, view.to_page) : chosen_seam(sight, view.to_page);
    return view;
}

}  // namespace ripstop
