#pragma once

#include <string>
#include <string_view>

namespace ripstop {

inline constexpr double millimetre = 1e-3;  ///< [m]
inline constexpr double percent = 1e-2;
inline constexpr double degree = 0.017453292519943295;  ///< [rad]

/// A unit of length and its size in metres.
struct LengthUnit {
    std::string name = "m";
    double metres = 1;  ///< metres in one unit
};

/// Metres in one `unit`: mm, cm, m, in or ft. Throws InputError that lists the known units.
double metres_per_unit(std::string_view unit);

/// Parses a length with its unit, such as `12mm` or `1.5 m`, and returns metres. A bare number is refused: a length
/// without a unit is how cloth gets cut twelve times too large. Throws InputError that names `what`.
double parse_length(std::string_view text, const std::string& what);

}  // namespace ripstop
