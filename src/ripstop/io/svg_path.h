#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// A run of an SVG path from M to the next M, or to Z.
struct SvgRun {
    std::vector<Vec2> points;
    bool is_closed = false;
};

struct SvgPath {
    std::vector<SvgRun> runs;
    bool has_arcs = false;  ///< A commands, drawn as their chords
};

/// The runs of a path's `d`. Throws InputError that begins with `place` for what is no path.
SvgPath svg_path(std::string_view d, const std::string& place);

/// The numbers of a list between blanks and commas. Throws InputError that begins with `place`.
std::vector<double> svg_numbers(std::string_view text, const std::string& place);

/// The next number of `rest`, which moves on; false where there is none. Throws for what begins as a number and is none.
bool next_svg_number(std::string_view& rest, double& number, const std::string& place);

}  // namespace ripstop
