#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "ripstop/model/tile/fabric.h"

namespace ripstop {

/// A fabric from JSON: one object whose keys carry their unit.
///
///     name, warp_stiffness_n_per_m, weft_stiffness_n_per_m, shear_stiffness_n_per_m   required
///     description, poisson_warp_weft, mass_kg_per_m2, strength_n_per_m, roll_width_mm,
///     strain_limit_pct, shear_limit_deg                                               as in `Fabric{}`
///
/// Throws InputError naming the file (`name`) and the key for an unknown or missing key, a value of another kind, and
/// what `require_valid` refuses.
Fabric read_fabric(std::istream& in, const std::string& name);

/// The fabric as JSON text, all keys in the order above, with a line end; `read_fabric` gives it back to rounding.
std::string write_fabric(const Fabric& fabric);

/// The names of the fabrics that come with the program, sorted.
std::vector<std::string> fabric_presets();

/// The fabric of that name among the presets, else of the file of that path where it ends in `.json`. Throws InputError
/// with the list of presets where there is neither.
Fabric fabric_named(const std::string& name_or_file);

}  // namespace ripstop
