#pragma once

#include <cstddef>

namespace ripstop {

/// Converts a vertex, face or row number to the index type of the standard containers. Requires i >= 0.
constexpr std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

}  // namespace ripstop
