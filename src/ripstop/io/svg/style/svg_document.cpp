#include "ripstop/io/svg/style/svg_document.h"

#include <algorithm>
#include <utility>

#include "ripstop/base/error.h"
#include "ripstop/io/svg/values/svg_path.h"
#include "ripstop/io/text/text.h"

namespace ripstop {
namespace {

constexpr std::size_t largest_growth = 10'000'000;  // by expansion of entities [bytes]

/// The entities that the document type declares, by name.
std::map<std::string, std::string, std::less<>> entities_of(std::string_view bytes) {
    std::map<std::string, std::string, std::less<>> entities;
    constexpr std::string_view key = "<!ENTITY";
    for (std::size_t at; (at = bytes.find(key)) != std::string_view::npos;) {
        bytes.remove_prefix(at + key.size());
        std::string_view rest = bytes.substr(0, bytes.find('>'));
        const std::string_view name = svg_next_word(rest);
        rest = svg_trimmed(rest);
        if (rest.size() < 2 || (rest[0] != '"' && rest[0] != '\'')) continue;
        const std::size_t end = rest.find(rest[0], 1);
        if (end != std::string_view::npos) entities.emplace(name, rest.substr(1, end - 1));
    }
    return entities;
}

/// Expands the declared entities; keeps their declarations. Entities inside entities are not expanded.
std::string with_entities(std::string bytes, const std::string& name) {
    const std::size_t type = bytes.find("<!DOCTYPE"), open = bytes.find('[', type);
    if (type == std::string::npos || open == std::string::npos || open > bytes.find('>', type)) return bytes;
    const std::size_t close = bytes.find("]", open);
    if (close == std::string::npos) return bytes;
    const auto entities = entities_of(std::string_view(bytes).substr(open, close - open));
    if (entities.empty()) return bytes;
    std::string full = bytes.substr(0, close);
    for (std::size_t i = close; i < bytes.size(); ++i) {
        if (bytes[i] == '&') {
            const std::size_t end = bytes.find(';', i);
            const auto found = end == std::string::npos || end - i > 100
                                   ? entities.end()
                                   : entities.find(std::string_view(bytes).substr(i + 1, end - i - 1));
            if (found != entities.end()) {
                full += found->second;
                i = end;
                if (full.size() > bytes.size() + largest_growth)
                    throw InputError(name + ": its entities make it more than 10 MB longer; export the drawing again");
                continue;
            }
        }
        full += bytes[i];
    }
    return full;
}

}  // namespace

SvgDocument::SvgDocument(std::string bytes, const std::string& name)
    : name_(name), bytes_(with_entities(std::move(bytes), name)) {
    const pugi::xml_parse_result result =
        document_.load_buffer(bytes_.data(), bytes_.size(), pugi::parse_default | pugi::parse_ws_pcdata);
    if (!result)
        throw InputError(name_ + ": byte " + std::to_string(result.offset) + ": " + result.description() +
                         ", expected XML; export the drawing again");
    if (svg_local_name(root()) != "svg")
        refuse(root(), "the root is " + shown(root().name()) + ", expected svg; export the drawing as SVG");
    for (std::size_t i = 0; i < bytes_.size(); ++i)
        if (bytes_[i] == '\n') line_ends_.push_back(i);
    // Walks the tree in document order, without recursion, because the depth is checked later.
    for (pugi::xml_node node = root(); node;) {
        if (const pugi::xml_attribute id = node.attribute("id")) ids_.emplace(id.value(), node);
        if (node.first_child()) {
            node = node.first_child();
            continue;
        }
        while (node && !node.next_sibling()) node = node.parent();
        if (node) node = node.next_sibling();
    }
}

std::string_view SvgDocument::prolog() const {
    return std::string_view(bytes_).substr(
        0, static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, root().offset_debug())));
}

pugi::xml_node SvgDocument::with_id(std::string_view id) const {
    const auto found = ids_.find(id);
    return found == ids_.end() ? pugi::xml_node() : found->second;
}

pugi::xml_node SvgDocument::target_of(const pugi::xml_node& node) const {
    const std::string_view href = svg_href(node);
    return href.size() > 1 && href[0] == '#' ? with_id(href.substr(1)) : pugi::xml_node();
}

pugi::xml_node SvgDocument::target_of(std::string_view url) const {
    url = svg_trimmed(url);
    if (!url.starts_with("url(") || !url.ends_with(')')) return {};
    url = svg_trimmed(url.substr(4, url.size() - 5));
    if (url.size() > 1 && (url[0] == '"' || url[0] == '\'')) url = url.substr(1, url.size() - 2);
    return url.starts_with('#') ? with_id(url.substr(1)) : pugi::xml_node();
}

long SvgDocument::line_of(const pugi::xml_node& node) const {
    const auto at = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, node.offset_debug()));
    return 1 + (std::lower_bound(line_ends_.begin(), line_ends_.end(), at) - line_ends_.begin());
}

std::string SvgDocument::place_of(const pugi::xml_node& node) const {
    return name_ + ": byte " + std::to_string(node.offset_debug());
}

void SvgDocument::refuse(const pugi::xml_node& node, const std::string& what) const {
    throw InputError(place_of(node) + ": " + what);
}

std::string_view svg_local_name(const pugi::xml_node& node) {
    const std::string_view name = node.name();
    const std::size_t colon = name.find(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

std::string_view svg_href(const pugi::xml_node& node) {
    const pugi::xml_attribute href = node.attribute("href");
    return svg_trimmed(href ? href.value() : node.attribute("xlink:href").value());
}

bool is_foreign_to_svg(const pugi::xml_node& node) {
    const std::string name = node.name();
    const std::size_t colon = name.find(':');
    if (colon == std::string::npos) return false;
    const std::string key = "xmlns:" + name.substr(0, colon);
    for (pugi::xml_node around = node; around; around = around.parent())
        if (const pugi::xml_attribute space = around.attribute(key.c_str()))
            return std::string_view(space.value()) != "http://www.w3.org/2000/svg";
    return name.substr(0, colon) != "svg";
}

bool is_offered_by_svg(const pugi::xml_node& node) {
    if (!svg_trimmed(node.attribute("requiredExtensions").value()).empty()) return false;
    const pugi::xml_attribute languages = node.attribute("systemLanguage");
    std::string_view rest = languages.value();
    if (!languages) return true;
    while (!rest.empty()) {
        const std::string_view word = svg_trimmed(rest.substr(0, rest.find(',')));
        if (word == "en" || word.starts_with("en-")) return true;
        rest.remove_prefix(std::min(rest.size(), rest.find(',') == rest.npos ? rest.size() : rest.find(',') + 1));
    }
    return false;
}

}  // namespace ripstop
