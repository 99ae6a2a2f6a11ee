#pragma once

#include <string>
#include <vector>

namespace ripstop {

/// Adds a line of comma-separated values (RFC 4180): fields with a comma, quote or line end in quotes; LF at the end.
/// A text that a spreadsheet would run as a formula (it begins with = + - @, a tab or CR) gets an apostrophe in front.
void add_csv_line(std::string& text, const std::vector<std::string>& fields);

/// A figure for such a file, with a decimal point; empty where it is not finite.
std::string csv_figure(double value);

}  // namespace ripstop
