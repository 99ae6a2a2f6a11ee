#pragma once

#include <vector>

#include "ripstop/model/flight/inflated.h"
#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/model/tile/envelope.h"

namespace ripstop {

/// The wanted state of an envelope's cloth: a target surface, which may differ from the drawn one, and the strain of
/// the cloth on it.
struct WantedCloth {
    std::vector<Points3> target;      ///< per tile, #V x 3 [m]
    std::vector<Points3> strain;      ///< per tile, #F x 3: E11, E22, 2 E12 along warp and weft
    std::vector<double> tape_strain;  ///< per seam: strain e of its load tape, >= 0
};

/// The drawn surface without strain.
WantedCloth drawn_cloth(const Envelope& envelope);

/// Writes the wanted state into the tiles' compensation (`Compensation::strain`, `edges`), relative to the drawn
/// surface. With C* = I + 2 E* of the wanted strain and C_A the metric of the target triangle in the axes of the drawn
/// one:
///
///     I + 2 E = C*^(1/2) C_A^-1 C*^(1/2)
///
/// Along a seam, both sides get at each place the mean of what their triangles ask for. O(#F + #parts).
void compensate_tiles(const WantedCloth& wanted, Envelope& envelope);

/// For each seam, the ratio of the cut length of its load tape to the drawn length.
std::vector<double> tape_factors(const WantedCloth& wanted, const Envelope& envelope);

/// The strain C^-1 S of the cloth in flight, per tile.
std::vector<Points3> elastic_strain(const CutPlan& plan, const Inflated& inflated);

/// For each seam of an inflated plan, the strain of its load tape in flight; 0 if it is slack or there is none.
std::vector<double> tape_strains(const CutPlan& plan);

}  // namespace ripstop
