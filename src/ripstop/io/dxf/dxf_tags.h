#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// A group of a DXF: its code, and its value without surrounding blanks. The `text` that was parsed must outlive
/// it.
struct DxfTag {
    int code = 0;
    long line = 0;  ///< line of the code
    std::string_view value;
};

using DxfTagSpan = std::span<const DxfTag>;

/// Throws InputError if the bytes are a binary DXF or a DWG. Call it first, because the text readers refuse zero
/// bytes.
void require_ascii_dxf(std::string_view bytes, const std::string& name);

/// The text of an ASCII DXF as UTF-8, with the same lines. Text that is not UTF-8 is decoded by the code page of
/// $DWGCODEPAGE (Latin-1 if unknown), and `\U+00E4` becomes one letter. Throws InputError if the bytes are no
/// text.
std::string dxf_text(std::string bytes, const std::string& name);

/// The name of a block or layer in capitals, as a key: these names ignore case (Latin, Greek and Cyrillic).
std::string dxf_key(std::string_view symbol);

/// All groups of an ASCII DXF, the last being EOF. Comments are accepted before the first section only. Throws
/// InputError with `name`, the line, what was found and what to do, for a code that is not an integer and a file
/// that ends before EOF. O(size).
std::vector<DxfTag> read_dxf_tags(std::string_view text, const std::string& name);

/// One entity: the groups from its code 0 to the next. Groups of an embedded object (after code 101) are
/// excluded.
class DxfEntity {
  public:
    DxfEntity(DxfTagSpan tags, const std::string& name) : tags_(tags), name_(name) {}

    std::string_view type() const { return tags_.front().value; }
    long line() const { return tags_.front().line; }
    DxfTagSpan tags() const { return tags_; }
    /// The first value of a code; empty if it is absent.
    std::string_view text(int code) const;
    std::string layer() const;
    /// The number under a code, or `otherwise`. Throws InputError if it is not a number or beyond 1e9.
    double number(int code, double otherwise = 0) const;
    double number(const DxfTag& tag) const;
    int flags(int code = 70) const;
    /// The point under `code` and `code` + 10.
    Vec2 point(int code) const { return {number(code), number(code + 10)}; }
    /// The point under `code`, `code` + 10 and `code` + 20.
    Vec3 place(int code) const { return {number(code), number(code + 10), number(code + 20)}; }

  private:
    const DxfTag* find(int code) const;

    DxfTagSpan tags_;
    const std::string& name_;
};

/// The entity that begins at `tags`.
DxfEntity first_entity(DxfTagSpan tags, const std::string& name);

}  // namespace ripstop
