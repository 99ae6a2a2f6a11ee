#include "ripstop/io/svg/svg_scale.h"

#include <cmath>
#include <limits>
#include <string>

#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"
#include "ripstop/io/svg/values/svg_path.h"
#include "ripstop/io/svg/values/svg_view.h"
#include "ripstop/io/text/text.h"

namespace ripstop {
namespace {

constexpr double pixel = 0.0254 / 96;  // a CSS px [m]
constexpr double sampling_error = 0.05 * millimetre;
constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

LengthUnit unit_of(double metres) {
    for (const char* known : {"mm", "cm", "m", "in", "ft"})
        if (std::abs(metres / metres_per_unit(known) - 1) < 1e-6) return {known, metres_per_unit(known)};
    return {std::to_string(metres / millimetre) + " mm", metres};
}

/// A program whose px differs from that of CSS.
struct Program {
    std::string name;
    double pixels_per_inch;
    std::string where() const { return name + " (" + format_fixed(pixels_per_inch, 0) + " px to the inch)"; }
};

std::optional<Program> program_of(const SvgDocument& document) {
    std::string_view version = document.root().attribute("inkscape:version").value();
    version = svg_next_word(version);
    // Versions before 0.92 (0.47, 0.48.4, 0.91); later ones follow CSS.
    if (version.starts_with("0."))
        if (const auto minor = parse_double(version.substr(2, version.find_first_not_of("0123456789", 2) - 2)))
            if (*minor < 92) return Program{"Inkscape " + readable_name(version), 90};
    if (document.prolog().find("Adobe Illustrator") != std::string_view::npos) return Program{"Illustrator", 72};
    return std::nullopt;
}

class ScaleReader {
  public:
    ScaleReader(const SvgDocument& document, const SvgStyle& style)
        : document_(document),
          root_(document.root()),
          style_(style),
          box_(svg_view_box(root_.attribute("viewBox").value())),
          fit_(root_.attribute("preserveAspectRatio").value()) {
        if (box_ && box_->size.minCoeff() <= 0) box_.reset();
    }

    SvgScale read() {
        const double width = side("width"), height = side("height");
        scale_.motion.linear()(1, 1) = -1;
        scale_.viewport = box_ ? box_->size : Vec2(width, height);
        scale_.is_pixel = !box_;
        if (has_unit("width") || has_unit("height"))
            read_unit(width, height);
        else if (const auto program = program_of(document_))
            state(*program, box_ && width > 0 ? width / box_->size.x() : 1);
        if (box_ && fit_.is_stretched && width > 0 && height > 0) {
            const double stretch = (height / box_->size.y()) / (width / box_->size.x());
            if (!(stretch > 1e-9 && stretch < 1e9))
                document_.refuse(root_, "width and height stretch it beyond reason; export the drawing again");
            scale_.motion.linear()(1, 1) = -stretch;
        }
        return scale_;
    }

  private:
    std::string_view text_of_side(const char* key) const {
        return svg_trimmed(style_.is_declared(key) ? style_[key] : root_.attribute(key).value());
    }
    /// The length of a side in px; NaN if it is absent or relative to the window.
    double side(const char* key) const {
        const std::optional<double> length = svg_length(text_of_side(key), SvgAxis::x, {});
        return length && *length > 0 ? *length : nowhere;
    }
    bool has_unit(const char* key) const { return is_absolute_svg_length(text_of_side(key)) && side(key) > 0; }

    /// The size of a user unit along a side, from `width="210mm"` and `viewBox="0 0 210 297"`.
    std::optional<StatedUnit> unit_along(const std::string& key, double length, double extent) const {
        if (std::isnan(length)) return std::nullopt;
        const double unit = length * pixel / extent;
        if (!(unit > 1e-9 && unit < 10))
            document_.refuse(root_, key + " makes a user unit of " + std::to_string(unit) +
                                        " m, expected less than 10 m and some length; export the drawing again");
        return StatedUnit{key + " and viewBox", unit_of(unit)};
    }

    void read_unit(double width, double height) {
        if (!box_) {
            // Here a user unit is 1/96 inch whatever the width.
            if (const auto program = program_of(document_); program && program->pixels_per_inch == 90)
                return state(*program, 1);
            scale_.units.push_back({has_unit("width") ? "width" : "height", unit_of(pixel)});
            return;
        }
        auto first = unit_along("width", width, box_->size.x()), second = unit_along("height", height, box_->size.y());
        if (first && second && fit_.is_stretched) second.reset();
        if (first && second && (second->unit.metres < first->unit.metres) != fit_.is_slice) std::swap(first, second);
        if (first) scale_.units.push_back(*first);
        if (second && (!first || std::abs(second->unit.metres / first->unit.metres - 1) > 1e-3))
            scale_.units.push_back(*second);
    }

    void state(const Program& program, double pixels) {
        if (!(pixels > 1e-6 && pixels < 1e6)) return;
        scale_.units.push_back({program.where(), unit_of(pixels * 0.0254 / program.pixels_per_inch)});
        scale_.units.push_back({"CSS (96 px to the inch)", unit_of(pixels * pixel)});
    }

    const SvgDocument& document_;
    const pugi::xml_node root_;
    const SvgStyle& style_;
    std::optional<SvgViewBox> box_;
    const SvgFit fit_;
    SvgScale scale_;
};

}  // namespace

SvgSampling SvgScale::sampling() const {
    if (units.empty()) return {sampling_error / millimetre, 1e-6};
    return {sampling_error / units.front().unit.metres, 1e-3};
}

SvgScale svg_scale(const SvgDocument& document, const SvgStyle& style) {
    return ScaleReader(document, style).read();
}

}  // namespace ripstop
