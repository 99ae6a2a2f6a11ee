#pragma once

#include <vector>

#include "ripstop/model/flight/inflated.h"
#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/model/tile/envelope.h"

namespace ripstop {

/// What the cloth of an envelope is to be: a target surface, which need not be the drawn one, and the strain that the
/// cloth is to have on it.
struct WantedCloth {
    std::vector<Points3> target;      ///< of each tile #V x 3 [m]
    std::vector<Points3> strain;      ///< of each tile #F x 3: E11, E22, 2 E12 along warp and weft
    std::vector<double> tape_strain;  ///< of each seam: e of its load tape, >= 0
};

/// The drawing itself, unstrained.
WantedCloth drawn_cloth(const Envelope& envelope);

/// Writes it into the tiles' compensation (`Compensation::strain`, `edges`), seen from the drawn surface. With C* = I +
/// 2 E* of the wanted strain and C_A the metric of the target triangle in the axes of the drawn one:
///
///     I + 2 E = C*^(1/2) C_A^-1 C*^(1/2)
///
/// Along a seam both sides get, place by place, the mean of what their triangles ask for. O(#F + #parts).
void compensate_tiles(const WantedCloth& wanted, Envelope& envelope);

/// Of each seam: how much longer than drawn its load tape is cut.
std::vector<double> tape_factors(const WantedCloth& wanted, const Envelope& envelope);

/// The strain C^-1 S of the cloth in flight, tile by tile.
std::vector<Points3> elastic_strain(const CutPlan& plan, const Inflated& inflated);

/// Of each seam of an inflated plan: the strain of its load tape in flight; 0 where slack or without one.
std::vector<double> tape_strains(const CutPlan& plan);

}  // namespace ripstop
