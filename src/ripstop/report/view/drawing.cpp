#include "ripstop/report/view/drawing.h"

#include <cmath>

#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"
#include "ripstop/io/text/escape.h"
#include "ripstop/report/figures/colour_scale.h"
#include "ripstop/report/figures/figures.h"

namespace ripstop {

std::string svg_number(double value) {
    return format_fixed(value, 2);
}

std::string svg_pair(const Vec2& p) {
    return svg_number(p.x()) + " " + svg_number(p.y());
}

std::string svg_text(const Vec2& at, const std::string& content, const TextStyle& style) {
    std::string result = "<text x=\"" + svg_number(at.x()) + "\" y=\"" + svg_number(at.y()) + "\" font-size=\"" +
                         format_fixed(style.size, 0) + "\" fill=\"" + style.colour + "\" text-anchor=\"" +
                         style.anchor + "\"";
    if (style.bold) result += " font-weight=\"bold\"";
    if (style.halo) result += " stroke=\"#ffffff\" stroke-width=\"4\" stroke-linejoin=\"round\" paint-order=\"stroke\"";
    return result + ">" + xml_text(content) + "</text>\n";
}

std::string svg_stroke(const std::vector<Vec2>& points, const std::string& colour, double width) {
    std::string path;
    for (const Vec2& p : points) path += (path.empty() ? "M" : " ") + svg_pair(p);
    return "<path fill=\"none\" stroke=\"" + colour + "\" stroke-width=\"" + format_fixed(width, 1) +
           "\" stroke-linecap=\"round\" stroke-linejoin=\"round\" d=\"" + path + "\"/>\n";
}

std::string colour_bar(const Vec2& at, const std::string& title, double limit, const std::string& unit) {
    constexpr double step = 6;
    std::string result = svg_text(at + Vec2(0, -8), title, {13, "start", "#1f2933"});
    for (int c = 0; c < beyond_class; ++c)
        result += "<rect x=\"" + svg_number(at.x() + step * c) + "\" y=\"" + svg_number(at.y()) +
                  "\" width=\"6.5\" height=\"13\" fill=\"" + class_colour(c) + "\"/>\n";
    const double end = at.x() + step * beyond_class;
    result += "<rect x=\"" + svg_number(end + 4) + "\" y=\"" + svg_number(at.y()) +
              "\" width=\"30\" height=\"13\" fill=\"" + class_colour(beyond_class) + "\"/>\n";
    const auto value = [&](double share) { return format_shortest(clean(share * limit)); };
    const double y = at.y() + 29;
    result += svg_text({at.x(), y}, "0", {12, "middle", "#52606d"});
    result += svg_text({at.x() + step * beyond_class / 2, y}, value(0.5), {12, "middle", "#52606d"});
    result += svg_text({end, y}, value(1) + " " + unit, {12, "middle", "#52606d"});
    return result + svg_text({end + 38, at.y() + 11}, "beyond", {12, "start", "#52606d"});
}

std::string scale_bar(const Vec2& at, double scale, double widest) {
    const double most = widest / scale;
    double length = std::pow(10, std::floor(std::log10(most)));
    length *= most >= 5 * length ? 5 : most >= 2 * length ? 2 : 1;
    const double right = at.x() + scale * length;
    const std::string ends = "M" + svg_pair(at + Vec2(0, -5)) + "v10M" + svg_pair(at) + "H" + svg_number(right) + "M" +
                             svg_pair(Vec2(right, at.y() - 5)) + "v10";
    const std::string label =
        length >= 1 ? format_shortest(clean(length)) + " m" : format_shortest(clean(length / millimetre)) + " mm";
    return "<path fill=\"none\" stroke=\"#1f2933\" stroke-width=\"1.5\" d=\"" + ends + "\"/>\n" +
           svg_text({(at.x() + right) / 2, at.y() - 8}, label, {13, "middle", "#1f2933"});
}

}  // namespace ripstop
