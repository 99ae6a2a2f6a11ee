#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "ripstop/model/tile/fabric.h"

namespace ripstop {

/// Reads a fabric: one JSON object whose keys carry their unit.
///
///     name, warp_stiffness_n_per_m, weft_stiffness_n_per_m, shear_stiffness_n_per_m   required
///     description, poisson_warp_weft, mass_kg_per_m2, strength_n_per_m, roll_width_mm,
///     strain_limit_pct, shear_limit_deg                                               default as in `Fabric{}`
///
/// Throws InputError with the file's name (`name`) and the key, for an unknown or missing key, a value of the
/// wrong type, and whatever `require_valid` refuses.
Fabric read_fabric(std::istream& in, const std::string& name);

/// The fabric as JSON text with all keys in the order above and a final line end. `read_fabric` restores it up to
/// rounding.
std::string write_fabric(const Fabric& fabric);

/// The names of the fabrics that come with the program, sorted.
std::vector<std::string> fabric_presets();

/// The preset with this name, or the fabric in this file if the name ends in `.json`. Throws InputError with the
/// list of presets if there is neither.
Fabric fabric_named(const std::string& name_or_file);

}  // namespace ripstop
