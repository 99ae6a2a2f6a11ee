#pragma once

#include <string>

namespace ripstop {

/// The paper's colours, scaled to a tolerance and not to the largest value: from blue (no error) over green and
/// yellow to orange (at the tolerance). Red is beyond the tolerance, and nothing else is red.
inline constexpr int colour_classes = 32;
inline constexpr int beyond_class = colour_classes - 1;

/// The class of an error: `beyond_class` if it is above `limit` or not finite, else its size in 31sts of the
/// limit.
int colour_class(double error, double limit);

/// `#rrggbb`
std::string class_colour(int colour_class);

}  // namespace ripstop
