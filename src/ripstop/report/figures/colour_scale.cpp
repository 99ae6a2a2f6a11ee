#include "ripstop/report/figures/colour_scale.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ripstop {

int colour_class(double error, double limit) {
    const double share = std::abs(error) / limit;
    if (!(share <= 1)) return beyond_class;
    return std::min(beyond_class - 1, static_cast<int>(share * beyond_class));
}

std::string class_colour(int colour_class) {
    using Colour = std::array<double, 3>;
    constexpr std::array<Colour, 5> stops{Colour{44, 92, 200}, Colour{56, 166, 214}, Colour{86, 186, 120},
                                          Colour{246, 214, 70}, Colour{240, 140, 40}};
    constexpr Colour beyond{206, 24, 38};
    Colour colour = beyond;
    if (colour_class < beyond_class) {
        const double at = static_cast<double>(colour_class) / (beyond_class - 1) * (stops.size() - 1);
        const std::size_t i = std::min(stops.size() - 2, static_cast<std::size_t>(at));
        for (std::size_t k = 0; k < 3; ++k)
            colour[k] = stops[i][k] + (at - static_cast<double>(i)) * (stops[i + 1][k] - stops[i][k]);
    }
    std::string text = "#";
    for (const double channel : colour) {
        const auto value = static_cast<std::size_t>(std::lround(channel));
        text += "0123456789abcdef"[value / 16];
        text += "0123456789abcdef"[value % 16];
    }
    return text;
}

}  // namespace ripstop
