#include "ripstop/io/svg/values/svg_view.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "ripstop/base/error.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/io/svg/values/svg_path.h"
#include "ripstop/io/text/text.h"

namespace ripstop {
namespace {

bool is_blank_or_comma(char c) {
    return std::string_view(" \t\r\n\f,").find(c) != std::string_view::npos;
}

/// The words, separated by blanks and commas; numbers that are joined as in a path (`1-2`) are separated.
std::vector<std::string_view> arguments_of(std::string_view text) {
    std::vector<std::string_view> found;
    while (true) {
        while (!text.empty() && is_blank_or_comma(text.front())) text.remove_prefix(1);
        if (text.empty()) return found;
        std::size_t end = svg_number_end(text);
        while (end < text.size() &&
               (text[end] == '%' || (text[end] >= 'a' && text[end] <= 'z') || (text[end] >= 'A' && text[end] <= 'Z')))
            ++end;
        if (end == 0) end = 1;  // no number; the caller refuses it
        found.push_back(text.substr(0, end));
        text.remove_prefix(end);
    }
}

class TransformReader {
  public:
    TransformReader(const SvgBasis& basis, const std::string& place) : basis_(basis), place_(place) {}

    Eigen::Affine2d read(std::string_view rest) {
        Eigen::Affine2d motion = Eigen::Affine2d::Identity();
        rest = svg_trimmed(rest);
        if (rest == "none") return motion;
        while (!rest.empty()) {
            const std::size_t open = rest.find('('), close = rest.find(')');
            if (open == std::string_view::npos || close == std::string_view::npos || close < open)
                refuse(rest, "a list of functions with numbers in brackets");
            kind_ = svg_trimmed(rest.substr(0, open));
            arguments_ = arguments_of(rest.substr(open + 1, close - open - 1));
            motion = motion * one();
            rest.remove_prefix(close + 1);
            while (!rest.empty() && is_blank_or_comma(rest.front())) rest.remove_prefix(1);
        }
        return motion;
    }

  private:
    [[noreturn]] void refuse(std::string_view found, const std::string& expected) const {
        throw InputError(place_ + ": the transform " + shown(found) + ", expected " + expected +
                         "; export the drawing again");
    }

    void expect(std::size_t least, std::size_t most) const {
        if (arguments_.size() < least || arguments_.size() > most)
            refuse(kind_, least == most ? std::to_string(least) + " numbers in it" : "fewer or more numbers in it");
    }
    double number(std::size_t i) const { return finite(svg_length(arguments_[i], SvgAxis::x, {}), arguments_[i]); }
    double length(std::size_t i, SvgAxis axis) const {
        return finite(svg_length(arguments_[i], axis, basis_), arguments_[i]);
    }
    double angle(std::size_t i) const { return finite(svg_angle(arguments_[i]), arguments_[i]); }
    double finite(const std::optional<double>& value, std::string_view text) const {
        if (!value || !(std::abs(*value) <= 1e9)) refuse(text, "a number within 1e9");
        return *value;
    }

    Eigen::Affine2d one() const {
        Eigen::Affine2d motion = Eigen::Affine2d::Identity();
        if (kind_ == "translate" || kind_ == "translateX") {
            expect(1, kind_ == "translate" ? 2 : 1);
            motion.translation() = Vec2(length(0, SvgAxis::x), arguments_.size() > 1 ? length(1, SvgAxis::y) : 0);
        } else if (kind_ == "translateY") {
            expect(1, 1);
            motion.translation() = Vec2(0, length(0, SvgAxis::y));
        } else if (kind_ == "scale") {
            expect(1, 2);
            motion.linear() = Vec2(number(0), number(arguments_.size() - 1)).asDiagonal();
        } else if (kind_ == "scaleX" || kind_ == "scaleY") {
            expect(1, 1);
            motion.linear()(kind_ == "scaleX" ? 0 : 1, kind_ == "scaleX" ? 0 : 1) = number(0);
        } else if (kind_ == "rotate") {
            return rotation();
        } else if (kind_ == "skewX" || kind_ == "skew") {
            expect(1, kind_ == "skew" ? 2 : 1);
            motion.linear()(0, 1) = std::tan(angle(0));
            if (arguments_.size() > 1) motion.linear()(1, 0) = std::tan(angle(1));
        } else if (kind_ == "skewY") {
            expect(1, 1);
            motion.linear()(1, 0) = std::tan(angle(0));
        } else if (kind_ == "matrix") {
            expect(6, 6);
            motion.linear() << number(0), number(2), number(1), number(3);
            motion.translation() = Vec2(number(4), number(5));
        } else {
            refuse(kind_, "one of SVG");
        }
        return motion;
    }

    Eigen::Affine2d rotation() const {
        if (arguments_.size() != 3) expect(1, 1);
        const Vec2 centre = arguments_.size() == 3 ? Vec2(number(1), number(2)) : Vec2(0, 0);
        return Eigen::Translation2d(centre) * Eigen::Rotation2Dd(angle(0)) * Eigen::Translation2d(-centre);
    }

    const SvgBasis& basis_;
    const std::string& place_;
    std::string_view kind_;
    std::vector<std::string_view> arguments_;
};

/// A number and whether it has a CSS unit; empty if it is no number.
struct CssNumber {
    std::optional<double> value;
    std::string_view unit;

