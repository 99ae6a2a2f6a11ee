#pragma once

#include <string>
#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// What a piece may deviate and still be sewn. The first two are the paper's; strain and shear are the fabric's own.
struct Tolerances {
    double area = 0.01;           ///< |flat area / area - 1|
    double length = 0.001;        ///< each chain and the perimeter: 1 mm on a metre
    double strain = 0.02;         ///< warp and weft
    double shear = 0.1745;        ///< [rad]
    bool strain_for_all = false;  ///< that strain holds for every fabric; else each has its own limit
    bool shear_for_all = false;
};

/// One reason why a tile cannot be made as drawn.
struct Finding {
    std::string code;        ///< stable, for machines: `area`, `perimeter`, `chain`, `flipped`, …
    std::string message;     ///< one sentence for the designer
    Vec3 at = Vec3::Zero();  ///< where on the surface [m]
    double value = 0;        ///< in the unit the code implies: %, degrees, a count
    double limit = 0;
    int chain = -1;                       ///< in `Tile::chains`, for what is said of a chain
    std::vector<std::string> tiles = {};  ///< by name, for what is said of the envelope as it was given
};

/// Manufacturable if and only if there is no finding. Born unjudged, which is not manufacturable.
struct Verdict {
    bool judged = false;
    std::vector<Finding> findings;
    std::vector<Finding> waived = {};  ///< edges off their drawn length that pass because their mates agree with them

    bool manufacturable() const { return judged && findings.empty(); }
};

}  // namespace ripstop
