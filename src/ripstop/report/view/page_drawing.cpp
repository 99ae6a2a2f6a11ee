#include "ripstop/report/view/page_drawing.h"

#include <algorithm>
#include <string_view>

#include "ripstop/base/text/utf8.h"
#include "ripstop/report/view/page_colours.h"

namespace ripstop {
namespace {

std::string swatch(const Vec2& at, std::uint16_t place) {
    return "<rect x=\"" + svg_number(at.x()) + "\" y=\"" + svg_number(at.y()) +
           "\" width=\"14\" height=\"12\" stroke=\"#77838f\" fill=\"" + page_colour(place) + "\"/>\n";
}

std::string ramp(const Vec2& at, double width, double from) {
    constexpr int stops = 16;
    std::string svg = "<defs><linearGradient id=\"ramp\">";
    for (int i = 0; i <= stops; ++i) {
        const double share = static_cast<double>(i) / stops;
        const auto step = static_cast<int>((from + (1 - from) * share) * (page_places::steps - 1) + 0.5);
        svg += "<stop offset=\"" + svg_number(share * 100) + "%\" stop-color=\"" +
               page_colour(static_cast<std::uint16_t>(page_places::first + step)) + "\"/>";
    }
    return svg + "</linearGradient></defs>\n<rect x=\"" + svg_number(at.x()) + "\" y=\"" + svg_number(at.y()) +
           "\" width=\"" + svg_number(width) + "\" height=\"12\" stroke=\"#77838f\" fill=\"url(#ramp)\"/>\n";
}

/// `at`: the upper middle.
std::string state_swatches(const Vec2& at) {
    std::string svg;
    for (std::size_t i = 0; i < cloth_states.size(); ++i) {
        const Vec2 corner = at + Vec2(100 * static_cast<double>(i) - 130, 0);
        svg += swatch(corner, static_cast<std::uint16_t>(page_places::taut + i)) +
               svg_text(corner + Vec2(20, 11), std::string(cloth_states[i]), {13, "start", page_ink});
    }
    return svg;
}

/// `at`: the upper middle.
std::string ramp_with_ends(const Vec2& at, const MapView& view) {
    constexpr double width = 320;
    const PageMap& map = *view.map;
    const MapScale& scale = view.scales.front();
    const double left = at.x() - width / 2, right = at.x() + width / 2, top = at.y();
    const TextStyle start{13, "start", page_ink}, middle{13, "middle", page_ink}, end{13, "end", page_ink};
    std::string svg = ramp({left, top}, width, map.is_unsigned ? 0.5 : 0);
    if (scale.has_beyond && !map.is_unsigned)
        svg += swatch({left - 84, top}, page_places::below) + svg_text({left - 64, top + 11}, "beyond", start);
    if (scale.has_beyond)
        svg += svg_text({right + 14, top + 11}, "beyond", start) + swatch({right + 70, top}, page_places::above);
    svg += svg_text({left, top + 28}, scale.low, start) + svg_text({at.x(), top + 28}, scale.middle, middle) +
           svg_text({right, top + 28}, scale.high, end);
    const TextStyle soft_start{12, "start", page_soft}, soft_end{12, "end", page_soft};
    svg += svg_text({left, top + 44}, std::string(map.negative), soft_start);
    return svg + svg_text({right, top + 44}, std::string(map.positive), soft_end);
}

}  // namespace

std::string page_svg(const Eigen::Vector2i& size, const std::string& content) {
    const std::string width = std::to_string(size.x()), height = std::to_string(size.y());
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
           "\" viewBox=\"0 0 " + width + " " + height +
           "\" font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\">\n" + content + "</svg>\n";
}

double text_width(const std::string& text, double size, bool is_bold) {
    double ems = 0;
    for (const char c : text) {
        if (!starts_letter(c)) continue;
        const bool is_narrow = std::string_view(" ,.:;'|!()[]ijlftrI-").find(c) != std::string_view::npos;
        const bool is_wide = (c >= 'A' && c <= 'Z') || std::string_view("mw%@").find(c) != std::string_view::npos;
        // East Asian letters take three bytes or more.
        ems += static_cast<unsigned char>(c) >= 0xe3 ? 1.05 : is_narrow ? 0.4 : is_wide ? 0.85 : 0.64;
    }
    return (is_bold ? 1.12 : 1) * size * ems;
}

std::string text_within(const Vec2& at, const std::string& content, double width, const TextStyle& style) {
    if (text_width(content, style.size, style.bold) <= width) return svg_text(at, content, style);
    std::size_t end = 0;
    for (std::size_t next = 1; next <= content.size(); ++next)
        if (next == content.size() || starts_letter(content[next])) {
            if (text_width(content.substr(0, next) + "…", style.size, style.bold) > width) break;
            end = next;
        }
    return svg_text(at, content.substr(0, end) + "…", style);
}

std::string text_lines(const Vec2& at, const std::vector<std::string>& lines, std::size_t most, double width,
                       const TextStyle& style) {
    std::string svg;
    for (std::size_t i = 0; i < std::min(most, lines.size()); ++i) {
        const bool is_cut = i + 1 == most && lines.size() > most;
        const std::string more = "and " + std::to_string(lines.size() - i) + " more; report.html shows them.";
        svg += text_within(at + Vec2(0, static_cast<double>(i) * line_step * style.size), is_cut ? more : lines[i],
                           width, style);
    }
    return svg;
}

std::string verdict_mark(const Vec2& at, bool is_good) {
    const Vec2 middle = at - Vec2(14, 7);
    const std::string x = svg_number(middle.x()), y = svg_number(middle.y());
    if (is_good) return "<circle cx=\"" + x + "\" cy=\"" + y + "\" r=\"6\" fill=\"" + page_good + "\"/>\n";
    return "<path fill=\"" + std::string(page_bad) + "\" d=\"M" + svg_pair(middle - Vec2(0, 8)) +
           "l8 8l-8 8l-8-8z\"/>\n";
}

std::string map_legend(const Vec2& at, const MapView& view) {
    const PageMap& map = *view.map;
    const std::string svg =
        svg_text(at + Vec2(0, 12), std::string(map.name), {14, "middle", page_ink, true}) +
        text_within({at.x(), at.y() + 82}, view.scales.front().note, legend_size.x(), {12, "middle", page_soft});
    return svg + (map.is_of_states() ? state_swatches(at + Vec2(0, 22)) : ramp_with_ends(at + Vec2(0, 22), view));
}

std::string path_of(const std::vector<Vec2>& points, bool is_closed) {
    std::string path;
    for (const Vec2& point : points) path += (path.empty() ? "M" : "L") + svg_pair(point);
    return is_closed && !path.empty() ? path + "z" : path;
}

}  // namespace ripstop
