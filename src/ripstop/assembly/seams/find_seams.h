#pragma once

#include <vector>

#include "ripstop/base/text/units.h"
#include "ripstop/model/tile/envelope.h"
#include "ripstop/model/tile/near_miss.h"

namespace ripstop {

/// Options of the search for seams.
struct SeamOptions {
    double tolerance = 0.5 * millimetre;  ///< edges to be sewn together lie within this distance [m], > 0
};

/// A part of a tile's boundary without a seam. It continues across corners as long as the edges are loose.
struct LooseRun {
    int tile = 0;
    double start = 0, end = 0;  ///< on the boundary: edge k covers k to k + 1; may run past the last edge
};

/// The ends of a seam on its two chains, as places on their curves (`ChainCurve`). They may run past the ends of
/// loops.
struct RunEnds {
    double start_a = 0, end_a = 0;  ///< ascending
    double start_b = 0, end_b = 0;  ///< ascending; b's start lies beside a's end
};

/// The result of the search for seams.
struct FoundSeams {
    /// `S0001`, … ordered by tile a and the place along its boundary; then the further sheets in them, in the same
    /// order.
    std::vector<Seam> seams;
    std::vector<Eigen::VectorXd> curve_lengths;  ///< for each tile, as `Tile::curve_lengths`
    std::vector<RunEnds> places;                 ///< for each seam
    std::vector<LooseRun> loose;                 ///< longer than a tolerance, ordered by tile
    std::vector<NearMiss> near_misses;           ///< pairs of loose edges beside each other, beyond the tolerance
    std::vector<NearMiss> same_way;  ///< pairs of loose edges that run the same way, because one tile is turned over
};

/// Finds the seams of an envelope from the geometry of its boundaries alone.
///
/// Two runs of chains form a seam if every vertex of either lies within the tolerance of the other's smooth curve
/// (`ChainCurve`), the runs have opposite directions, they are at least four tolerances long, and they end as
/// seams do (`find_well_ended`), which edges that merely cross do not. The two sides need not share vertices. A
/// run ends where either chain ends, which may be anywhere along an edge of the other (a T-junction). Both sides
/// may belong to one tile (a cone cut open, a dart). Of runs that lie on one another, the longest is the seam, so
/// no place is sewn twice. If they do so along most of the shorter one, as where three or more sheets meet on an
/// edge, the skin's run is the seam (`order_sheets`).
///
/// A run that lies on a seam without being sewn is a further sheet of that seam (`Seam::into`), if it covers at
/// least a quarter of the shorter of its chain and the seam: a rib, a fin, a diaphragm. Edges of the seam's own
/// tiles, such as the layers of a pleat, are not; two of those form their own seam. A further sheet has one record
/// for each seam it lies on. Its length is that of the seam's curve: edge by edge if both have the same vertices,
/// else by projection.
///
/// Both sides are measured on one curve, so their sums agree. If their vertices coincide (within 1e-6 of the
/// length), this is the polyline, and edges keep their own lengths. Otherwise it is the smooth curve of the side
/// with more edges, and the other side's vertices are projected onto it. `uncertainty` bounds what the vertices
/// leave open:
///
///     |L_a - L_b| + sum over the edges of s phi^2 / 2,  s = chord phi^2 / 24
///
/// Here L are the smooth lengths, and phi is the largest turn of an edge and its two neighbours. If the curve is
/// the polyline, the sum of s, by which it is too short, replaces |L_a - L_b|. The turn of a chain with one edge
/// is unknown; the turn of the surface's normal replaces phi, and the error may be as large as s.
///
/// Two places of one tile that its cloth joins straight across (`ClothAcross`), as at a tip or on the edges of a
/// narrow strip, are never sewn to each other.
///
/// A `NearMiss` is a pair of loose edges that run along each other within 20 tolerances or 5 % of the shorter
/// chain (`Reach`), over at least a quarter of that chain. It is reported and never sewn. Edges of two tiles miss
/// each other if they are closer than the width of the narrower tile; edges of one tile, if they are closer than a
/// tenth of its width; never if cloth joins them straight across, seams included.
///
/// Throws InputError for a tolerance that is not positive and finite, and if more than 40 chains have a median
/// length below twenty tolerances, as in a file read with the wrong unit. About linear in the number of boundary
/// edges: some seconds for 5,000 tiles.
FoundSeams find_seams(const std::vector<Tile>& tiles, const SeamOptions& options = {});

/// Sets the envelope's `seams` and its tiles' `curve_lengths` to the result of `find_seams`. Leaves them empty if
/// the tiles are too small for the tolerance, so that `check_envelope` can propose the right unit.
void add_seams(Envelope& envelope, const SeamOptions& options = {});

}  // namespace ripstop
