#pragma once

#include <vector>

#include "ripstop/model/piece/pattern_piece.h"
#include "ripstop/pattern/cut/cut_line.h"

/// Pieces whose outline faces itself: slits, keyholes, rings that are cut open.
namespace ripstop::testing {

/// Counter-clockwise edges from corner to corner, all hemmed with one allowance.
std::vector<AllowedEdge> hemmed(const std::vector<Points2>& edges, double allowance);

/// A square of 0.8 m from the origin. From the middle of its lower side, a slit leads to a square opening of
/// `side`, whose lower side is at 0.25 m. A slit as wide as the opening is a slot.
std::vector<AllowedEdge> square_keyhole(double slit, double side, double allowance);
inline constexpr double keyhole_size = 0.8, keyhole_depth = 0.25;  // [m]

/// The same with a round opening of `radius` about (0.4, 0.4), one edge of 48 chords; the slit ends on the circle.
std::vector<AllowedEdge> round_keyhole(double slit, double radius, double allowance);

/// A ring about the origin with a hole of three tenths of its radius, covering `angle` when flat. Its ends are
/// seams, its rims hems. The order is outer rim, end, inner rim, end; each rim has 72 chords.
std::vector<AllowedEdge> open_ring(double angle, double allowance, double radius = 1);

/// A strip 1 m high with a notch in its upper side, 0.5 m deep, that opens by `angle` about (0, 0.5).
std::vector<AllowedEdge> notched_strip(double angle, double allowance);

/// The piece of these edges, cut by `make_cut_line`.
PatternPiece cut_piece(const std::vector<AllowedEdge>& edges);

/// The winding number of a closed line around a point, by the sum of the angles it subtends.
int turns_round(const Points2& line, const Vec2& point);

/// The piece with the lines that a file has for it, moved so that their lower left corner is the piece's own. The
/// lines may start anywhere and run in either direction.
PatternPiece as_written(const PatternPiece& piece, const Points2& cut_line, const Points2& sew_line);

}  // namespace ripstop::testing
