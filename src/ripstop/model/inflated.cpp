#include "ripstop/model/inflated.h"

#include <algorithm>

namespace ripstop {

bool Inflated::is_safe() const {
    return std::all_of(safety.begin(), safety.end(), [](const SafetyFactor& factor) { return factor.ok(); });
}

}  // namespace ripstop
