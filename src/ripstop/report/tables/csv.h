#pragma once

#include <string>
#include <vector>

namespace ripstop {

/// Adds a line of comma-separated values (RFC 4180): fields with a comma, quote or line end are quoted; LF ends
/// the line. A text that a spreadsheet would evaluate (it begins with = + - @, a tab or CR) gets an apostrophe in
/// front.
void add_csv_line(std::string& text, const std::vector<std::string>& fields);

/// A figure for such a file, with a decimal point. It has at most seven digits, at most six of them decimals,
/// without trailing zeros, which is finer than cloth can be cut. Empty if it is not finite.
std::string csv_figure(double value);

}  // namespace ripstop