    explicit CssNumber(std::string_view text) {
        text = svg_trimmed(text);
        const std::size_t end = svg_number_end(text);
        unit = text.substr(end);
        const bool is_unit = unit == "%" || std::all_of(unit.begin(), unit.end(),
                                                        [](char c) { return (c | 32) >= 'a' && (c | 32) <= 'z'; });
        if (is_unit) value = parse_double(text.substr(0, end));
    }
    bool is_length_or_angle() const { return value && (!unit.empty() || *value == 0); }
    bool is_factor() const { return value && (unit.empty() || unit == "%"); }
};

std::vector<CssNumber> css_arguments(std::string_view text) {
    std::vector<CssNumber> found;
    while (true) {
        const std::size_t comma = text.find(',');
        found.emplace_back(text.substr(0, comma));
        if (comma == std::string_view::npos) return found;
        text.remove_prefix(comma + 1);
    }
}

}  // namespace

bool is_css_transform(std::string_view rest) {
    rest = svg_trimmed(rest);
    if (rest.find('(') == std::string_view::npos) return rest.find_first_of("0123456789") == std::string_view::npos;
    if (rest.find("calc(") != std::string_view::npos || rest.find("var(") != std::string_view::npos) return true;
    for (; !rest.empty(); rest = svg_trimmed(rest)) {
        const std::size_t open = rest.find('('), close = rest.find(')');
        if (open == std::string_view::npos || close == std::string_view::npos || close < open) return false;
        const std::string_view kind = rest.substr(0, open);
        const std::vector<CssNumber> arguments = css_arguments(rest.substr(open + 1, close - open - 1));
        const bool is_shift = kind == "translate" || kind == "translateX" || kind == "translateY";
        const bool is_turn = kind == "rotate" || kind == "skew" || kind == "skewX" || kind == "skewY";
        const bool is_factor = kind == "scale" || kind == "scaleX" || kind == "scaleY" || kind == "matrix";
        for (const CssNumber& argument : arguments)
            if (((is_shift || is_turn) && !argument.is_length_or_angle()) || (is_factor && !argument.is_factor()))
                return false;
        const std::size_t most = kind == "matrix"                                           ? 6
                                 : kind == "translate" || kind == "scale" || kind == "skew" ? 2
                                                                                            : 1;
        if ((is_shift || is_turn || is_factor) && (arguments.size() > most || (most == 6 && arguments.size() != most)))
            return false;
        rest.remove_prefix(close + 1);
    }
    return true;
}

std::optional<Vec2> svg_transform_origin(std::string_view text, const SvgBasis& basis) {
    std::string_view x = svg_next_word(text), y = svg_next_word(text);
    if (x.empty() || x == "initial") return Vec2(0, 0);
    if (y.empty()) y = "center";
    if (x == "top" || x == "bottom" || y == "left" || y == "right") std::swap(x, y);
    const auto share = [](std::string_view word) {
        return word == "left" || word == "top"       ? "0%"
               : word == "center"                    ? "50%"
               : word == "right" || word == "bottom" ? "100%"
                                                     : word;
    };
    const auto along = svg_length(share(x), SvgAxis::x, basis), across = svg_length(share(y), SvgAxis::y, basis);
    if (!along || !across || !std::isfinite(*along) || !std::isfinite(*across)) return std::nullopt;
    return Vec2(*along, *across);
}

Eigen::Affine2d svg_transform(std::string_view text, const SvgBasis& basis, const std::string& place) {
    return TransformReader(basis, place).read(text);
}

SvgFit::SvgFit(std::string_view preserve_aspect_ratio) {
    std::string_view word = svg_next_word(preserve_aspect_ratio);
    is_stretched = word == "none";
    is_slice = svg_next_word(preserve_aspect_ratio) == "slice";
    const auto place = [](std::string_view name) { return name == "Min" ? 0.0 : name == "Max" ? 1.0 : 0.5; };
    if (word.size() == 8 && word[0] == 'x' && word[4] == 'Y')
        share = Vec2(place(word.substr(1, 3)), place(word.substr(5)));
}

std::optional<SvgViewBox> svg_view_box(std::string_view text) {
    std::vector<double> numbers;
    try {
        numbers = svg_numbers(text, "");
    } catch (const InputError&) {
        return std::nullopt;
    }
    if (numbers.size() != 4 || !(numbers[2] >= 0) || !(numbers[3] >= 0)) return std::nullopt;
    return SvgViewBox{{numbers[0], numbers[1]}, {numbers[2], numbers[3]}};
}

Eigen::Affine2d svg_view(const SvgViewBox& box, const Vec2& size, const SvgFit& fit) {
    Vec2 scale = size.cwiseQuotient(box.size);
    if (!fit.is_stretched) scale.setConstant(fit.is_slice ? scale.maxCoeff() : scale.minCoeff());
    const Vec2 room =
        fit.is_stretched ? Vec2(0, 0) : Vec2((size - box.size.cwiseProduct(scale)).cwiseProduct(fit.share));
    Eigen::Affine2d motion = Eigen::Affine2d::Identity();
    motion.linear() = scale.asDiagonal();
    motion.translation() = room - box.corner.cwiseProduct(scale);
    return motion;
}

}  // namespace ripstop
