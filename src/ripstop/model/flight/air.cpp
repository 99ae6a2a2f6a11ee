#include "ripstop/model/flight/air.h"

#include <cmath>

#include "ripstop/base/error.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/range.h"

namespace ripstop {

double buoyancy(const Air& air) {
    require_range("inside temperature", air.inside, -90, hottest, "C");
    require_range("outside temperature", air.outside, -90, 300, "C");
    require_range("altitude", air.altitude, 0, 11000, "m");
    if (!(air.inside > air.outside))
        throw InputError("the inside temperature is " + format_shortest(air.inside) + " C, not above the outside " +
                         format_shortest(air.outside) + " C: there is no lift; give a hotter inside");
    constexpr double gas = 287.053;  // specific gas constant of dry air [J/(kg K)]
    const double pressure = 101325 * std::pow(1 - 0.0065 * air.altitude / 288.15, gravity / (gas * 0.0065));
    return gravity * pressure / gas * (1 / (air.outside + 273.15) - 1 / (air.inside + 273.15));
}

}  // namespace ripstop
