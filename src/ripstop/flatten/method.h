#pragma once

#include <span>
#include <string>
#include <vector>

#include "ripstop/base/progress.h"
#include "ripstop/model/plan/flattening.h"
#include "ripstop/model/tile/envelope.h"
#include "ripstop/model/tile/fabric.h"

namespace ripstop {

/// A flattening method. The command line, the benchmarks and the property tests iterate over the table of methods, so
/// a method in the table is compared, timed and tested.
struct Method {
    const char* name;
    const char* origin;                                             ///< its source, one line for `ripstop methods`
    Flattening (*flatten)(const Tile& tile, const Fabric& fabric);  ///< flattens a single tile

    /// Flattens the tiles of an envelope together on `threads` threads (0: one per core), for a method that uses the
    /// seams; null if each tile is flattened on its own. A tile's own fabric takes precedence over `fabric`.
    std::vector<Flattening> (*flatten_together)(const Envelope& envelope, const Fabric& fabric, int threads,
                                                const Progress& progress) = nullptr;
};

/// The table of methods, in the order of `ripstop methods`.
std::span<const Method> methods();

/// Throws InputError with the list of names if there is no such method.
const Method& method_named(const std::string& name);

}  // namespace ripstop
