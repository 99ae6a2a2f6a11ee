#include "ripstop/report/picture/seam_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"
#include "ripstop/geometry/polygon.h"
#include "ripstop/report/figures/colour_scale.h"
#include "ripstop/report/figures/figures.h"
#include "ripstop/report/figures/seam_drift.h"
#include "ripstop/report/tables/seam_tables.h"
#include "ripstop/report/view/drawing.h"
#include "ripstop/tile/targets.h"

namespace ripstop {
namespace {

constexpr double sheet_width = 1200;
constexpr double seam_margin = 28;
constexpr double sheet_head = 92;
constexpr double sheet_foot = 104;

/// The scale of the page and the place of each tile on it.
struct SheetLayout {
    double scale = 1;           ///< page units per metre
    double height = 0;          ///< of the drawing
    std::vector<Vec2> origins;  ///< origin of each tile's flat coordinates, on the page

    Vec2 at(std::size_t tile, const Vec2& p) const { return origins[tile] + scale * Vec2(p.x(), -p.y()); }
};

struct Extent {
    Vec2 lower = Vec2::Zero(), upper = Vec2::Zero();
    Vec2 size() const { return upper - lower; }
};

SheetLayout lay_out(const std::vector<Extent>& extents) {
    double total = 0, widest = 0, largest = 0;
    for (const Extent& extent : extents) largest = std::max(largest, extent.size().maxCoeff());
    const double gap = std::max(0.08 * largest, 1e-9);
    for (const Extent& extent : extents) {
        total += (extent.size().x() + gap) * (extent.size().y() + gap);
        widest = std::max(widest, extent.size().x());
    }
    // One and a half times as wide as high; rows are not full.
    const double sheet = std::max(widest, 1.3 * std::sqrt(total));
    SheetLayout layout;
    double x = 0, top = 0, row = 0, reached = 0;
    for (const Extent& extent : extents) {
        if (x > 0 && x + extent.size().x() > sheet) {
            top += row + gap;
            x = row = 0;
        }
        layout.origins.emplace_back(x - extent.lower.x(), top + extent.upper.y());
        x += extent.size().x() + gap;
        row = std::max(row, extent.size().y());
        reached = std::max(reached, x - gap);
    }
    layout.scale = std::min((sheet_width - 2 * seam_margin) / std::max(reached, 1e-9), 900 / std::max(top + row, 1e-9));
    layout.scale = std::max(layout.scale, (sheet_width - 2 * seam_margin) / std::max(reached, 1e-9) / 2);
    layout.height = layout.scale * (top + row);
    for (Vec2& origin : layout.origins) origin = layout.scale * origin + Vec2(seam_margin, sheet_head + 14);
    return layout;
}

Extent extent_of(const FlatTile& tile) {
    if (!tile.is_flat()) return {};
    const Points2 outline = tile.flattening.positions(tile.tile.boundary, Eigen::all);
    return {outline.colwise().minCoeff(), outline.colwise().maxCoeff()};
}

struct Strokes {
    std::array<std::string, colour_classes> paths;
    std::string figures;
    std::vector<std::array<Vec2, 2>> taken;  ///< texts already placed: middle and half size of each

