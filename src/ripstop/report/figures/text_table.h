#pragma once

#include <string>
#include <vector>

namespace ripstop {

/// The cells of one row.
using TextRow = std::vector<std::string>;

/// Rows as text for a terminal: one line per row, columns separated by two blanks. The first `words` columns and
/// the last are left-aligned, the others right-aligned. All rows must have as many cells as the first. UTF-8.
std::string aligned_table(const std::vector<TextRow>& rows, std::size_t words);

/// The start of a name with an ellipsis, if it would push the figures off the screen.
std::string shortened(const std::string& utf8);

}  // namespace ripstop
