#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ripstop {

/// The colours of a map. A colour is a place in a table: a value in shares of where its scale ends is white at 0, full
/// blue at -1, full orange at +1; what is beyond has dark colours of its own. Then what is flipped, what is not known,
/// and the states of cloth in flight (`ClothState`, in its order).
namespace page_places {
inline constexpr std::uint16_t below = 0, first = 1, steps = 256, above = 257, flipped = 258, unknown = 259, taut = 260,
                               count = 263;
}

/// The place of a value in shares of where its scale ends; not a number is `flipped`. Without `has_beyond` what lies
/// beyond has the place of the end.
std::uint16_t page_place(double share, bool has_beyond = true);

/// 0xRRGGBB of each place.
using PageColours = std::array<std::uint32_t, page_places::count>;

/// `safe`, told apart by nearly everyone, which the PNG pictures have; `paper`, by size alone, red only beyond.
struct PagePalette {
    std::string_view id, name;
    PageColours colours;
};
const std::vector<PagePalette>& page_palettes();

/// Those of the first palette.
const PageColours& page_colours();

/// `#rrggbb` of a place.
std::string page_colour(std::uint16_t place);

/// `rrggbb` of each place, one after the other.
std::string colours_text(const PageColours& colours);

}  // namespace ripstop
