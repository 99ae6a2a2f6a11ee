#pragma once

#include <vector>

#include "ripstop/assembly/seams/find_seams.h"
#include "ripstop/model/plan/envelope_check.h"

namespace ripstop {

// Each of these names the faults of one kind and mends them in `tiles`, so that what follows from a fault is not named
// again: the search for seams is run anew on the mended tiles.

/// Tiles that lie on one another, whatever their meshes and whichever side is up: of each such pair the later one goes.
std::vector<EnvelopeIssue> remove_doubled(std::vector<Tile>& tiles, double tolerance);

/// Groups of tiles whose boundary runs the same way as that of larger neighbours: they are turned over.
std::vector<EnvelopeIssue> turn_back(std::vector<Tile>& tiles, const FoundSeams& found);

/// Tiles that fit their neighbours or a hole when they are moved, turned or scaled: they are. The one that misses most
/// neighbours goes first. A scale is 1/100 to 100 or that of a unit mistaken for another, and no tile is shrunk to a
/// speck on an edge. `found` are their seams, before and after; moves that sew less than before are none.
std::vector<EnvelopeIssue> move_back(std::vector<Tile>& tiles, FoundSeams& found, const SeamOptions& options);

/// The whole envelope where it is nearly closed and its volume is negative.
std::vector<EnvelopeIssue> name_inside_out(const std::vector<Tile>& tiles, const std::vector<LooseLoop>& loops);

/// What is left then: gaps, holes, and what is sewn to nothing, which is worth a note and no fault: `unsewn` where no
/// tile has a seam nor lies beside another, else `apart`, once for all groups that are sewn to nothing else.
/// `sewn_as_given`: there were seams before any fault was mended.
std::vector<EnvelopeIssue> name_gaps(const std::vector<Tile>& tiles, const FoundSeams& found, double tolerance);
std::vector<EnvelopeIssue> name_holes(const std::vector<Tile>& tiles, const FoundSeams& found, double tolerance);
std::vector<EnvelopeIssue> name_strays(const std::vector<Tile>& tiles, const FoundSeams& found, bool sewn_as_given);

/// The number of the group of each tile that seams hold together; groups are numbered by their first tile.
std::vector<int> sewn_groups(int tiles, const std::vector<Seam>& seams);

/// Words for messages: `12.3 mm`, `1.25 m`; `(1.23, 4.56, 7.89) m`; `a, b, c and 4 more`.
std::string length_text(double length);
std::string place_text(const Vec3& place);
std::string names_text(const std::vector<std::string>& names);

}  // namespace ripstop
