#include <algorithm>

#include "ripstop/io/svg/style/svg_css.h"
#include "ripstop/io/svg/style/svg_document.h"
#include "ripstop/io/svg/values/svg_path.h"
#include "ripstop/io/text/text.h"

namespace ripstop {
namespace {

pugi::xml_node element_before(pugi::xml_node node) {
    do node = node.previous_sibling();
    while (node && node.type() != pugi::node_element);
    return node;
}

pugi::xml_node element_after(pugi::xml_node node) {
    do node = node.next_sibling();
    while (node && node.type() != pugi::node_element);
    return node;
}

bool has_word(std::string_view list, std::string_view word) {
    while (true) {
        const std::string_view next = svg_next_word(list);
        if (next.empty()) return false;
        if (next == word) return true;
    }
}

bool matches(const CssCompound::Attribute& wanted, const pugi::xml_node& element) {
    const pugi::xml_attribute found = element.attribute(wanted.name.c_str());
    if (!found) return false;
    const std::string_view value = found.value(), text = wanted.value;
    switch (wanted.test) {
        case '=':
            return value == text;
        case '~':
            return has_word(value, text);
        case '|':
            return value == text || (value.starts_with(text) && value.substr(text.size()).starts_with('-'));
        case '^':
            return !text.empty() && value.starts_with(text);
        case '$':
            return !text.empty() && value.ends_with(text);
        case '*':
            return !text.empty() && value.find(text) != std::string_view::npos;
        default:
            return true;
    }
}

bool stands(const std::string& place, const pugi::xml_node& element) {
    if (place == "root") return element.parent().type() == pugi::node_document;
    const bool is_first = !element_before(element), is_last = !element_after(element);
    return place == "first-child" ? is_first : place == "last-child" ? is_last : is_first && is_last;
}

bool matches(const CssCompound& wanted, const pugi::xml_node& element) {
    if (!wanted.type.empty() && wanted.type != svg_local_name(element)) return false;
    if (!wanted.id.empty() && wanted.id != element.attribute("id").value()) return false;
    const std::string_view classes = element.attribute("class").value();
    return std::all_of(wanted.classes.begin(), wanted.classes.end(),
                       [&](const std::string& name) { return has_word(classes, name); }) &&
           std::all_of(wanted.attributes.begin(), wanted.attributes.end(),
                       [&](const CssCompound::Attribute& attribute) { return matches(attribute, element); }) &&
           std::all_of(wanted.places.begin(), wanted.places.end(),
                       [&](const std::string& place) { return stands(place, element); });
}

/// True if `element` matches the compounds up to `last`, the last one being its own. Backtracks over all ancestors
/// for each compound; `steps` bounds the work.
bool matches_up_to(const std::vector<CssCompound>& compounds, std::size_t last, pugi::xml_node element, int& steps) {
    if (--steps < 0 || element.type() != pugi::node_element || !matches(compounds[last], element)) return false;
    if (last == 0) return true;
    switch (compounds[last].before) {
        case '>':
            return matches_up_to(compounds, last - 1, element.parent(), steps);
        case '+':
            return matches_up_to(compounds, last - 1, element_before(element), steps);
        case '~':
            while ((element = element_before(element)))
                if (matches_up_to(compounds, last - 1, element, steps)) return true;
            return false;
        default:
            while ((element = element.parent()))
                if (matches_up_to(compounds, last - 1, element, steps)) return true;
            return false;
    }
}

}  // namespace

bool CssSelector::matches(const pugi::xml_node& element) const {
    int steps = 10'000;
    return matches_up_to(compounds, compounds.size() - 1, element, steps);
}

}  // namespace ripstop
