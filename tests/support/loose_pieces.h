#pragma once

#include <string>
#include <vector>

#include "ripstop/model/piece/marker.h"
#include "ripstop/model/piece/pattern_piece.h"

/// Pieces of no envelope, for laying them on the roll, and a judge of how they were laid that knows nothing of how.
namespace ripstop::testing {

PatternPiece loose_piece(const std::string& name, const Points2& outline);
PatternPiece rectangle_piece(const std::string& name, double length, double height);

/// A set of one fabric with these pieces.
PieceSet loose_set(std::vector<PatternPiece> pieces);

/// `count` pieces like parts of gores, all different: 1.5 to 4 m long, 0.25 to 0.85 m wide, 22 corners, both sides a
/// part of a sine. The same on every machine.
std::vector<PatternPiece> gore_like_pieces(int count);

/// What is wrong with the markers, empty where nothing is: every copy of every piece laid once or refused, all within
/// the roll, none over a join, outlines at least `gap` apart. Distances are measured from every corner to every side,
/// crossings by exact orientations.
std::string faults_of(const PieceSet& set, const Markers& markers, double gap, const std::vector<double>& parts = {});

}  // namespace ripstop::testing
