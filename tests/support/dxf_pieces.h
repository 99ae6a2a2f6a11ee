#pragma once

#include <string>
#include <utility>
#include <vector>

#include "ripstop/io/dxf/dxf.h"
#include "ripstop/model/piece/pattern_piece.h"

/// Pieces that use every feature of a DXF, and the groups of the output.
namespace ripstop::testing {

/// A rectangle with 10 mm of allowance, a single and a double notch on the right edge, and a drawn line, of which
/// two copies are cut, and one mirrored. The lower left corner of the sew line is `at`.
PatternPiece sample_piece(const std::string& name, const Vec2& at = Vec2::Zero(), const Vec2& size = {0.4, 0.25});

/// `sample_piece`, a disk without corners, a narrow piece, and a gore with curved edges: they cover all
/// differences of dialects.
std::vector<PatternPiece> sample_pieces();

using DxfPairs = std::vector<std::pair<int, std::string>>;

std::string dxf_of(const std::vector<PatternPiece>& pieces, const std::string& dialect, DxfOptions options = {});

/// The groups of a DXF with CR LF; fails the test if a line ends otherwise.
DxfPairs dxf_pairs(const std::string& text);

/// The entities of a kind, each with its groups; of all kinds if none is given. VERTEX and SEQEND count as
/// entities.
std::vector<DxfPairs> dxf_entities(const DxfPairs& pairs, const std::string& kind = "");

/// The first value of a code; empty if it is absent.
std::string value_of(const DxfPairs& entity, int code);

}  // namespace ripstop::testing
