#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "ripstop/io/svg/style/svg_css.h"
#include "ripstop/io/svg/style/svg_document.h"

namespace ripstop {

/// The declared values of an element's properties, by name. Keeps only the properties that decide where a line is,
/// whether it is visible, and what else is drawn with it.
class SvgStyle {
  public:
    /// The declared value; empty if there is none.
    std::string_view operator[](std::string_view property) const;
    bool is_declared(std::string_view property) const { return values_.find(property) != values_.end(); }
    void set(const std::string& property, const std::string& value, long long priority);

  private:
    struct Value {
        std::string text;
        long long priority;
    };
    std::map<std::string, Value, std::less<>> values_;
};

/// A part of a style sheet that is not understood and that may hide or move lines.
struct SvgStyleDoubt {
    std::string text;
    long line = 0;
};

/// The style sheets of a drawing.
class SvgStyles {
  public:
    explicit SvgStyles(const SvgDocument& document);

    /// The style of an element by the CSS cascade: presentation attributes, rules by specificity and order, the
    /// `style` attribute, `!important`. Drops declarations that browsers do not understand: `r: -5px`, `transform:
    /// rotate(5)`, `visibility: never`.
    SvgStyle of(const pugi::xml_node& element) const;
    const std::vector<SvgStyleDoubt>& doubts() const { return doubts_; }

  private:
    std::vector<CssRule> rules_;
    std::vector<SvgStyleDoubt> doubts_;
};

}  // namespace ripstop
