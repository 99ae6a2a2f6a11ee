#pragma once

namespace ripstop {

inline constexpr double gravity = 9.80665;  ///< [m/s2]
inline constexpr double hottest = 300;      ///< that can be asked for [C]

/// The air inside and around the envelope.
struct Air {
    double inside = 100;  ///< temperature [C]
    double outside = 15;  ///< temperature [C]
    double altitude = 0;  ///< pressure altitude [m], 0 to 11000: the pressure of the standard atmosphere (ISA) there
};

/// b = g (rho_out - rho_in), rho = P / (287.053 T): the lift of a cubic metre, and the rise of the gauge pressure with
/// height [N/m3]. Throws InputError unless inside is hotter than outside and both lie in [-90, 300] C.
double buoyancy(const Air& air);

}  // namespace ripstop
