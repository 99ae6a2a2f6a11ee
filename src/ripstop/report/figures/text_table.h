#pragma once

#include <string>
#include <vector>

namespace ripstop {

/// The cells of one row.
using TextRow = std::vector<std::string>;

/// Rows as text for a terminal, columns two blanks apart, a line a row: the first `words` columns and the last to the
/// left, the figures between them to the right. Requires rows as long as the first. UTF-8.
std::string aligned_table(const std::vector<TextRow>& rows, std::size_t words);

/// The first letters of a name that would push all figures off the screen, and a point of suspension.
std::string shortened(const std::string& utf8);

}  // namespace ripstop
