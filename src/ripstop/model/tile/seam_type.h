#pragma once

#include <span>
#include <string>

#include "ripstop/base/text/units.h"

namespace ripstop {

/// How two edges are sewn together, or how a free edge is finished. Both edges get the same allowance; which edge is
/// folded over the other is a rule of the workshop, the same for the whole envelope.
struct SeamType {
    std::string name = "flat-felled";
    double allowance = 25 * millimetre;  ///< cloth beyond the sew line on each edge [m], not negative
    int rows = 2;                        ///< rows of stitching
    bool tape = false;                   ///< the seam carries a load tape

    bool operator==(const SeamType&) const = default;
};

/// The built-in types; the first is the default for seams. The widths follow the practice of balloon makers: an inch
/// for felled seams with two rows, which all of them sew, and half an inch for a plain seam as on paragliders.
///
///     flat-felled 25 mm   french 25 mm   taped 25 mm (felled, a load tape in it)   overlap 25 mm   plain 13 mm
///     hem 25 mm   mouth-hem 38 mm (round a webbing of an inch and a half, a tape in it)   raw 0 mm (cut on the line)
std::span<const SeamType> seam_types();

/// The default finish of a free edge: `hem`.
const SeamType& default_hem();

}  // namespace ripstop
