#include "ripstop/io/svg/svg_text.h"

#include <cmath>

#include "ripstop/io/svg/values/svg_path.h"
#include "ripstop/io/text/text.h"

namespace ripstop {
namespace {

constexpr int deepest_span = 64;  // nesting of tspans
constexpr double farthest_text = 1e9;

class TextReader {
  public:
    explicit TextReader(const SvgStyles& styles) : styles_(styles) {}

    void read(const pugi::xml_node& element, const SvgBasis& basis, bool is_visible, int depth) {
        place(element, basis);
        for (const pugi::xml_node& part : element.children()) {
            if (part.type() == pugi::node_pcdata || part.type() == pugi::node_cdata) {
                if (is_visible) write(part.value(), basis);
                continue;
            }
            const std::string_view kind = svg_local_name(part);
            if (kind == "textPath") text_.has_text_path = true;
            if ((kind != "tspan" && kind != "a") || depth > deepest_span) continue;
            const SvgStyle style = styles_.of(part);
            if (style["display"] == "none") continue;
            const std::string_view seen = style["visibility"];
            read(part, svg_basis_within(basis, style),
                 seen.empty() || seen == "inherit" ? is_visible : seen == "visible", depth + 1);
        }
    }

    SvgText finish() {
        end_line();
        return std::move(text_);
    }

  private:
    /// The first length of a list.
    static std::optional<double> first_length(const pugi::xml_node& element, const char* key, SvgAxis axis,
                                              const SvgBasis& basis) {
        std::string_view list = element.attribute(key).value();
        std::string_view first = svg_next_word(list);
        first = first.substr(0, first.find(','));
        const std::optional<double> length = svg_length(first, axis, basis);
        return length && std::abs(*length) <= farthest_text ? length : std::nullopt;
    }

    void place(const pugi::xml_node& element, const SvgBasis& basis) {
        const auto x = first_length(element, "x", SvgAxis::x, basis), y = first_length(element, "y", SvgAxis::y, basis);
        if (x || y) end_line();
        at_ += Vec2(first_length(element, "dx", SvgAxis::x, basis).value_or(0),
                    first_length(element, "dy", SvgAxis::y, basis).value_or(0));
        if (x) at_.x() = *x + first_length(element, "dx", SvgAxis::x, basis).value_or(0);
        if (y) at_.y() = *y + first_length(element, "dy", SvgAxis::y, basis).value_or(0);
    }

    void write(std::string_view letters, const SvgBasis& basis) {
        if (line_.empty()) {
            if (svg_trimmed(letters).empty()) return;
            start_ = at_;
            height_ = basis.font_size.value_or(0);
        }
        line_ += letters;
    }

    void end_line() {
        std::string joined;
        std::string_view rest = line_;
        for (std::string_view word = svg_next_word(rest); !word.empty(); word = svg_next_word(rest))
            joined += (joined.empty() ? "" : " ") + std::string(word);
        if (!joined.empty()) text_.lines.push_back({readable_name(joined), start_, height_});
        line_.clear();
    }

    const SvgStyles& styles_;
    SvgText text_;
    std::string line_;
    Vec2 at_ = Vec2::Zero(), start_ = Vec2::Zero();
    double height_ = 0;
};

}  // namespace

SvgText svg_text(const pugi::xml_node& element, const SvgStyles& styles, const SvgBasis& basis, bool is_visible) {
    TextReader reader(styles);
    reader.read(element, basis, is_visible, 0);
    return reader.finish();
}

SvgBasis svg_basis_within(const SvgBasis& basis, const SvgStyle& style) {
    SvgBasis within = basis;
    if (style.is_declared("font-size")) {
        within.font_size = svg_font_size(style["font-size"], basis);
    } else if (style.is_declared("font")) {
        // `italic bold 12px/1.5 serif`: the size is the first word that is a length
        std::string_view rest = style["font"];
        within.font_size = std::nullopt;
        for (std::string_view word = svg_next_word(rest); !word.empty() && !within.font_size;
             word = svg_next_word(rest)) {
            const std::string_view size = word.substr(0, word.find('/'));
            const bool is_weight = size.find_first_not_of("0123456789") == std::string_view::npos;
            if (!is_weight) within.font_size = svg_font_size(size, basis);
        }
    }
    return within;
}

}  // namespace ripstop