    /// Reserves space for a text. Returns false if there is none.
    bool take(const Vec2& middle, const Vec2& half) {
        for (const std::array<Vec2, 2>& other : taken)
            if (((middle - other[0]).cwiseAbs().array() < (half + other[1]).array()).all()) return false;
        taken.push_back({middle, half});
        return true;
    }
};

/// Writes by how much the edge is longer than its mate, if there is space on the cloth beside it. The text of a failing
/// edge may cover others.
void write_figure(const CutPlan& plan, std::size_t seam, bool is_b, const SheetLayout& layout,
                  const std::vector<std::array<Vec2, 2>>& steps, double on_page, Strokes& strokes) {
    const SeamWalk& walk = plan.walks[seam];
    const auto t = static_cast<std::size_t>(is_b ? plan.seams[seam].b.tile : plan.seams[seam].a.tile);
    const double mismatch = (is_b ? 1 : -1) * walk.mismatch() / millimetre;
    const std::string figure = shown(mismatch, std::abs(mismatch) < 0.1 ? 3 : std::abs(mismatch) < 10 ? 2 : 1, true);
    if (on_page < 7.5 * static_cast<double>(figure.size())) return;
    const Points2 outline = plan.tiles[t].flattening.positions(plan.tiles[t].tile.boundary, Eigen::all);
    const Vec2 room(2.8 * static_cast<double>(figure.size()), 5);
    const auto place_beside = [&](std::size_t step) {
        const Vec2 along = (steps[step][1] - steps[step][0]).normalized();
        const Vec2 inward(along.y(), -along.x());  // the cloth lies to the left, with y up
        return Vec2(steps[step][0] + 16 * inward.cwiseProduct(Vec2(1.2, 0.8)));
    };
    const std::size_t n = steps.size();
    const auto is_free = [&](const Vec2& place) {
        const Vec2 on_cloth = (place - layout.origins[t]).cwiseProduct(Vec2(1, -1)) / layout.scale;
        return contains(outline, Box{on_cloth, room / layout.scale}) && strokes.take(place, room);
    };
    Vec2 place = place_beside(n / 2);
    bool found = is_free(place);
    for (const std::size_t step : {n / 4, 3 * n / 4}) {
        if (found) break;
        found = is_free(place_beside(step));
        if (found) place = place_beside(step);
    }
    if (found || !walk.ok)
        strokes.figures +=
            svg_text(place + Vec2(0, 3.5), figure, {10, "middle", walk.ok ? "#1f2933" : "#b3121f", !walk.ok, true});
}

void draw_side(const CutPlan& plan, std::size_t seam, bool is_b, const SheetLayout& layout, Strokes& strokes) {
    const SeamSide& run = is_b ? plan.seams[seam].b : plan.seams[seam].a;
    const SeamWalk& walk = plan.walks[seam];
    const auto t = static_cast<std::size_t>(run.tile);
    const FlatTile& tile = plan.tiles[t];
    if (!tile.is_flat()) return;
    const Eigen::VectorXd drawn = drawn_lengths(tile.tile);
    const std::vector<int>& loop = tile.tile.boundary;
    const auto corner = [&](int edge) {
        const int vertex = loop[static_cast<std::size_t>(edge) % loop.size()];
        return layout.at(t, tile.flattening.positions.row(vertex));
    };
    int last_class = -1;
    double walked = 0, on_page = 0;
    std::vector<std::array<Vec2, 2>> steps;
    for (std::size_t i = 0; i < run.parts.size(); ++i) {
        const SeamPart& part = run.parts[i];
        const auto [from, to] = share_of_edge(run, i, drawn[part.edge]);
        const Vec2 a = corner(part.edge), b = corner(part.edge + 1);
        steps.push_back({a + from * (b - a), a + to * (b - a)});
        const double middle = walked + part.length / 2;
        const int now = colour_class(drift_at(walk, is_b ? walk.length - middle : middle), walk.limit);
        std::string& path = strokes.paths[static_cast<std::size_t>(now)];
        if (now != last_class) path += "M" + svg_pair(steps.back()[0]);
        path += "L" + svg_pair(steps.back()[1]);
        last_class = now;
        walked += part.length;
        on_page += (steps.back()[1] - steps.back()[0]).norm();
    }
    if (on_page > 0) write_figure(plan, seam, is_b, layout, steps, on_page, strokes);
}

std::string outlines(const CutPlan& plan, const SheetLayout& layout, Strokes& strokes) {
    std::string path, names;
    for (std::size_t t = 0; t < plan.tiles.size(); ++t) {
        const FlatTile& tile = plan.tiles[t];
        if (!tile.is_flat()) continue;
        const char* step = "M";
        for (const int v : tile.tile.boundary) {
            path += step + svg_pair(layout.at(t, tile.flattening.positions.row(v)));
            step = "L";
        }
        path += "z";
        const Extent extent = extent_of(tile);
        const double letters = std::max(1.0, static_cast<double>(tile.tile.name.size()));
        const double size =
            std::min({13.0, layout.scale * extent.size().x() / letters / 0.9, layout.scale * extent.size().y() / 2.2});
        if (size < 5) continue;
        const Vec2 middle = layout.at(t, (extent.lower + extent.upper) / 2);
        strokes.take(middle, Vec2(0.31 * size * letters, size / 2));
        names += svg_text(middle + Vec2(0, size / 3), tile.tile.name, {size, "middle", "#7b8794"});
    }
    return "<path fill=\"#f5f7fa\" stroke=\"#9aa5b1\" stroke-width=\"1\" d=\"" + path + "\"/>\n" + names;
}

std::string head(const CutPlan& plan) {
    std::string summary = seams_summary(plan, 0);
    summary = summary.substr(0, summary.find('\n'));
    const bool good = plan.findings.empty();
    const std::string title = "Seams" + (plan.input_file.empty() ? std::string() : " of " + plan.input_file);
    return svg_text({seam_margin, 40}, title, {24, "start", "#1f2933", true}) +
           svg_text({sheet_width - seam_margin, 40}, good ? "every seam agrees" : "some seams do not agree",
                    {17, "end", good ? "#18794e" : "#b3121f", true}) +
           svg_text({seam_margin, 68}, summary, {14, "start", "#1f2933"});
}

std::string foot(const CutPlan& plan, const SheetLayout& layout, double y) {
    return "<path stroke=\"#cbd2d9\" stroke-width=\"1\" d=\"M28 " + svg_number(y) + "H" +
           svg_number(sheet_width - seam_margin) + "\"/>\n" +
           colour_bar({36, y + 42}, "sewn edges: distance between the two sides per metre of seam",
                      plan.tolerances.length / millimetre, "mm") +
           svg_text({560, y + 34}, "figures: this edge minus its mate, mm; red and thick: beyond the tolerance",
                    {13, "start", "#1f2933"}) +
           svg_text({560, y + 54}, "grey: not sewn", {13, "start", "#52606d"}) +
           scale_bar({1000, y + 71}, layout.scale, 150);
}

}  // namespace

std::string seam_picture(const CutPlan& plan) {
    if (plan.walks.empty()) return {};
    std::vector<Extent> extents;
    for (const FlatTile& tile : plan.tiles) extents.push_back(extent_of(tile));
    const SheetLayout layout = lay_out(extents);
    Strokes strokes;
    const std::string tiles = outlines(plan, layout, strokes);
    for (std::size_t i = 0; i < plan.walks.size(); ++i)
        for (const bool is_b : {false, true}) draw_side(plan, i, is_b, layout, strokes);
    const double foot_at = sheet_head + layout.height + 28, page_height = foot_at + sheet_foot;
    const std::string size = format_fixed(sheet_width, 0) + "\" height=\"" + svg_number(page_height);
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + size + "\" viewBox=\"0 0 " +
                      format_fixed(sheet_width, 0) + " " + svg_number(page_height) +
                      "\" font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\">\n<rect width=\"" + size +
                      "\" fill=\"#ffffff\"/>\n" + head(plan) + tiles;
    for (int c = 0; c < colour_classes; ++c) {
        const std::string& path = strokes.paths[static_cast<std::size_t>(c)];
        if (path.empty()) continue;
        svg += "<path fill=\"none\" stroke=\"" + class_colour(c) + "\" stroke-width=\"" +
               (c == beyond_class ? "5" : "2.6") + "\" stroke-linecap=\"round\" stroke-linejoin=\"round\" d=\"" + path +
               "\"/>\n";
    }
    return svg + strokes.figures + foot(plan, layout, foot_at) + "</svg>\n";
}

}  // namespace ripstop
