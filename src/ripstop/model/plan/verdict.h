#pragma once

#include <string>
#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// The deviations up to which a piece can be sewn. The first two are the paper's; strain and shear are limits of the
/// fabric.
struct Tolerances {
    double area = 0.01;           ///< |flat area / area - 1|
    double length = 0.001;        ///< of each chain and the perimeter: 0.001 is 1 mm per metre
    double strain = 0.02;         ///< limit of the warp and weft strain
    double shear = 0.1745;        ///< [rad]
    bool strain_for_all = false;  ///< the strain limit applies to every fabric; otherwise each fabric has its own
    bool shear_for_all = false;
};

/// A reason why a tile cannot be manufactured as drawn.
struct Finding {
    std::string code;        ///< stable, for machines: `area`, `perimeter`, `chain`, `flipped`, …
    std::string message;     ///< one sentence for the designer
    Vec3 at = Vec3::Zero();  ///< place on the surface [m]
    double value = 0;        ///< in the unit that the code implies: %, degrees or a count
    double limit = 0;
    int chain = -1;                       ///< index in `Tile::chains` if the finding concerns a chain
    std::vector<std::string> tiles = {};  ///< names, if the finding concerns the envelope as given
};

/// The judgement of a tile: it can be manufactured if and only if there is no finding. A new verdict is not judged,
/// and does not count as manufacturable.
struct Verdict {
    bool judged = false;
    std::vector<Finding> findings;
    std::vector<Finding> waived = {};  ///< edges that miss their drawn length but pass because their mates match them

    bool manufacturable() const { return judged && findings.empty(); }
};

}  // namespace ripstop
