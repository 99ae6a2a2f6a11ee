#pragma once

#include <iosfwd>
#include <string>

#include "ripstop/model/special/special_shape.h"

namespace ripstop {

/// Reads a special shape from JSON: docs/special.md explains it, docs/special.schema.json describes it,
/// docs/special.example.json is one. Lengths are in millimetres, as their keys say.
///
/// Throws InputError with the file and the place in it for an unknown key, a key that the primitive's type does
/// not have, a missing key, a value of the wrong type, and whatever `require_valid` refuses.
SpecialShape read_special_shape(std::istream& in, const std::string& name);

}  // namespace ripstop
