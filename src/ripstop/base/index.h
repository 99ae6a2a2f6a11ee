#pragma once

#include <concepts>
#include <cstddef>

namespace ripstop {

/// Converts a vertex, face or row number to the index type of the standard containers. Requires i >= 0.
template <std::integral Number>
constexpr std::size_t at(Number i) {
    return static_cast<std::size_t>(i);
}

}  // namespace ripstop
