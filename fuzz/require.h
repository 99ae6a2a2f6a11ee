#pragma once

#include <cstdlib>

namespace ripstop::fuzzing {

/// Ends the program where a property of a fuzz target does not hold.
inline void require(bool holds) {
    if (!holds) std::abort();
}

}  // namespace ripstop::fuzzing
