#pragma once

#include <Eigen/Core>

namespace ripstop {

/// What each triangle of a tile's cloth goes through (#T each), ratios and radians, against the cloth that is wanted
/// there (`target_triangles`). Not a number where the triangle is flipped.
struct StrainMap {
    Eigen::VectorXd warp, weft;  ///< strain along the threads: positive where the cloth must stretch
    Eigen::VectorXd shear;       ///< change of the right angle between them [rad], signed
    Eigen::VectorXd area;        ///< area on the cloth over area on the surface, less 1
};

}  // namespace ripstop
