#include "ripstop/report/picture/envelope_png.h"

#include <algorithm>

#include "ripstop/base/parallel.h"
#include "ripstop/report/view/page_drawing.h"
#include "ripstop/report/words/page_words.h"

namespace ripstop {
namespace {

constexpr double page_width = 1600, side = 36;
constexpr int view_side = 740;
constexpr int view_pixels_per_unit = 2;
constexpr std::size_t most_lines_shown = 5, most_names = 10;

/// The positions of the page's parts, from the top.
struct Layout {
    double views = 0, foot = 0, height = 0;
};

Layout lay_out(const PageWords& words) {
    const std::size_t lines = std::min(most_lines_shown, std::max(words.why.size(), words.redesign.size()));
    Layout layout;
    layout.views = lines == 0 ? 100 : 134 + 14 * line_step * static_cast<double>(lines);
    layout.foot = layout.views + view_side + 34;
    layout.height = layout.foot + legend_size.y() + 16;
    return layout;
}

std::string head(const CutPlan& plan, const PageWords& words) {
    const bool is_good = plan.manufacturable();
    std::string file = plan.input_file.empty() ? "Envelope" : plan.input_file;
    for (const Fabric& fabric : plan.fabrics()) file += " · " + fabric.name;
    const double room = page_width - 2 * side, column = room / 2 - 20;
    std::string svg = "<rect width=\"" + svg_number(page_width) + "\" height=\"6\" fill=\"" +
                      (is_good ? page_good : page_bad) + "\"/>\n" +
                      text_within({side, 32}, file, room, {14, "start", page_soft});
    svg += svg_text({side, 66}, words.word, {25, "start", is_good ? page_good : page_bad, true});
    const double start = side + text_width(words.word, 25, true) + 6;
    svg += text_within({start, 66}, words.headline, page_width - side - start, {20, "start", page_ink});
    const TextStyle title{14, "start", page_ink, true}, text{14, "start", page_ink};
    const bool is_redesigned = !words.redesign.empty();
    const double width = is_redesigned ? column : room;
    if (!words.why.empty())
        svg += svg_text({side, 98}, "Why", title) +
               text_lines({side, 121}, plain(words.why), most_lines_shown, width, text);
    const double right = words.why.empty() ? side : side + column + 40;
    if (is_redesigned)
        svg += svg_text({right, 98}, "What to redesign", title) +
               text_lines({right, 121}, plain(words.redesign), most_lines_shown, column, text);
    return svg;
}

/// Keeps texts that do not overlap.
class Names {
  public:
    bool take(const Vec2& middle, const Vec2& half) {
        for (const auto& [other, other_half] : taken_)
            if (((middle - other).cwiseAbs().array() < (half + other_half).array()).all()) return false;
        taken_.emplace_back(middle, half);
        return true;
    }
    std::size_t count() const { return taken_.size(); }

  private:
    std::vector<std::pair<Vec2, Vec2>> taken_;
};

/// The names of failing tiles whose middles are visible.
std::string names(const CutPlan& plan, const EnvelopeShape& shape, const EnvelopeView& view, const Vec2& corner) {
    Names written;
    std::string svg;
    int first = 0;
    for (std::size_t i = 0; i < plan.tiles.size() && written.count() < most_names; ++i) {
        const FlatTile& tile = plan.tiles[i];
        const int next = first + tile.tile.mesh.triangle_count();
        const Vec3 middle = view.at(shape.positions[i].colwise().mean().transpose());
        const auto place = static_cast<std::size_t>(middle.y()) * static_cast<std::size_t>(view.side) +
                           static_cast<std::size_t>(middle.x());
        const bool is_seen = place < view.cloth.size() && view.cloth[place] >= first && view.cloth[place] < next;
        first = next;
        if (tile.verdict.manufacturable() || !is_seen) continue;
        const Vec2 at = corner + middle.head<2>() / view_pixels_per_unit;
        const std::string& name = tile.tile.name;
        constexpr double size = 15, longest = 220;
        const Vec2 half(std::min(longest, text_width(name, size, true)) / 2, 0.7 * size);
        if (!written.take(at, half)) continue;
        svg += text_within(at + Vec2(0, 0.36 * size), name, longest, {size, "middle", page_bad, true, true});
    }
    return svg;
}

std::string key(const Vec2& at, const CutPlan& plan) {
    const bool is_good = plan.manufacturable();
    const bool is_proposed =
        std::any_of(plan.tiles.begin(), plan.tiles.end(), [](const auto& tile) { return tile.proposal.has_value(); });
    const auto entry = [&](double y, const std::string& line, const std::string& words) {
        return "<path fill=\"none\" " + line + " d=\"M" + svg_pair(at + Vec2(0, y)) + "h40\"/>\n" +
               svg_text(at + Vec2(50, y + 5), words, {13, "start", page_ink});
    };
    std::string svg;
    if (!is_good) svg += entry(8, "stroke=\"#a50f2d\" stroke-width=\"2.5\"", "cannot be made, does not fit");
    if (is_proposed)
        svg += entry(32, "stroke=\"#111111\" stroke-width=\"3\" stroke-dasharray=\"9 5\"", "a seam that would help");
    return svg;
}

}  // namespace

EnvelopeSights see_envelope(const CutPlan& plan, int threads, bool is_inflated) {
    EnvelopeSights sights{envelope_shape(plan, is_inflated), {}};
    const std::array directions{home_direction, Vec3(-home_direction.x(), home_direction.y(), -home_direction.z())};
    for (std::size_t k = 0; k < 2; ++k)
        sights.views[k] = aimed_view(sights.shape, directions[k], view_pixels_per_unit * view_side);
    const double scale = std::min(sights.views[0].pixels_per_metre, sights.views[1].pixels_per_metre);
    parallel_for(2, threads, [&](int i) {
        EnvelopeView& view = sights.views[static_cast<std::size_t>(i)];
        view.pixels_per_metre = scale;
        paint_envelope(view, plan, sights.shape, view_pixels_per_unit);
    });
    return sights;
}

std::string envelope_png(const CutPlan& plan, const EnvelopeSights& sights, const MapView& map) {
    const PageWords words = page_words(plan);
    const Layout layout = lay_out(words);
    std::string svg = head(plan, words);
    std::vector<PlacedPixels> pixels;
    for (const bool is_back : {false, true}) {
        const EnvelopeView& view = sights.views[is_back ? 1 : 0];
        const double gap = (page_width - 2 * view_side) / 4;
        const Vec2 corner(gap + (is_back ? page_width / 2 : 0), layout.views);
        pixels.push_back({coloured(view, plan, map), corner, view_pixels_per_unit});
        svg += svg_text(corner + Vec2(view_side / 2.0, view_side + 18), is_back ? "from the back" : "from the front",
                        {13, "middle", page_soft});
        svg += names(plan, sights.shape, view, corner);
    }
    svg += map_legend({page_width / 2, layout.foot}, map);
    svg += scale_bar({side, layout.foot + 34}, sights.views[0].pixels_per_metre / view_pixels_per_unit, 300);
    svg += key({page_width - 330, layout.foot + 18}, plan);
    const Eigen::Vector2i size(static_cast<int>(page_width), static_cast<int>(layout.height));
    return png_picture(page_svg(size, svg), pixels);
}

}  // namespace ripstop
