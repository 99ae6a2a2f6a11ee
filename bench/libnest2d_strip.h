#pragma once

#include <array>
#include <vector>

/// libnest2d on a strip, behind an interface for both C++17 and C++20, because its headers do not compile as
/// C++20.
using PlainOutline = std::vector<std::array<double, 2>>;

struct StripResult {
    std::vector<bool> is_laid;  ///< for each outline: whether it is in a bin and inside the strip
    double length = 0;          ///< [m]; further bins count as laid behind the first
    double seconds = 0;
};

/// Lays outlines (counter-clockwise, metres) on a strip, turned by 0 or 180 degrees. `accuracy` is libnest2d's, 0
/// to 1.
StripResult lay_with_libnest2d(const std::vector<PlainOutline>& outlines, double width, double gap, double accuracy);
