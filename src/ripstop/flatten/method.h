#pragma once

#include <span>
#include <string>
#include <vector>

#include "ripstop/base/progress.h"
#include "ripstop/model/plan/flattening.h"
#include "ripstop/model/tile/envelope.h"
#include "ripstop/model/tile/fabric.h"

namespace ripstop {

/// A way to flatten. The command line, the benchmarks and the property tests all walk this table, so a method is
/// compared, timed and tested by being listed.
struct Method {
    const char* name;
    const char* origin;  ///< what it comes from, a line for `ripstop methods`
    Flattening (*flatten)(const Tile& tile, const Fabric& fabric);  ///< a tile on its own

    /// The tiles of an envelope together, on so many threads (0: one a core), for a method to which its seams matter;
    /// null where each tile is flattened on its own. A tile's own fabric goes before `fabric`.
    std::vector<Flattening> (*flatten_together)(const Envelope& envelope, const Fabric& fabric, int threads,
                                                const Progress& progress) = nullptr;
};

/// The table of methods, in the order in which `ripstop methods` lists them.
std::span<const Method> methods();

/// Throws InputError with the list of names where there is none such.
const Method& method_named(const std::string& name);

}  // namespace ripstop
