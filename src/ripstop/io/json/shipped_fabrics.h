#pragma once

#include <span>
#include <string_view>

namespace ripstop {

/// A fabric of data/fabrics, which is part of the library.
struct ShippedFabric {
    std::string_view name, text;  ///< the file's name without `.json`, and the file
};

/// All of them, sorted by name. CMake writes this function (cmake/shipped_fabrics.cmake).
std::span<const ShippedFabric> shipped_fabrics();

}  // namespace ripstop
