#pragma once

#include <iosfwd>
#include <vector>

#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

struct HpglOptions {
    double frame = 0;  ///< length of a frame along x [m]; 0: all in one
};

/// Writes the pieces as HPGL for plotters and cutters: IN, PS, SP, PU, PD and FR alone, absolute, 40 units a millimetre
/// (0.025 mm), x along the warp, y up, seen on the outside of the cloth; nothing mirrored. Each piece in turn: pen 1
/// draws the sew line, internal lines, the grain arrow and the letters, as outlines, so that any name comes out on any
/// plotter; pen 3 cuts the notches; pen 2 the cut line last (the sew line of a piece without one). Pen 1 ends with the
/// square of 100 mm, right of the pieces. A command has at most 16 points.
///
/// Without frames the lower left corner of the drawing is 0,0 and coordinates are as long as it takes: HP-GL/2 counts
/// to 2^23, 209 m; `PS` says how long and wide the plot is. Plotters of the first HP-GL count to 32,767, 819 mm: for
/// them `frame` cuts all lines where a frame ends and `FR` advances the paper by one, which the plotter must be set to;
/// then 0,0 is the middle of each frame, as on the large ones of their kind, and there is no `PS`.
///
/// Throws InputError where the drawing goes beyond these limits. `shifts` as in `make_sheet`.
void write_hpgl(std::ostream& out, const std::vector<PatternPiece>& pieces, const std::vector<Vec2>& shifts = {},
                const HpglOptions& options = {});

}  // namespace ripstop
