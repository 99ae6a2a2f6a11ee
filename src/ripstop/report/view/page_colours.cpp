#include "ripstop/report/view/page_colours.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr std::array<std::uint32_t, 5> stops{0x1f5fbf, 0x8fbbe8, 0xf7f5ef, 0xf6b26b, 0xe06c00};
constexpr std::uint32_t below_colour = 0x101c4a, above_colour = 0x5c0a1e, unknown_colour = 0xe6e9ed;

std::uint32_t between_stops(double share) {
    const double at = share * (stops.size() - 1);
    const std::size_t i = std::min(static_cast<std::size_t>(at), stops.size() - 2);
    std::uint32_t colour = 0;
    for (const int shift : {16, 8, 0}) {
        const double low = stops[i] >> shift & 0xff, high = stops[i + 1] >> shift & 0xff;
        const double channel = std::floor(low + (at - static_cast<double>(i)) * (high - low) + 0.5);
        colour |= static_cast<std::uint32_t>(channel) << shift;
    }
    return colour;
}

std::array<std::uint32_t, page_places::count> make_colours() {
    std::array<std::uint32_t, page_places::count> table{};
    table[page_places::below] = below_colour;
    for (std::size_t i = 0; i < page_places::steps; ++i)
        table[page_places::first + i] = between_stops(static_cast<double>(i) / (page_places::steps - 1));
    table[page_places::above] = above_colour;
    table[page_places::flipped] = 0;
    table[page_places::unknown] = unknown_colour;
    return table;
}

}  // namespace

std::uint16_t page_place(double share) {
    if (std::isnan(share)) return page_places::flipped;
    if (share < -1) return page_places::below;
    if (share > 1) return page_places::above;
    const double step = std::min(page_places::steps - 1.0, std::floor((share + 1) / 2 * page_places::steps));
    return static_cast<std::uint16_t>(page_places::first + static_cast<int>(step));
}

const std::array<std::uint32_t, page_places::count>& page_colours() {
    static const std::array<std::uint32_t, page_places::count> table = make_colours();
    return table;
}

std::string page_colour(std::uint16_t place) {
    const std::uint32_t colour = page_colours()[place];
    std::string text = "#";
    for (int shift = 20; shift >= 0; shift -= 4) text += "0123456789abcdef"[colour >> shift & 0xf];
    return text;
}

}  // namespace ripstop
