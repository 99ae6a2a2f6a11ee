#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "ripstop/base/text/units.h"
#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// The unit an envelope's numbers are read in.
struct UnitRead {
    LengthUnit unit = {};
    bool is_files = false;       ///< the file states it
    bool size_is_meant = false;  ///< the designer says that the size is right
};

/// The reason to doubt the unit.
struct UnitDoubt {
    std::string sentence;
    double size = 0;        ///< of the envelope [m]
    double limit = 0;       ///< the limit that the size exceeds [m]
    bool is_wrong = false;  ///< true: an issue; false: only worth a look
};

/// Whether the size of these surfaces suggests another unit. Returns nothing if it does not, or if
/// `size_is_meant`.
///
/// A hot-air balloon is 5 to 60 m tall; a model of one, a tent or a boat cover measures at least half a metre. So
/// the unit is wrong above 100 m, and below 0.1 m if another unit would give one of these. It is worth a look in
/// two cases: above 60 m, if feet or inches would give a balloon; and if half of several tiles measure less than
/// 50 mm, which is twice the usual seam allowance of an inch, and another unit would give a balloon.
///
/// The proposed unit is the metric one that comes closest to a balloon, from half a metre to 100 m, else feet or
/// inches (below 100 m, the closest of all). Others that give a balloon are listed too. The outermost 2 % of the
/// tiles at either end are ignored, because one stray tile is no reason to doubt the unit. O(n log n).
std::optional<UnitDoubt> doubt_unit(const std::vector<Eigen::AlignedBox3d>& surfaces, const UnitRead& read);

}  // namespace ripstop
