#include "ripstop/io/svg/style/svg_style.h"

#include <algorithm>
#include <array>

#include "ripstop/base/text/lower_case.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/io/svg/values/svg_path.h"
#include "ripstop/io/svg/values/svg_view.h"
#include "ripstop/io/text/text.h"

namespace ripstop {
namespace {

/// Properties that decide where a line is and whether it is visible.
constexpr std::array<std::string_view, 20> placing{
    "cx",        "cy",         "d",     "display", "height",    "offset-path",   "r",
    "rotate",    "rx",         "ry",    "scale",   "transform", "transform-box", "transform-origin",
    "translate", "visibility", "width", "x",       "y",         "zoom"};
/// Other properties that are read.
constexpr std::array<std::string_view, 13> other_properties{
    "clip-path",  "fill",         "filter", "font",     "font-size", "marker",          "marker-end",
    "marker-mid", "marker-start", "mask",   "overflow", "stroke",    "stroke-dasharray"};

bool is_placing(std::string_view property) {
    return std::find(placing.begin(), placing.end(), property) != placing.end();
}
/// Attributes with these names are no presentation attributes, or are too long to copy (`d`).
bool is_only_in_css(std::string_view property) {
    return property == "d" || property == "rotate" || property == "scale" || property == "translate" ||
           property == "zoom" || property == "offset-path";
}
bool is_read(std::string_view property) {
    return is_placing(property) ||
           std::find(other_properties.begin(), other_properties.end(), property) != other_properties.end();
}

/// Properties whose values are keywords, in any case.
constexpr std::array<std::string_view, 8> worded{"display",       "fill",   "font-size",        "overflow",
                                                 "transform-box", "stroke", "transform-origin", "visibility"};

std::string worded_value(std::string_view property, std::string value) {
    return std::find(worded.begin(), worded.end(), property) == worded.end() ? value : lower_case(value);
}

bool is_wide_word(std::string_view value) {
    return value == "inherit" || value == "initial" || value == "unset" || value == "revert" || value == "revert-layer";
}

/// True if a number has the unit that CSS requires, or is 0.
bool has_css_unit(std::string_view value) {
    const std::size_t end = svg_number_end(value);
    const std::optional<double> number = parse_double(value.substr(0, end));
    return !number || end < value.size() || *number == 0;
}

/// True if browsers accept the declaration. If they do not understand one, the earlier one stays in force.
/// Chromium accepts `cx: 5` in style sheets, and `width: 5` in the `style` attribute of SVG elements, which it
/// parses in quirks mode.
bool is_kept(std::string_view property, std::string_view value, bool is_style_attribute) {
    static constexpr std::array<std::string_view, 3> lengths{"font-size", "height", "width"};
    static constexpr std::array<std::string_view, 6> sizes{"font-size", "height", "r", "rx", "ry", "width"};
    if (std::find(sizes.begin(), sizes.end(), property) != sizes.end() &&
        parse_double(value.substr(0, svg_number_end(value))).value_or(0) < 0)
        return false;
    if (std::find(lengths.begin(), lengths.end(), property) != lengths.end())
        return is_style_attribute || has_css_unit(value);
    if (property == "visibility")
        return value == "visible" || value == "hidden" || value == "collapse" || is_wide_word(value) ||
               value.find('(') != std::string_view::npos;
    if (property == "transform") return is_css_transform(value);
    if (property != "transform-origin") return true;
    for (std::string_view word = svg_next_word(value); !word.empty(); word = svg_next_word(value))
        if (!has_css_unit(word)) return false;
    return true;
}

constexpr long long of_style_attribute = 1LL << 60, of_important = 1LL << 61;

void set_all(SvgStyle& style, const std::vector<CssDeclaration>& declarations, long long priority) {
    for (const CssDeclaration& declaration : declarations)
        if (is_read(declaration.property) &&
            is_kept(declaration.property, worded_value(declaration.property, declaration.value),
                    priority == of_style_attribute))
            style.set(declaration.property, declaration.value,
                      priority + (declaration.is_important ? of_important : 0));
}

std::string content_of(const pugi::xml_node& node) {
    std::string text;
    for (const pugi::xml_node& part : node.children()) text += part.value();
    return text;
}

bool is_for_screen(std::string_view media) {
    media = svg_trimmed(media);
    return media.empty() || media == "all" || media == "screen";
}

}  // namespace

std::string_view SvgStyle::operator[](std::string_view property) const {
    const auto found = values_.find(property);
    return found == values_.end() ? std::string_view() : found->second.text;
}

void SvgStyle::set(const std::string& property, const std::string& value, long long priority) {
    const Value given{worded_value(property, value), priority};
    const auto [found, is_new] = values_.try_emplace(property, given);
    if (!is_new && priority >= found->second.priority) found->second = given;
}

SvgStyles::SvgStyles(const SvgDocument& document) {
    if (document.prolog().find("<?xml-stylesheet") != std::string_view::npos)
        doubts_.push_back({"the style sheet that <?xml-stylesheet names", 1});
    for (pugi::xml_node node = document.root(); node;) {
        if (svg_local_name(node) == "style") {
            const std::string_view type = svg_trimmed(node.attribute("type").value());
            const bool is_css = type.empty() || type == "text/css";
            for (CssRule& rule : css_rules(is_css ? content_of(node) : "")) {
                if (!is_for_screen(node.attribute("media").value())) continue;
                std::erase_if(rule.declarations, [](const CssDeclaration& d) { return !is_read(d.property); });
                const bool may_place = std::any_of(rule.declarations.begin(), rule.declarations.end(),
                                                   [](const CssDeclaration& d) { return is_placing(d.property); });
                if (!rule.doubt.empty() && (may_place || rule.doubt.starts_with("@import")))
                    doubts_.push_back({rule.doubt, document.line_of(node)});
                // As in browsers, one selector that is not understood invalidates its whole rule.
                if (rule.doubt.empty() && !rule.declarations.empty()) rules_.push_back(std::move(rule));
            }
        }
        if (node.first_child()) {
            node = node.first_child();
            continue;
        }
        while (node && !node.next_sibling()) node = node.parent();
        if (node) node = node.next_sibling();
    }
}

SvgStyle SvgStyles::of(const pugi::xml_node& element) const {
    SvgStyle style;
    for (const pugi::xml_attribute& attribute : element.attributes())
        if (is_read(attribute.name()) && !is_only_in_css(attribute.name())) {
            const std::string property = attribute.name(), value = worded_value(property, attribute.value());
            if (property != "visibility" || is_kept(property, value, false)) style.set(property, value, 0);
        }
    for (std::size_t i = 0; i < rules_.size(); ++i) {
        int specificity = -1;
        for (const CssSelector& selector : rules_[i].selectors)
            if (selector.specificity > specificity && selector.matches(element)) specificity = selector.specificity;
        if (specificity >= 0)
            set_all(style, rules_[i].declarations,
                    (static_cast<long long>(specificity + 1) << 32) + static_cast<long long>(i));
    }
    if (const pugi::xml_attribute own = element.attribute("style"))
        set_all(style, css_declarations(own.value()), of_style_attribute);
    return style;
}

}  // namespace ripstop
