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
    bool is_files = false;       ///< the file says so itself
    bool size_is_meant = false;  ///< the designer says that the size is right, whatever it is
};

/// Why the unit is in doubt.
struct UnitDoubt {
    std::string sentence;
    double size = 0;        ///< of the envelope [m]
    double limit = 0;       ///< what it is beyond [m]
    bool is_wrong = false;  ///< else only worth a look
};

/// Is the envelope of these surfaces so large or small that another unit is meant? Nothing where `size_is_meant`.
///
/// A hot-air balloon is 5 to 60 m tall, and a model of one, a tent or a boat cover half a metre at least. So the unit
/// is wrong beyond 100 m, and below 0.1 m where another unit would give one of these. It is worth a look from 60 m on
/// where feet or inches would give a balloon, and where half of several tiles measure less than 50 mm, twice the seam
/// allowance of an inch that is put on each of their edges, and another unit would give a balloon.
///
/// The unit named is the metric one that comes nearest to a balloon, from half a metre to 100 m, else feet or inches
/// (up to 100 m whichever comes nearest); others that give a balloon stand beside it. The outermost fiftieth of the
/// tiles at either end does not count: one tile gone astray is no reason to doubt the unit. O(n log n).
std::optional<UnitDoubt> doubt_unit(const std::vector<Eigen::AlignedBox3d>& surfaces, const UnitRead& read);

}  // namespace ripstop
