#include "ripstop/io/svg_style.h"

#include <algorithm>
#include <array>

#include "ripstop/io/svg_path.h"
#include "ripstop/io/text.h"

namespace ripstop {
namespace {

/// What says where a line is and whether it is seen.
constexpr std::array<std::string_view, 20> placing{
    "cx",        "cy",         "d",     "display", "height",    "offset-path",   "r",
    "rotate",    "rx",         "ry",    "scale",   "transform", "transform-box", "transform-origin",
    "translate", "visibility", "width", "x",       "y",         "zoom"};
/// What else is read.
constexpr std::array<std::string_view, 13> other_properties{
    "clip-path",  "fill",         "filter", "font",     "font-size", "marker",          "marker-end",
    "marker-mid", "marker-start", "mask",   "overflow", "stroke",    "stroke-dasharray"};

bool is_placing(std::string_view property) {
    return std::find(placing.begin(), placing.end(), property) != placing.end();
}
/// Attributes of these names are not the properties, or are too long to copy (`d`).
bool is_only_in_css(std::string_view property) {
    return property == "d" || property == "rotate" || property == "scale" || property == "translate" ||
           property == "zoom" || property == "offset-path";
}
bool is_read(std::string_view property) {
    return is_placing(property) ||
           std::find(other_properties.begin(), other_properties.end(), property) != other_properties.end();
}

constexpr long long of_style_attribute = 1LL << 60, of_important = 1LL << 61;

void set_all(SvgStyle& style, const std::vector<CssDeclaration>& declarations, long long priority) {
    for (const CssDeclaration& declaration : declarations)
        if (is_read(declaration.property))
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
    const auto [found, is_new] = values_.try_emplace(property, Value{value, priority});
    if (!is_new && priority >= found->second.priority) found->second = {value, priority};
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
                // One selector that is not understood undoes its whole rule, as browsers have it.
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
        if (is_read(attribute.name()) && !is_only_in_css(attribute.name()))
            style.set(attribute.name(), attribute.value(), 0);
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
