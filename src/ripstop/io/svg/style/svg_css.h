#pragma once

#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace ripstop {

struct CssDeclaration {
    std::string property, value;
    bool is_important = false;
};

/// The declarations of a `style` attribute or a block; properties in small letters, comments left out.
std::vector<CssDeclaration> css_declarations(std::string_view block);

/// What one element has to be: `path.cut#a[data-x="1"]:first-child`.
struct CssCompound {
    struct Attribute {
        std::string name;
        char test = 0;  ///< 0: it is there; `=`, or the letter before it in `~= |= ^= $= *=`
        std::string value;
    };
    std::string type = {}, id = {};  ///< empty: any
    std::vector<std::string> classes = {};
    std::vector<Attribute> attributes = {};
    std::vector<std::string> places = {};  ///< root, first-child, last-child, only-child
    char before = 0;                       ///< how the compound before it stands to it: blank, `>`, `+`, `~`; 0: none
};

/// A selector of compounds, the element's own last.
struct CssSelector {
    std::vector<CssCompound> compounds = {};
    int specificity = 0;  ///< 65536 for an id, 256 for a class, attribute or place, 1 for a type

    bool matches(const pugi::xml_node& element) const;
};

struct CssRule {
    std::vector<CssSelector> selectors = {};  ///< those that can match something in a drawing that lies still
    std::vector<CssDeclaration> declarations = {};
    std::string doubt = {};  ///< the selector or condition that is not understood, as it is written; empty: all is
};

/// The rules of a style sheet in their order. Understood are types, `*`, classes, ids, attributes, the places above,
/// lists and every combinator; `:hover` and its like never match. Rules for the screen and all media count, those for
/// other media (print) do not. Whatever else there is stands in `doubt`: other pseudo-classes, conditions, rules in
/// rules, `@import` (without declarations).
std::vector<CssRule> css_rules(std::string_view sheet);

}  // namespace ripstop
