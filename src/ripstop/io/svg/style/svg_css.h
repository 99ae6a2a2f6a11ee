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

/// Parses the declarations of a `style` attribute or a block. Properties are in lower case; comments are dropped.
std::vector<CssDeclaration> css_declarations(std::string_view block);

/// The conditions on one element: `path.cut#a[data-x="1"]:first-child`.
struct CssCompound {
    struct Attribute {
        std::string name;
        char test = 0;  ///< 0: the attribute exists; `=`, or the character before it in `~= |= ^= $= *=`
        std::string value;
    };
    std::string type = {}, id = {};  ///< empty: any
    std::vector<std::string> classes = {};
    std::vector<Attribute> attributes = {};
    std::vector<std::string> places = {};  ///< root, first-child, last-child, only-child
    char before = 0;                       ///< combinator with the compound before it: blank, `>`, `+`, `~`; 0: none
};

/// A selector: compounds and combinators; the last compound is that of the element itself.
struct CssSelector {
    std::vector<CssCompound> compounds = {};
    int specificity = 0;  ///< 65536 for an id, 256 for a class, attribute or place, 1 for a type

    bool matches(const pugi::xml_node& element) const;
};

struct CssRule {
    std::vector<CssSelector> selectors = {};  ///< those that can match an element of a static drawing
    std::vector<CssDeclaration> declarations = {};
    std::string doubt = {};  ///< a selector or condition that is not understood, as written; empty: all is understood
};

/// Parses the rules of a style sheet, in their order. Supports types, `*`, classes, ids, attributes, the
/// pseudo-classes of `places`, lists and every combinator. `:hover` and the like never match. Rules for `screen`
/// and `all` media apply, those for other media (print) do not. `doubt` names what is not supported: other
/// pseudo-classes, conditions, nested rules and `@import` (without declarations).
std::vector<CssRule> css_rules(std::string_view sheet);

}  // namespace ripstop
