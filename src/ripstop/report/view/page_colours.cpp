#include "ripstop/report/view/page_colours.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr std::uint32_t unknown_colour = 0xe6e9ed;

/// Three colours that differ in lightness, in every palette.
constexpr std::array<std::uint32_t, 3> state_colours{0xf7f5ef, 0xe8923a, 0x2f3f8f};

std::uint32_t between_stops(const std::vector<std::uint32_t>& stops, double share) {
    const double at = share * static_cast<double>(stops.size() - 1);
    const std::size_t i = std::min(static_cast<std::size_t>(at), stops.size() - 2);
    std::uint32_t colour = 0;
    for (const int shift : {16, 8, 0}) {
        const double low = stops[i] >> shift & 0xff, high = stops[i + 1] >> shift & 0xff;
        const double channel = std::floor(low + (at - static_cast<double>(i)) * (high - low) + 0.5);
        colour |= static_cast<std::uint32_t>(channel) << shift;
    }
    return colour;
}

PageColours make_colours(const std::vector<std::uint32_t>& stops, std::uint32_t below, std::uint32_t above) {
    PageColours table{};
    table[page_places::below] = below;
    for (std::size_t i = 0; i < page_places::steps; ++i)
        table[page_places::first + i] = between_stops(stops, static_cast<double>(i) / (page_places::steps - 1));
    table[page_places::above] = above;
    table[page_places::flipped] = 0;
    table[page_places::unknown] = unknown_colour;
    std::copy(state_colours.begin(), state_colours.end(), table.begin() + page_places::taut);
    return table;
}

std::string hexadecimal(std::uint32_t colour) {
    std::string text;
    for (int shift = 20; shift >= 0; shift -= 4) text += "0123456789abcdef"[colour >> shift & 0xf];
    return text;
}

}  // namespace

std::uint16_t page_place(double share, bool has_beyond) {
    if (std::isnan(share)) return page_places::flipped;
    if (has_beyond && share < -1) return page_places::below;
    if (has_beyond && share > 1) return page_places::above;
    const double at = std::floor((std::clamp(share, -1.0, 1.0) + 1) / 2 * page_places::steps);
    return static_cast<std::uint16_t>(page_places::first + static_cast<int>(std::min(page_places::steps - 1.0, at)));
}

const std::vector<PagePalette>& page_palettes() {
    static const std::vector<PagePalette> palettes{
        {"safe", "Colour-blind safe",
         make_colours({0x1f5fbf, 0x8fbbe8, 0xf7f5ef, 0xf6b26b, 0xe06c00}, 0x101c4a, 0x5c0a1e)},
        {"paper", "Rainbow, red beyond",
         make_colours({0xf08c28, 0xf6d646, 0x56ba78, 0x38a6d6, 0x2c5cc8, 0x38a6d6, 0x56ba78, 0xf6d646, 0xf08c28},
                      0xce1826, 0xce1826)}};
    return palettes;
}

const PageColours& page_colours() {
    return page_palettes().front().colours;
}

std::string page_colour(std::uint16_t place) {
    return std::string("#").append(hexadecimal(page_colours()[place]));
}

std::string colours_text(const PageColours& colours) {
    std::string text;
    for (const std::uint32_t colour : colours) text += hexadecimal(colour);
    return text;
}

}  // namespace ripstop
