#pragma once

#include <optional>
#include <vector>

#include "ripstop/base/progress.h"
#include "ripstop/model/piece/marker.h"
#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// The roll, and how pieces may lie on it.
struct NestOptions {
    std::optional<double> roll_width = {};  ///< [m]; else each fabric's own
    double gap = 0.005;                     ///< between outlines [m]
    double grain_tolerance = 0;             ///< a piece may also lie turned by this much, either way [rad]
    bool may_turn = true;                   ///< by half a turn; not on cloth with a nap or a print: all +x one way
    bool may_flip = false;                  ///< the cloth has no right side
    std::vector<double> part_lengths =
        {};           ///< of cloth without a join, one after the other, the last again and again [m]
    int rounds = 40;  ///< of the search for a short marker; time grows with it
    int starts = 2;   ///< searches from different orders, the best of which counts
    int threads = 0;  ///< 0: one a core; never changes the result
    Progress progress = {};
};

/// Lays every piece `quantity` times, and its mirror image `quantity_mirrored` times, each with the drawing of the
/// piece it becomes (`OwnPieces`), on the roll of its fabric and colour: the warp along it, +x or, where turning is
/// allowed, -x; outlines at least `gap` apart and within the width; no piece over a join. A mirror image is cut as a
/// mirrored outline with the outside of the cloth up, as every piece; where `may_flip`, any may lie face down instead,
/// outline mirrored.
///
/// Outlines, grown by half the gap, are compared row by row, 400 rows over the width or more, so hollows are used too
/// (`ContactTable`, `search_order`); then all slide together along the roll in rows a twenty-fourth as high. Pieces as
/// cut have no holes. Sets of many kinds are laid some hundred kinds after the other.
///
/// Refused with the reason, and the others laid: what is wider than the roll or longer than the last length of cloth,
/// the only one that never ends. Throws InputError for a width, a gap or a length that is none, and for more than
/// 50,000 pieces. The same set and options give the same markers.
Markers nest_pieces(const PieceSet& set, const NestOptions& options = {});

}  // namespace ripstop
