#include "ripstop/io/svg/values/svg_length.h"

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "ripstop/base/text/lower_case.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"
#include "ripstop/io/svg/values/svg_path.h"
#include "ripstop/io/text/text.h"

namespace ripstop {
namespace {

/// A number and the text after it, in lower case.
struct Measure {
    double number;
    std::string unit;
};

std::optional<Measure> measure(std::string_view text) {
    text = svg_trimmed(text);
    const std::size_t end = svg_number_end(text);
    const std::optional<double> number = parse_double(text.substr(0, end));
    if (!number) return std::nullopt;
    return Measure{*number, lower_case(text.substr(end))};
}

std::optional<double> absolute_unit(std::string_view unit) {
    static constexpr std::array<std::pair<std::string_view, double>, 6> units{{{"mm", svg_units_per_mm},
                                                                               {"cm", 10 * svg_units_per_mm},
                                                                               {"in", 96.0},
                                                                               {"pt", 96.0 / 72},
                                                                               {"pc", 16.0},
                                                                               {"q", svg_units_per_mm / 4}}};
    for (const auto& [name, size] : units)
        if (unit == name) return size;
    return std::nullopt;
}

std::optional<double> times(double number, const std::optional<double>& size) {
    if (!size) return std::nullopt;
    return number * *size;
}

}  // namespace

std::optional<double> svg_length(std::string_view text, SvgAxis axis, const SvgBasis& basis) {
    const std::optional<Measure> length = measure(text);
    if (!length) return std::nullopt;
    if (length->unit.empty() || length->unit == "px") return length->number;
    if (length->unit == "em") return times(length->number, basis.font_size);
    if (length->unit == "rem") return times(length->number, basis.root_font_size);
    if (length->unit == "%") {
        if (!basis.viewport) return std::nullopt;
        const double whole = axis == SvgAxis::x   ? basis.viewport->x()
                             : axis == SvgAxis::y ? basis.viewport->y()
                                                  : basis.viewport->norm() / std::numbers::sqrt2;
        return length->number / 100 * whole;
    }
    return times(length->number, absolute_unit(length->unit));
}

bool is_absolute_svg_length(std::string_view text) {
    const std::optional<Measure> length = measure(text);
    return length && absolute_unit(length->unit).has_value();
}

std::optional<double> svg_font_size(std::string_view text, const SvgBasis& parent) {
    static constexpr std::array<std::pair<std::string_view, double>, 8> words{{{"xx-small", 9},
                                                                               {"x-small", 10},
                                                                               {"small", 13},
                                                                               {"medium", 16},
                                                                               {"large", 18},
                                                                               {"x-large", 24},
                                                                               {"xx-large", 32},
                                                                               {"xxx-large", 48}}};
    const std::string_view value = svg_trimmed(text);
    for (const auto& [word, size] : words)
        if (value == word) return size;
    if (value == "larger") return times(1.2, parent.font_size);
    if (value == "smaller") return times(1 / 1.2, parent.font_size);
    if (value == "inherit" || value == "unset") return parent.font_size;
    if (value == "initial") return 16;
    SvgBasis basis = parent;
    if (parent.font_size) basis.viewport = Vec2(*parent.font_size, *parent.font_size);
    if (!parent.font_size) basis.viewport = std::nullopt;
    const std::optional<double> size = svg_length(value, SvgAxis::x, basis);
    if (!size || !(*size >= 0)) return std::nullopt;
    return size;
}

std::optional<double> svg_angle(std::string_view text) {
    const std::optional<Measure> angle = measure(text);
    if (!angle) return std::nullopt;
    if (angle->unit.empty() || angle->unit == "deg") return angle->number * degree;
    if (angle->unit == "grad") return angle->number * 0.9 * degree;
    if (angle->unit == "rad") return angle->number;
    if (angle->unit == "turn") return angle->number * 360 * degree;
    return std::nullopt;
}

}  // namespace ripstop
