#pragma once

#include <span>
#include <string>

#include "ripstop/base/text/units.h"

namespace ripstop {

/// How two edges are sewn together, or an edge without mate is finished. The cloth beyond the sew line is cut as wide
/// on both edges; which of them is folded over the other is the workshop's rule, the same for the whole envelope.
struct SeamType {
    std::string name = "flat-felled";
    double allowance = 25 * millimetre;  ///< cloth beyond the sew line, on each edge [m], not negative
    int rows = 2;                        ///< rows of stitching
    bool tape = false;                   ///< it takes a load tape

    bool operator==(const SeamType&) const = default;
};

/// The types that come with the program, the default of a seam first. Widths are the practice of balloon makers: an
/// inch for the felled seams of two rows that all of them sew, a half for a plain one as on paragliders.
///
///     flat-felled 25 mm   french 25 mm   taped 25 mm (felled, a load tape in it)   overlap 25 mm   plain 13 mm
///     hem 25 mm   mouth-hem 38 mm (round a webbing of an inch and a half, a tape in it)   raw 0 mm (cut on the line)
std::span<const SeamType> seam_types();

/// Of an edge that is in no seam, unless something else is said: `hem`.
const SeamType& default_hem();

}  // namespace ripstop
