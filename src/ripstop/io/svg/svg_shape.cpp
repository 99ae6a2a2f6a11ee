#include "ripstop/io/svg/svg_shape.h"

#include <cmath>

#include "ripstop/io/svg/values/svg_path.h"
#include "ripstop/io/text/text.h"

namespace ripstop {
namespace {

/// Reads the lengths of one element.
class Lengths {
  public:
    Lengths(const pugi::xml_node& element, const SvgStyle& style, const SvgBasis& basis,
            std::vector<std::string>& unclear)
        : element_(element), style_(style), basis_(basis), unclear_(unclear) {}

    double operator()(const char* key, SvgAxis axis, double otherwise = 0) const {
        return svg_length_of(element_, style_, key, axis, basis_, unclear_, otherwise);
    }
    Vec2 point(const char* x, const char* y) const { return {(*this)(x, SvgAxis::x), (*this)(y, SvgAxis::y)}; }
    /// The radii; each that is absent equals the other.
    Vec2 radii() const {
        constexpr double not_given = -1;
        Vec2 r((*this)("rx", SvgAxis::x, not_given), (*this)("ry", SvgAxis::y, not_given));
        if (r.x() < 0) r.x() = r.y();
        if (r.y() < 0) r.y() = r.x();
        return r.cwiseMax(0);
    }

  private:
    const pugi::xml_node& element_;
    const SvgStyle& style_;
    const SvgBasis& basis_;
    std::vector<std::string>& unclear_;
};

/// The path data: `d`, or `path("…")` in the style.
std::string_view path_data(const pugi::xml_node& element, const SvgStyle& style) {
    if (!style.is_declared("d")) return element.attribute("d").value();
    std::string_view value = style["d"];
    if (!value.starts_with("path(") || !value.ends_with(')')) return {};
    value = svg_trimmed(value.substr(5, value.size() - 6));
    return value.size() > 1 ? value.substr(1, value.size() - 2) : std::string_view();
}

SvgRun run_through(const std::vector<double>& numbers, bool is_closed) {
    SvgRun run{{numbers[0], numbers[1]}, {}, is_closed};
    for (std::size_t i = 2; i + 1 < numbers.size(); i += 2)
        run.segments.push_back(svg_line({numbers[i], numbers[i + 1]}));
    return run;
}

}  // namespace

double svg_length_of(const pugi::xml_node& element, const SvgStyle& style, const char* key, SvgAxis axis,
                     const SvgBasis& basis, std::vector<std::string>& unclear, double otherwise) {
    const std::string_view text = svg_trimmed(style.is_declared(key) ? style[key] : element.attribute(key).value());
    if (text.empty() || text == "auto" || text == "initial") return otherwise;
    const std::optional<double> length = svg_length(text, axis, basis);
    if (length && std::abs(*length) <= 1e9) return *length;
    unclear.push_back(std::string(key) + "=" + shown(text));
    return 0;
}

std::optional<SvgShape> svg_shape(const pugi::xml_node& element, const SvgStyle& style, const SvgBasis& basis,
                                  const std::string& place) {
    const std::string_view kind = svg_local_name(element);
    SvgShape shape;
    const Lengths length(element, style, basis, shape.unclear);
    if (kind == "path") {
        const std::string_view data = svg_trimmed(path_data(element, style));
        if (data != "none") shape.runs = svg_path(data, place);
    } else if (kind == "line") {
        shape.runs = {{length.point("x1", "y1"), {svg_line(length.point("x2", "y2"))}, false}};
    } else if (kind == "polyline" || kind == "polygon") {
        const std::vector<double> numbers = svg_numbers(element.attribute("points").value(), place);
        if (numbers.size() > 3) shape.runs = {run_through(numbers, kind == "polygon")};
    } else if (kind == "rect") {
        const Vec2 size = length.point("width", "height");
        const Vec2 corner = length.point("x", "y"), radii = length.radii();
        if (size.minCoeff() > 0) shape.runs = {svg_rectangle(corner, size, radii)};
    } else if (kind == "circle") {
        const double radius = length("r", SvgAxis::both);
        const Vec2 centre = length.point("cx", "cy");
        if (radius > 0) shape.runs = {svg_ellipse(centre, {radius, radius})};
    } else if (kind == "ellipse") {
        const Vec2 centre = length.point("cx", "cy"), radii = length.radii();
        if (radii.minCoeff() > 0) shape.runs = {svg_ellipse(centre, radii)};
    } else {
        return std::nullopt;
    }
    if (!shape.unclear.empty()) shape.runs.clear();
    return shape;
}

}  // namespace ripstop
