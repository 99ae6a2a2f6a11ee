#pragma once

#include "ripstop/assembly/faults/judge_unit.h"
#include "ripstop/assembly/seams/find_seams.h"
#include "ripstop/model/plan/envelope_check.h"

namespace ripstop {

/// The parts of an envelope and its faults, from its geometry alone; nothing is solved.
///
/// Figures describe the envelope as given. Each fault is reported once, at the tile that causes it: first doubled
/// tiles, then tiles turned over, then tiles shifted or scaled. Each is mended in a copy and the seams are
/// searched again, so its consequences (missed neighbours, a hole) are not reported. Then gaps and missing tiles
/// remain. If most edges miss their mates by more than the tolerance, one issue says so. Groups of tiles that are
/// sewn to nothing else are usual (vents, pockets, several envelopes or single sheets in one file), so they give a
/// note (`EnvelopeCheck::meant`); a tile that is away from its place leaves a hole, which is an issue.
///
/// If the unit is wrong (`doubt_unit`), only that is reported, because no tolerance in millimetres means anything
/// then. The figures are still those of the seams that `find_seams` finds; if it refuses, `seams_sought` is false.
/// `unit` is the unit with which the envelope was read. The cost is that of several `find_seams`: a few seconds
/// for 5,000 tiles.
///
/// Seam types are counted as the envelope states them. `count_fabrics` counts the fabrics.
EnvelopeCheck check_envelope(const Envelope& envelope, const SeamOptions& options = {}, const UnitRead& unit = {});

/// The issue for a wrong unit.
EnvelopeIssue unit_issue(const UnitDoubt& doubt);

/// The number of tiles of each fabric. `standard` is the fabric of tiles that state none.
std::vector<FabricUse> count_fabrics(const Envelope& envelope, const Fabric& standard);

}  // namespace ripstop
