#include "ripstop/report/picture/picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"
#include "ripstop/geometry/triangle.h"
#include "ripstop/mesh/boundary.h"
#include "ripstop/report/figures/cloth_map.h"
#include "ripstop/report/figures/colour_scale.h"
#include "ripstop/report/figures/figures.h"
#include "ripstop/report/view/drawing.h"

namespace ripstop {
namespace {

constexpr double figure_width = 960;
constexpr double head_height = 112;
constexpr double foot_height = 116;
constexpr double side_margin = 96;  ///< left and right of the drawing, for the figures at the chains
constexpr double border = 44;       ///< above and below it
constexpr double inner_width = figure_width - 2 * side_margin;
constexpr double tallest = 620;

struct View : PageView {
    double height = tallest;  ///< of the drawing

    double page_height() const { return head_height + height + 2 * border + foot_height; }
    double foot() const { return page_height() - foot_height; }
};

View fitted(const Points2& positions) {
    View view;
    const Vec2 lower = positions.colwise().minCoeff(), upper = positions.colwise().maxCoeff();
    const Vec2 size = (upper - lower).cwiseMax(1e-9);
    view.scale = std::min(inner_width / size.x(), tallest / size.y());
    view.height = std::max(90.0, view.scale * size.y());
    const Vec2 middle = (lower + upper) / 2;
    view.origin = Vec2(figure_width / 2 - view.scale * middle.x(),
                       head_height + border + view.height / 2 + view.scale * middle.y());
    return view;
}

/// A signed percentage with a true minus sign: a hyphen is easy to miss.
std::string signed_percent(double ratio, int decimals) {
    const std::string text = shown(ratio / percent, decimals, true);
    return text.front() == '-' && text.size() > 1 ? "−" + text.substr(1) : text;
}

std::vector<Vec2> on_page(const FlatTile& tile, const View& view, const std::vector<int>& vertices) {
    std::vector<Vec2> points;
    for (const int v : vertices) points.push_back(view.at(tile.flattening.positions.row(v)));
    return points;
}

/// The middle of a line, and the direction away from the cloth there: to the right of the line, with y up.
struct Halfway {
    Vec2 at = Vec2::Zero();
    Vec2 outward = Vec2::UnitY();
};
Halfway halfway(const std::vector<Vec2>& points) {
    double total = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) total += (points[i + 1] - points[i]).norm();
    double left = total / 2;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const Vec2 step = points[i + 1] - points[i];
        const double length = step.norm();
        if (length > 0 && left <= length) return {points[i] + left / length * step, Vec2(-step.y(), step.x()) / length};
        left -= length;
    }
    return {};
}

/// Prevents written figures from overlapping.
class Writing {
  public:
    bool is_free(const Vec2& middle, const Vec2& half) const {
        return std::all_of(taken_.begin(), taken_.end(), [&](const std::array<Vec2, 2>& other) {
            return ((middle - other[0]).cwiseAbs().array() >= (half + other[1]).array()).any();
        });
    }
    void take(const Vec2& middle, const Vec2& half) { taken_.push_back({middle, half}); }

  private:
    std::vector<std::array<Vec2, 2>> taken_;
};

std::string chain_figure(const Halfway& place, double error, bool beyond, Writing& writing) {
    const std::string figure = signed_percent(error, 3) + " %";
    const Vec2 half(4.3 * static_cast<double>(figure.size()), 8);
    double away = 12;
    const auto middle = [&] { return Vec2(place.at + away * place.outward + place.outward.cwiseProduct(half)); };
    while (away < 60 && !writing.is_free(middle(), half)) away += 8;
    writing.take(middle(), half);
    const TextStyle style{14, "middle", beyond ? "#b3121f" : "#1f2933", true, true};
    std::string result;
    if (away > 12)
        result = "<path stroke=\"#7b8794\" stroke-width=\"1\" d=\"M" + svg_pair(place.at + 4 * place.outward) + "L" +
                 svg_pair(place.at + (away - 2) * place.outward) + "\"/>\n";
    return result + svg_text(middle() + Vec2(0, 5), figure, style);
}

