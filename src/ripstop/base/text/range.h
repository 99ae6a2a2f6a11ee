#pragma once

#include <cmath>
#include <string>

#include "ripstop/base/error.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"

namespace ripstop {

/// Throws InputError unless low <= value <= high (NaN fails). The message names the option, its value and its range.
inline void require_range(const std::string& option, double value, double low, double high, const std::string& unit) {
    if (value >= low && value <= high) return;
    const std::string end = unit.empty() ? "" : " " + unit;
    throw InputError("the " + option + " is " + format_shortest(value) + end + "; it must lie between " +
                     format_shortest(low) + " and " + format_shortest(high) + end);
}

/// The same for an angle in radians between 0 and `high` degrees; the message gives degrees.
inline void require_angle(const std::string& option, double value, double high) {
    if (!(value >= 0 && value <= high * degree)) require_range(option, value / degree, 0, high, "degrees");
}

/// Throws InputError unless `value` is finite and greater than `low`. The message names the option and its value.
inline void require_above(const std::string& option, double value, double low, const std::string& unit) {
    if (value > low && std::isfinite(value)) return;
    throw InputError("the " + option + " is " + format_shortest(value) + " " + unit + "; it must be greater than " +
                     format_shortest(low) + " " + unit);
}

}  // namespace ripstop
