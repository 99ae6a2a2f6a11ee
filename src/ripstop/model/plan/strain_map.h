#pragma once

#include <Eigen/Core>

namespace ripstop {

/// The strain of each triangle of a tile's cloth (#T each), as ratios and radians, relative to its target
/// (`target_triangles`). NaN if the triangle is flipped.
struct StrainMap {
    Eigen::VectorXd warp, weft;  ///< strain along warp and weft: positive where the cloth must stretch
    Eigen::VectorXd shear;       ///< change of the right angle between warp and weft [rad], signed
    Eigen::VectorXd area;        ///< area on the cloth over area on the surface, minus 1
};

}  // namespace ripstop
