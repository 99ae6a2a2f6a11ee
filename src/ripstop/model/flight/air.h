#pragma once

namespace ripstop {

inline constexpr double gravity = 9.80665;  ///< [m/s2]
inline constexpr double hottest = 300;      ///< highest temperature that is accepted [C]

/// The air inside and around the envelope.
struct Air {
    double inside = 100;  ///< temperature inside [C]
    double outside = 15;  ///< temperature outside [C]
    double altitude = 0;  ///< pressure altitude [m], 0 to 11000; it gives the pressure of the standard atmosphere (ISA)
};

/// The buoyancy b = g (rho_out - rho_in) with rho = P / (287.053 T): the lift per cubic metre, and the gradient of
/// the gauge pressure with height [N/m3]. Throws InputError unless inside is hotter than outside and both lie in
/// [-90, 300] C.
double buoyancy(const Air& air);

}  // namespace ripstop
