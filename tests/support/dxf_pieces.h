#pragma once

#include <string>
#include <utility>
#include <vector>

#include "ripstop/io/dxf/dxf.h"
#include "ripstop/model/piece/pattern_piece.h"

/// Pieces that use all a DXF can show, and the groups of what is written.
namespace ripstop::testing {

/// A rectangle of edges with 10 mm of cloth beyond them, a single and a double notch on the right edge, a line that is
/// drawn, two of it cut and one of it mirrored; the lower left corner of the sew line in `at`.
PatternPiece sample_piece(const std::string& name, const Vec2& at = Vec2::Zero(), const Vec2& size = {0.4, 0.25});

/// `sample_piece` beside a disk without corners, a narrow one, and a gore with curved edges: all that dialects differ in.
std::vector<PatternPiece> sample_pieces();

using DxfPairs = std::vector<std::pair<int, std::string>>;

std::string dxf_of(const std::vector<PatternPiece>& pieces, const std::string& dialect, DxfOptions options = {});

/// The groups of a DXF that is written with CR LF; fails the test where a line ends otherwise.
DxfPairs dxf_pairs(const std::string& text);

/// The entities of a kind, each with its groups; of all kinds where none is given. VERTEX and SEQEND are entities too.
std::vector<DxfPairs> dxf_entities(const DxfPairs& pairs, const std::string& kind = "");

/// The first value of a code; empty where there is none.
std::string value_of(const DxfPairs& entity, int code);

}  // namespace ripstop::testing
