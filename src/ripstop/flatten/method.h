#pragma once

#include <span>
#include <string>

#include "ripstop/model/fabric.h"
#include "ripstop/model/flattening.h"
#include "ripstop/model/tile.h"

namespace ripstop {

/// A way to flatten a tile. The command line, the benchmarks and the property tests all walk this table, so a method is
/// compared, timed and tested by being listed.
struct Method {
    const char* name;
    const char* origin;  ///< what it comes from, a line for `ripstop methods`
    Flattening (*flatten)(const Tile& tile, const Fabric& fabric);
};

std::span<const Method> methods();

/// Throws InputError with the list of names where there is none such.
const Method& method_named(const std::string& name);

}  // namespace ripstop
