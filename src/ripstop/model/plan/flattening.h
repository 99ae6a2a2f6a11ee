#pragma once

#include <optional>
#include <string>

#include "ripstop/base/solve_summary.h"
#include "ripstop/geometry/types.h"

namespace ripstop {

/// What a method that minimises under exact lengths can show of its result.
struct Certificate {
    double force_residual = 0;  ///< largest force out of balance, in mean stiffness times mean boundary edge
    double length_residual =
        0;  ///< largest |flat length / wanted length - 1| of a boundary edge; of an edge shorter than
            ///< 3e-5 of the outline its error in that
    bool strict_minimum =
        false;  ///< the energy rises in every direction that keeps the lengths (inertia of the last Newton system)
};

/// Where a tile's vertices lie on the cloth: +x the warp, +y the weft, the outside face up.
struct Flattening {
    Points2 positions;  ///< #V x 2 [m]
    SolveSummary summary;
    std::optional<Certificate> certificate = {};
    Eigen::VectorXd seam_tension =
        {};  ///< of each boundary edge, boundary[i] to boundary[i + 1]: the force that holds it
             ///< at its length, negative where it is pushed [N]; empty where no edge is held
    bool edges_on_curve =
        false;              ///< the boundary edges were held at lengths on their seams' curves (`target_lengths`);
                            ///< otherwise the method knew only the mesh, whose edges are chords of them
    std::string note = {};  ///< what the method has to say of this tile beside the figures; may be empty
};

}  // namespace ripstop