/// The ease map: a stroke outward from each boundary edge, proportional to its tension; blue if the seam is pulled,
/// amber if it is pushed. The longest stroke is `longest_tension` on the page.
std::string tensions(const FlatTile& tile, const View& view) {
    constexpr double longest_tension = 26;
    const Eigen::VectorXd& tension = tile.flattening.seam_tension;
    if (tension.size() == 0) return {};
    const double largest = tension.lpNorm<Eigen::Infinity>();
    if (!(largest > 0) || !std::isfinite(largest)) return {};
    const std::vector<Vec2> points = on_page(tile, view, closed(tile.tile.boundary));
    std::string pulled, pushed;
    for (Eigen::Index i = 0; i < tension.size(); ++i) {
        const Vec2 a = points[static_cast<std::size_t>(i)], b = points[static_cast<std::size_t>(i) + 1];
        const Vec2 along = (b - a).normalized(), middle = (a + b) / 2;
        const Vec2 outward(-along.y(), along.x());
        const Vec2 from = middle + 4 * outward, to = from + longest_tension * std::abs(tension[i]) / largest * outward;
        (tension[i] > 0 ? pulled : pushed) += "M" + svg_pair(from) + "L" + svg_pair(to);
    }
    const auto strokes = [](const std::string& path, const char* colour) {
        return path.empty() ? std::string()
                            : "<path fill=\"none\" stroke=\"" + std::string(colour) + "\" stroke-width=\"2\" d=\"" +
                                  path + "\"/>\n";
    };
    return strokes(pulled, "#5b8def") + strokes(pushed, "#e0a030");
}

std::string chains(const FlatTile& tile, const View& view, double limit) {
    const std::vector<Chain>& chains = tile.tile.chains;
    const bool measured = tile.accuracy.chains.size() == chains.size();
    std::string casing, lines, corners, figures;
    Writing writing;
    for (std::size_t i = 0; i < chains.size(); ++i) {
        const std::vector<Vec2> points = on_page(tile, view, chains[i].vertices);
        if (points.size() < 2) continue;
        const double error = measured ? tile.accuracy.chains[i].error() : 0;
        const int colour = colour_class(error, limit);
        casing += svg_stroke(points, "#1f2933", 7);
        lines += svg_stroke(points, measured ? class_colour(colour) : "#9aa5b1", 4.4);
        if (chains.size() > 1)
            corners += "<circle cx=\"" + svg_number(points.front().x()) + "\" cy=\"" + svg_number(points.front().y()) +
                       "\" r=\"4\" fill=\"#ffffff\" stroke=\"#1f2933\" stroke-width=\"1.5\"/>\n";
        if (measured) figures += chain_figure(halfway(points), error, colour == beyond_class, writing);
    }
    return casing + lines + corners + figures;
}

