#include "ripstop/model/flight/inflated.h"

#include <algorithm>

namespace ripstop {

bool Inflated::stands() const {
    return lift > 0 && volume > 0.5 * drawn_volume;
}

bool Inflated::is_safe() const {
    return stands() && !safety.empty() &&
           std::all_of(safety.begin(), safety.end(), [](const SafetyFactor& factor) { return factor.ok(); });
}

}  // namespace ripstop
