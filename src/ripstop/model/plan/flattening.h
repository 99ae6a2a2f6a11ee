#pragma once

#include <optional>
#include <string>

#include "ripstop/base/solve_summary.h"
#include "ripstop/geometry/types.h"

namespace ripstop {

/// The optimality conditions of a result with exact lengths.
struct Certificate {
    double force_residual = 0;  ///< largest unbalanced force, relative to mean stiffness times mean boundary edge
    double length_residual =
        0;  ///< largest |flat length / wanted length - 1| of a boundary edge; for an edge shorter than 3e-5 of the
            ///< outline, its error relative to that length
    bool strict_minimum =
        false;  ///< the energy rises in every direction that keeps the lengths (inertia of the last Newton system)
};

/// The positions of a tile's vertices on the cloth: +x along the warp, +y along the weft, outside face up.
struct Flattening {
    Points2 positions;  ///< #V x 2 [m]
    SolveSummary summary;
    std::optional<Certificate> certificate = {};
    Eigen::VectorXd seam_tension =
        {};  ///< force that holds each boundary edge (boundary[i] to boundary[i + 1]) at its length, negative in
             ///< compression [N]; empty if no edge is held
    bool edges_on_curve =
        false;  ///< boundary edges were held at lengths measured on their seams' curves (`target_lengths`); otherwise
                ///< the method knew only the mesh, whose edges are chords of the curves
    std::string note = {};  ///< remark of the method on this tile; may be empty
};

}  // namespace ripstop
