#pragma once

#include <map>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace ripstop {

/// The elements of an SVG file and their byte offsets.
class SvgDocument {
  public:
    /// Throws InputError `NAME: byte N: …` if the file is not XML or its root is not svg. Expands entities that the
    /// file declares itself (`<!ENTITY st0 "fill:none">`).
    SvgDocument(std::string bytes, const std::string& name);

    pugi::xml_node root() const { return document_.document_element(); }
    /// The text before the root: XML declaration, comments, processing instructions.
    std::string_view prolog() const;
    /// The first element with this id; null if there is none.
    pugi::xml_node with_id(std::string_view id) const;
    /// The element of this file that `href`, or the older `xlink:href`, refers to; null if there is none.
    pugi::xml_node target_of(const pugi::xml_node& node) const;
    /// The element of this file that `url(#id)` refers to; null if there is none.
    pugi::xml_node target_of(std::string_view url) const;

    long line_of(const pugi::xml_node& node) const;
    /// `NAME: byte N`, for messages.
    std::string place_of(const pugi::xml_node& node) const;
    [[noreturn]] void refuse(const pugi::xml_node& node, const std::string& what) const;

  private:
    std::string name_, bytes_;
    pugi::xml_document document_;
    std::vector<std::size_t> line_ends_;
    std::map<std::string, pugi::xml_node, std::less<>> ids_;
};

/// The element's name without its prefix: `svg:path` is a path.
std::string_view svg_local_name(const pugi::xml_node& node);

/// The value of `href`, else of `xlink:href`, without surrounding blanks.
std::string_view svg_href(const pugi::xml_node& node);

/// True if the element is in a namespace other than that of SVG, so that browsers do not draw it:
/// `sodipodi:namedview`, `i:pgf`.
bool is_foreign_to_svg(const pugi::xml_node& node);

/// True if the element's conditions, by which `switch` chooses, hold: no extension is known, and the language is
/// English.
bool is_offered_by_svg(const pugi::xml_node& node);

}  // namespace ripstop
