#pragma once

#include <vector>

#include "ripstop/base/text/units.h"
#include "ripstop/model/tile/envelope.h"
#include "ripstop/model/tile/near_miss.h"

namespace ripstop {

/// How close edges must lie to be one seam.
struct SeamOptions {
    double tolerance = 0.5 * millimetre;  ///< edges to be sewn together lie within this [m], > 0
};

/// A run of a tile's boundary that is sewn to nothing, as long as a tile's loose edges go on over its corners.
struct LooseRun {
    int tile = 0;
    double start = 0, end = 0;  ///< on the boundary: edge k from k to k + 1; past the last one it begins again
};

/// Where a seam begins and ends on its two chains, as places on their curves (`ChainCurve`). Loops go on past theirs.
struct RunEnds {
    double start_a = 0, end_a = 0;  ///< ascending
    double start_b = 0, end_b = 0;  ///< ascending; b's start lies beside a's end
};

/// What lies beside what.
struct FoundSeams {
    std::vector<Seam> seams;  ///< `S0001`, … in the order of tile a and the place along its boundary; then the further
                              ///< sheets in them, in the same order
    std::vector<Eigen::VectorXd> curve_lengths;  ///< of each tile, as `Tile::curve_lengths`
    std::vector<RunEnds> places;                 ///< of each seam
    std::vector<LooseRun> loose;                 ///< longer than a tolerance, in the order of the tiles
    std::vector<NearMiss> near_misses;           ///< loose edges beside each other, beyond the tolerance
    std::vector<NearMiss> same_way;  ///< loose edges on edges that run the same way: one tile is turned over
};

/// The seams of an envelope, from the geometry of its boundaries alone.
///
/// Two runs of chains are a seam where every vertex of either lies within the tolerance of the other's smooth curve
/// (`ChainCurve`) and the two run against each other, for at least four tolerances, and that ends as a seam does
/// (`find_well_ended`): edges that merely cross are none. The two sides need not share
/// vertices; a run ends where either chain does, anywhere along an edge of the other (a T-junction); both sides may
/// be one tile's (a cone cut open, a dart). Where more runs lie on one another the longest is the seam, so that no
/// place is sewn twice; where they do along most of the shorter, as three or more sheets on an edge, the skin's
/// (`order_sheets`).
///
/// What of the others lies on a seam, and is sewn to nothing itself, is a further sheet of it (`Seam::into`), over at
/// least a quarter of the shorter of its chain and the seam: a rib, a fin, a diaphragm. Edges of a tile of that seam
/// itself, as the layers of a pleat, are none: two of them are a seam of their own. It has a record for each seam that
/// it lies on, and the length of that seam's curve, edge by edge where both have the same vertices, else by projection.
///
/// Both sides are measured on one curve, so the sums of their parts agree. Where their vertices coincide (within 1e-6
/// of the length) it is the polyline, and the edges keep their own lengths; else the smooth curve of the side with
/// more edges, onto which the other side's vertices are projected. `uncertainty` adds up what is unknown:
///
///     |L_a - L_b| + sum over the edges of s phi^2 / 2,  s = chord phi^2 / 24
///
/// with L the smooth lengths and phi the largest turn of an edge and its two neighbours; where the curve is the
/// polyline, the sum of s (by which it is short) in place of |L_a - L_b|. For a chain of one edge, whose turn nobody
/// sees, the turn of the surface's normal stands for phi, and the error may be as large as s.
///
/// Two places of one tile that its own cloth joins straight across (`ClothAcross`), as at a tip or on the two edges of
/// a narrow strip, are never sewn to each other.
///
/// A `NearMiss` is what stays loose and runs along another loose edge at less than 20 tolerances or 5 % of the shorter
/// chain (`Reach`), over at least a quarter of that chain: reported, never sewn. Edges of two tiles miss each other at
/// less than the width of the narrower, those of one tile at less than a tenth of its width, and none that cloth joins
/// straight across, seams and all.
///
/// Throws InputError for a tolerance that is not positive and finite, and where more than 40 chains have a median
/// length below twenty tolerances, as in a file read with the wrong unit. About linear in the number of boundary edges:
/// some seconds for 5,000 tiles.
FoundSeams find_seams(const std::vector<Tile>& tiles, const SeamOptions& options = {});

/// Sets the envelope's `seams` and the `curve_lengths` of its tiles to what `find_seams` finds; leaves them empty where
/// the tiles are too small for the tolerance, so that `check_envelope` may name the unit that is meant.
void add_seams(Envelope& envelope, const SeamOptions& options = {});

}  // namespace ripstop
