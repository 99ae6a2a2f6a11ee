#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace ripstop {

/// The colours of report.html, told apart by nearly everyone: apps/report/src/palette.js, and a test that both say the
/// same. They are pinned to a limit: white is none, full blue is -1 of it, full orange +1; what is beyond has dark
/// colours of its own. A colour is a place in a table.
namespace page_places {
inline constexpr std::uint16_t below = 0, first = 1, steps = 256, above = 257, flipped = 258, unknown = 259,
                               count = 260;
}

/// The place of a value in shares of its limit; not a number is `flipped`.
std::uint16_t page_place(double share);

/// 0xRRGGBB of each place.
const std::array<std::uint32_t, page_places::count>& page_colours();

/// `#rrggbb`
std::string page_colour(std::uint16_t place);

}  // namespace ripstop
