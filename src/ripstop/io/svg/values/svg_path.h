#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ripstop/io/svg/values/svg_curve.h"

namespace ripstop {

/// The runs of a path's `d`, by the grammar of SVG 2: every command, absolute and relative, repeated without its
/// letter; numbers separated only by a sign or point (`1-2`, `.5.5`); flags of an arc joined to what follows (`a2
/// 2 0 01-2 2`). A run with a single point is left out. Throws InputError that begins with `place` if the text is
/// no path.
std::vector<SvgRun> svg_path(std::string_view d, const std::string& place);

/// The numbers of a list, separated by blanks and commas. Throws InputError that begins with `place`.
std::vector<double> svg_numbers(std::string_view text, const std::string& place);

/// Reads the next number and removes it from `rest`; false if there is none. Throws InputError for a malformed
/// number.
bool next_svg_number(std::string_view& rest, double& number, const std::string& place);

/// The number of characters of the number that `text` begins with: `1.5.5` begins with 1.5, `2e-3mm` with 2e-3,
/// `1em` with 1.
std::size_t svg_number_end(std::string_view text);

/// The text without surrounding blanks: those of XML and CSS, line ends included.
std::string_view svg_trimmed(std::string_view text);

/// The next word of `rest`, separated by such blanks; empty at the end. Removes it from `rest`.
std::string_view svg_next_word(std::string_view& rest);

}  // namespace ripstop
