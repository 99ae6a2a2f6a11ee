#pragma once

#include <optional>
#include <vector>

#include "ripstop/base/progress.h"
#include "ripstop/model/piece/marker.h"
#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// The roll, and the ways pieces may lie on it.
struct NestOptions {
    std::optional<double> roll_width = {};  ///< [m]; default: each fabric's own width
    double gap = 0.005;                     ///< between outlines [m]
    double grain_tolerance = 0;             ///< a piece may also be turned by up to this angle, either way [rad]
    bool may_turn = true;                   ///< by 180 degrees; false for a nap or a print: all pieces point to +x
    bool may_flip = false;                  ///< the cloth looks the same on both sides
    std::vector<double> part_lengths = {};  ///< lengths of cloth without a join, in order; the last one repeats [m]
    int rounds = 40;                        ///< of the search for a short marker; the run time is proportional
    int starts = 2;                         ///< number of searches from different initial orders; the best one is kept
    int threads = 0;                        ///< 0: one per core; does not change the result
    Progress progress = {};
};

/// Lays every piece `quantity` times, and its mirror image `quantity_mirrored` times, on the roll of its fabric
/// and colour. Each copy carries the drawing of the piece it becomes (`OwnPieces`). The warp runs along the roll,
/// in +x or, if turning is allowed, in -x. Outlines keep at least `gap` apart and stay within the width; no piece
/// lies across a join. A mirror image is cut as a mirrored outline, with the outside of the cloth up as for every
/// piece; if `may_flip`, any piece may lie face down instead, with its outline mirrored.
///
/// Outlines are offset by half the gap and compared row by row, with 400 rows or more across the width, so hollows
/// are used too (`ContactTable`, `search_order`). Finally all pieces slide together along the roll, in rows a
/// twenty-fourth as high. Holes of pieces are not used. Sets of many kinds are laid in batches of some hundred
/// kinds.
///
/// Pieces that are wider than the roll, or longer than the last length of cloth (the only one that repeats), are
/// refused with the reason; the others are laid. Throws InputError for an invalid width, gap or length, and for
/// more than 50,000 pieces. The same set and options give the same markers.
Markers nest_pieces(const PieceSet& set, const NestOptions& options = {});

}  // namespace ripstop
