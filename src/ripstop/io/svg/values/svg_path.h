#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ripstop/io/svg/values/svg_curve.h"

namespace ripstop {

/// The runs of a path's `d`, by the grammar of SVG 2: every command absolute and relative, repeated without its letter,
/// numbers that only a sign or point parts (`1-2`, `.5.5`), the flags of an arc joined to what follows (`a2 2 0 01-2
/// 2`). A run of a lone point is left out. Throws InputError that begins with `place` for what is no path.
std::vector<SvgRun> svg_path(std::string_view d, const std::string& place);

/// The numbers of a list between blanks and commas. Throws InputError that begins with `place`.
std::vector<double> svg_numbers(std::string_view text, const std::string& place);

/// The next number of `rest`, which moves on; false where there is none. Throws for what begins as a number and is
/// none.
bool next_svg_number(std::string_view& rest, double& number, const std::string& place);

/// How many letters of a number `text` begins with: `1.5.5` begins with 1.5, `2e-3mm` with 2e-3, `1em` with 1.
std::size_t svg_number_end(std::string_view text);

/// Without the blanks at both ends: of XML and CSS, so ends of lines too.
std::string_view svg_trimmed(std::string_view text);

/// The next word of `rest` between such blanks; empty at the end. `rest` moves on.
std::string_view svg_next_word(std::string_view& rest);

}  // namespace ripstop
