#pragma once

#include <map>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace ripstop {

/// The elements of an SVG file and where they stand in it.
class SvgDocument {
  public:
    /// Throws InputError `NAME: byte N: …` for what is no XML, and for another root than svg. Entities that the file
    /// declares itself (`<!ENTITY st0 "fill:none">`) are put in.
    SvgDocument(std::string bytes, const std::string& name);

    pugi::xml_node root() const { return document_.document_element(); }
    /// What stands before the root: the declaration, comments, instructions.
    std::string_view prolog() const;
    /// The first element with this id, or none.
    pugi::xml_node with_id(std::string_view id) const;
    /// What `href`, or the older `xlink:href`, refers to in the file itself; none for anything else.
    pugi::xml_node target_of(const pugi::xml_node& node) const;
    /// The same for `url(#id)`.
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

/// Without its prefix: `svg:path` is a path.
std::string_view svg_local_name(const pugi::xml_node& node);

/// `href`, else `xlink:href`, without blanks around it.
std::string_view svg_href(const pugi::xml_node& node);

/// Of another namespace than that of SVG, so that no browser draws it: `sodipodi:namedview`, `i:pgf`.
bool is_foreign_to_svg(const pugi::xml_node& node);

/// By the attributes that `switch` chooses by: no extension is known, and the language is English.
bool is_offered_by_svg(const pugi::xml_node& node);

}  // namespace ripstop
