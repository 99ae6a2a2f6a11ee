#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// A group of a DXF: its code and its value, without blanks at the ends. `text` of `DxfTags` must outlive it.
struct DxfTag {
    int code = 0;
    long line = 0;  ///< of the code
    std::string_view value;
};

using DxfTagSpan = std::span<const DxfTag>;

/// Throws InputError for the bytes of a binary DXF or a DWG, before anything looks for zero bytes in a text.
void require_ascii_dxf(std::string_view bytes, const std::string& name);

/// The text of an ASCII DXF as UTF-8: what is none is in the code page that $DWGCODEPAGE names (Latin-1 where that is
/// not known), and `\U+00E4` is one letter. Line for line as the file. Throws InputError for what is no text.
std::string dxf_text(std::string bytes, const std::string& name);

/// The name of a block or layer in capitals, by which it is found: names have no case, in Latin, Greek and Cyrillic.
std::string dxf_key(std::string_view symbol);

/// All groups of an ASCII DXF, the last being EOF; comments only before the first section. Throws InputError with
/// `name`, the line, what was found and what to do for a code that is no whole number and a file that ends before EOF.
/// O(size).
std::vector<DxfTag> read_dxf_tags(std::string_view text, const std::string& name);

/// One entity, from its code 0 to the next. What an object within it has (code 101) is not its own.
class DxfEntity {
  public:
    DxfEntity(DxfTagSpan tags, const std::string& name) : tags_(tags), name_(name) {}

    std::string_view type() const { return tags_.front().value; }
    long line() const { return tags_.front().line; }
    DxfTagSpan tags() const { return tags_; }
    /// The first value of a code; empty where there is none.
    std::string_view text(int code) const;
    std::string layer() const;
    /// Throws InputError where it is no number or larger than a number of a drawing can be (1e9).
    double number(int code, double otherwise = 0) const;
    double number(const DxfTag& tag) const;
    int flags(int code = 70) const;
    /// `code` and `code` + 10.
    Vec2 point(int code) const { return {number(code), number(code + 10)}; }
    /// And `code` + 20.
    Vec3 place(int code) const { return {number(code), number(code + 10), number(code + 20)}; }

  private:
    const DxfTag* find(int code) const;

    DxfTagSpan tags_;
    const std::string& name_;
};

/// The entity that begins at `tags`.
DxfEntity first_entity(DxfTagSpan tags, const std::string& name);

}  // namespace ripstop
