#pragma once

#include <vector>

#include "ripstop/assembly/seams/find_seams.h"
#include "ripstop/model/plan/envelope_check.h"

namespace ripstop {

// Each of these functions reports the faults of one kind and mends them in `tiles`. The caller then searches the
// seams of the mended tiles, so the consequences of a fault are not reported.

/// Removes the later tile of each pair that lies on one another, whatever their meshes and whichever side is up.
std::vector<EnvelopeIssue> remove_doubled(std::vector<Tile>& tiles, double tolerance);

/// Turns over groups of tiles whose boundary runs the same way as that of larger neighbours.
std::vector<EnvelopeIssue> turn_back(std::vector<Tile>& tiles, const FoundSeams& found);

/// Moves tiles to where they fit their neighbours or a hole after a motion and a change of scale. Begins with the
/// tile that misses most neighbours. A scale is 1/100 to 100, or the ratio of two units; no tile may shrink to a
/// speck on an edge. `found` holds the seams, before and after. Moves that sew less than before are rejected.
std::vector<EnvelopeIssue> move_back(std::vector<Tile>& tiles, FoundSeams& found, const SeamOptions& options);

/// Reports that the whole envelope is inside out: it is nearly closed and its volume is negative.
std::vector<EnvelopeIssue> name_inside_out(const std::vector<Tile>& tiles, const std::vector<LooseLoop>& loops);

/// Reports the remaining faults: gaps and holes. Adds notes for tiles that are sewn to nothing: `unsewn` if no
/// tile has a seam or lies beside another, else `apart`, one note for all groups. `sewn_as_given` is true if there
/// were seams before any fault was mended.
std::vector<EnvelopeIssue> name_gaps(const std::vector<Tile>& tiles, const FoundSeams& found, double tolerance);
std::vector<EnvelopeIssue> name_holes(const std::vector<Tile>& tiles, const FoundSeams& found, double tolerance);
std::vector<EnvelopeIssue> name_strays(const std::vector<Tile>& tiles, const FoundSeams& found, bool sewn_as_given);

/// For each tile, the number of its group of tiles connected by seams. Groups are numbered by their first tile.
std::vector<int> sewn_groups(int tiles, const std::vector<Seam>& seams);

/// Texts for messages: `12.3 mm`, `1.25 m`; `(1.23, 4.56, 7.89) m`; `a, b, c and 4 more`.
std::string length_text(double length);
std::string place_text(const Vec3& place);
std::string names_text(const std::vector<std::string>& names);

}  // namespace ripstop
