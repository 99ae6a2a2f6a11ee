#pragma once

#include <iosfwd>
#include <vector>

#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

struct HpglOptions {
    double frame = 0;  ///< along x [m]; 0: no frames
};

/// Writes the pieces as HPGL for plotters and cutters. Uses only IN, PS, SP, PU, PD and FR; absolute coordinates,
/// 40 units per millimetre (0.025 mm), x along the warp, y up, as seen on the outside of the cloth, not mirrored.
/// A command has at most 16 points.
///
/// For each piece, pen 1 draws the sew line, internal lines, the grain arrow and the letters. Letters are
/// outlines, so any plotter can write any name. Then pen 3 cuts the notches and pen 2 the cut line (or the sew
/// line of a piece without one). At the end pen 1 draws the square of 100 mm, right of the pieces.
///
/// Without frames, the lower left corner of the drawing is 0,0 and coordinates may be large: HP-GL/2 counts to
/// 2^23, 209 m. `PS` states the length and width of the plot. Plotters of the first HP-GL count to 32,767 only,
/// 819 mm. For them `frame` splits all lines at the frames' ends, and `FR` advances the paper by one frame, to
/// which the plotter must be set. 0,0 is then the middle of each frame, as on large plotters of that kind, and
/// `PS` is absent.
///
/// Throws InputError if the drawing exceeds these limits. `shifts` is as in `make_sheet`.
void write_hpgl(std::ostream& out, const std::vector<PatternPiece>& pieces, const std::vector<Vec2>& shifts = {},
                const HpglOptions& options = {});

}  // namespace ripstop