/// Findings have places on the surface; each is marked at the nearest vertex.
std::string rings(const FlatTile& tile, const View& view) {
    std::string result;
    for (const Finding& finding : tile.verdict.findings) {
        if (!finding.at.allFinite()) continue;
        Eigen::Index nearest = 0;
        (tile.tile.mesh.positions.rowwise() - finding.at.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
        const Vec2 p = view.at(tile.flattening.positions.row(nearest));
        for (const auto& [colour, width] : {std::pair{"#ffffff", 5}, std::pair{"#b3121f", 2}})
            result += "<circle cx=\"" + svg_number(p.x()) + "\" cy=\"" + svg_number(p.y()) +
                      "\" r=\"11\" fill=\"none\" stroke=\"" + colour + "\" stroke-width=\"" + std::to_string(width) +
                      "\"/>\n";
    }
    return result;
}

std::string head(const FlatTile& tile) {
    const Accuracy& a = tile.accuracy;
    const bool good = tile.verdict.manufacturable();
    const std::string verdict = good                  ? "manufacturable"
                                : tile.verdict.judged ? "not manufacturable: " + failing_codes(tile.verdict)
                                                      : "not judged";
    const std::string lengths = "area " + signed_percent(a.area_error, 3) + " %   ·   perimeter " +
                                signed_percent(a.perimeter_error, 3) + " %   ·   worst chain " +
                                signed_percent(worst_chain_error(a), 3) + " %";
    const std::string strains = "strain of the cloth: warp " + signed_percent(a.warp_strain_min, 2) + " … " +
                                signed_percent(a.warp_strain_max, 2) + " %,  weft " +
                                signed_percent(a.weft_strain_min, 2) + " … " + signed_percent(a.weft_strain_max, 2) +
                                " %,  shear up to " + shown(a.shear_max / degree, 2) + "°";
    const char* colour = good ? "#18794e" : tile.verdict.judged ? "#b3121f" : "#7b8794";
    const Eigen::VectorXd& tension = tile.flattening.seam_tension;
    const std::string ease =
        tension.size() == 0
            ? ""
            : "tension of the seams (strokes; blue pulled, amber pushed): " + shown(tension.minCoeff(), 1) + " … " +
                  shown(tension.maxCoeff(), 1) + " N";
    return svg_text({28, 40}, tile.tile.name, {24, "start", "#1f2933", true}) +
           svg_text({figure_width - 28, 40}, verdict, {17, "end", colour, true}) +
           svg_text({28, 68}, lengths, {14, "start", "#1f2933"}) +
           svg_text({28, 90}, strains, {14, "start", "#52606d"}) +
           (ease.empty() ? "" : svg_text({28, 110}, ease, {12, "start", "#52606d"})) +
           svg_text({figure_width - 28, 68}, tile.method, {14, "end", "#52606d"}) +
           svg_text({figure_width - 28, 90}, std::to_string(tile.tile.mesh.triangle_count()) + " triangles",
                    {14, "end", "#52606d"});
}

std::string warp_arrow(const Vec2& at) {
    const Vec2 head = at + Vec2(70, 0);
    return "<path fill=\"none\" stroke=\"#1f2933\" stroke-width=\"1.5\" d=\"M" + svg_pair(at) + "H" +
           svg_number(head.x()) + "M" + svg_pair(head + Vec2(-10, -4)) + "L" + svg_pair(head) + "l-10 4\"/>\n" +
           svg_text(head + Vec2(8, 5), "warp", {13, "start", "#1f2933"});
}

std::string foot(const View& view, double cloth_limit, double length_limit) {
    const double y = view.foot();
    return "<path stroke=\"#cbd2d9\" stroke-width=\"1\" d=\"M28 " + svg_number(y) + "H" +
           svg_number(figure_width - 28) + "\"/>\n" +
           colour_bar({36, y + 42}, "seams: |length error| of a chain", length_limit / percent, "%") +
           colour_bar({356, y + 42}, "cloth: |edge length error|, mean of a triangle", cloth_limit / percent, "%") +
           warp_arrow({690, y + 34}) + scale_bar({690, y + 84}, view.scale, 0.2 * figure_width);
}

}  // namespace

std::string tile_picture(const FlatTile& tile, const Tolerances& tolerances, const PictureOptions& options) {
    const bool drawable = tile.is_flat();
    const View view = drawable ? fitted(tile.flattening.positions) : View{{}, 90};
    const std::string size = format_fixed(figure_width, 0) + "\" height=\"" + svg_number(view.page_height());
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + size + "\" viewBox=\"0 0 " +
                      format_fixed(figure_width, 0) + " " + svg_number(view.page_height()) +
                      "\" font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\">\n<rect width=\"" + size +
                      "\" fill=\"#ffffff\"/>\n" + head(tile);
    if (drawable) {
        const double cloth_limit = options.cloth_limit > 0 ? options.cloth_limit : tolerances.strain;
        svg += cloth_map(tile, view, cloth_limit) + tensions(tile, view) + chains(tile, view, tolerances.length) +
               rings(tile, view) + foot(view, cloth_limit, tolerances.length);
    } else {
        svg += svg_text({figure_width / 2, head_height + border + 45},
                        "no flat positions: " + tile.flattening.summary.text(), {17, "middle", "#b3121f"});
    }
    return svg + "</svg>\n";
}

}  // namespace ripstop
