#pragma once

#include "ripstop/assembly/faults/judge_unit.h"
#include "ripstop/assembly/seams/find_seams.h"
#include "ripstop/model/plan/envelope_check.h"

namespace ripstop {

/// What an envelope is made of and what is wrong with it, from its geometry alone; nothing is solved.
///
/// Figures are those of the envelope as given. Each fault is named once, at the tile that is wrong: doubled tiles
/// first, then tiles turned over, then tiles shifted or scaled; each is mended in a copy and the seams are searched for
/// anew, so that what follows from it (missed neighbours, a hole) is not named again. What is then left are gaps and
/// missing tiles. Where most edges miss their mates by more than the tolerance one issue says so. What is sewn to
/// nothing else is usual, as vents, pockets, several envelopes or single sheets in a file: that is a note
/// (`EnvelopeCheck::meant`), for a tile that is away from its place leaves a hole there, which is an issue.
///
/// Where the unit is wrong (`doubt_unit`) that is named and nothing else, since no tolerance in millimetres means
/// anything then. The figures are those of the seams that `find_seams` finds all the same; where it refuses,
/// `seams_sought` is false. `unit` is that with which the envelope was read. Some searches (`find_seams`): a few
/// seconds for 5,000 tiles.
///
/// Seam types are counted as the envelope has them; fabrics are left to `count_fabrics`.
EnvelopeCheck check_envelope(const Envelope& envelope, const SeamOptions& options = {}, const UnitRead& unit = {});

/// A wrong unit as an issue.
EnvelopeIssue unit_issue(const UnitDoubt& doubt);

/// How many tiles are of which fabric; `standard`: of the tiles without one of their own.
std::vector<FabricUse> count_fabrics(const Envelope& envelope, const Fabric& standard);

}  // namespace ripstop
