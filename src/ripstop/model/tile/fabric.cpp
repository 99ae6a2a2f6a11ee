#include "ripstop/model/tile/fabric.h"

#include <cmath>

#include "ripstop/base/error.h"
#include "ripstop/base/text/number_text.h"

namespace ripstop {

void require_valid(const Fabric& fabric, const std::string& place) {
    const auto positive = [&place](double value, const char* what) {
        if (!(value > 0) || !std::isfinite(value))
            throw InputError(place + ": " + what + " is " + format_shortest(value) + ", expected a positive number");
    };
    positive(fabric.warp_stiffness, "the warp stiffness");
    positive(fabric.weft_stiffness, "the weft stiffness");
    positive(fabric.shear_stiffness, "the shear stiffness");
    positive(fabric.mass, "the mass");
    positive(fabric.strength, "the strength");
    positive(fabric.roll_width, "the roll width");
    positive(fabric.strain_limit, "the strain limit");
    positive(fabric.shear_limit, "the shear limit");
    if (!(fabric.poisson * fabric.poisson_weft() < 1) || !std::isfinite(fabric.poisson) || fabric.poisson < 0)
        throw InputError(place + ": Poisson's ratio is " + format_shortest(fabric.poisson) +
                         ", expected a number from 0 on whose product with its weft twin is below 1");
}

}  // namespace ripstop
