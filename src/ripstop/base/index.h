#pragma once

#include <cstddef>

namespace ripstop {

/// A vertex, face or row number as the containers of the standard library take it. Requires i >= 0.
constexpr std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

}  // namespace ripstop
