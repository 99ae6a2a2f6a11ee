#pragma once

#include <string>
#include <vector>

#include "ripstop/model/piece/marker.h"
#include "ripstop/model/piece/pattern_piece.h"

/// Pieces without an envelope, for nesting, and an independent check of the result.
namespace ripstop::testing {

PatternPiece loose_piece(const std::string& name, const Points2& outline);
PatternPiece rectangle_piece(const std::string& name, double length, double height);

/// A set of one fabric with these pieces.
PieceSet loose_set(std::vector<PatternPiece> pieces);

/// `count` different pieces like parts of gores: 1.5 to 4 m long, 0.25 to 0.85 m wide, 22 corners, both sides a
/// part of a sine. The same on every machine.
std::vector<PatternPiece> gore_like_pieces(int count);

/// The faults of markers, empty if there are none. Every copy of every piece must be laid once or refused, within
/// the roll, not across a join, with outlines at least `gap` apart. Distances are measured from every corner to
/// every side, crossings with exact predicates.
std::string faults_of(const PieceSet& set, const Markers& markers, double gap, const std::vector<double>& parts = {});

}  // namespace ripstop::testing
