#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ripstop {

/// The colours of a map, as indices of a table. A value relative to the end of its scale is white at 0, full blue at -1
/// and full orange at +1, with dark colours beyond. The last indices are flipped, unknown, and the states of cloth in
/// flight, in the order of `ClothState`.
namespace page_places {
inline constexpr std::uint16_t below = 0, first = 1, steps = 256, above = 257, flipped = 258, unknown = 259, taut = 260,
                               count = 263;
}

/// The index of a value relative to the end of its scale; `flipped` for NaN. Without `has_beyond`, values beyond get
/// the colour of the end.
std::uint16_t page_place(double share, bool has_beyond = true);

/// 0xRRGGBB for each index.
using PageColours = std::array<std::uint32_t, page_places::count>;

/// `safe` suits almost all forms of colour vision and is used by the PNG pictures; `paper` shows size only, red beyond.
struct PagePalette {
    std::string_view id, name;
    PageColours colours;
};
const std::vector<PagePalette>& page_palettes();

/// The colours of the first palette.
const PageColours& page_colours();

/// `#rrggbb` of an index.
std::string page_colour(std::uint16_t place);

/// `rrggbb` of each index, concatenated.
std::string colours_text(const PageColours& colours);

}  // namespace ripstop
