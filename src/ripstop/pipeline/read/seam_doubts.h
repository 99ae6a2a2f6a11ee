#pragma once

#include "ripstop/model/plan/envelope_check.h"
#include "ripstop/model/tile/envelope.h"
#include "ripstop/pipeline/remesh/remesh_envelope.h"

namespace ripstop {

/// Adds to a check what its seams leave in doubt, as flattening judges it.
///
/// A seam whose length the meshes leave open by more than the tolerance is the issue `uncertain`; value: that length
/// [m]. Only where one is, the envelope is remeshed as flattening would remesh it, for that may make it certain: then
/// it is no issue.
///
/// Edges that zigzag (`find_zigzags`) go into `EnvelopeCheck::zigzags`, and the highest teeth into a note: whether
/// their curve keeps its length only flattening tells.
void add_seam_doubts(EnvelopeCheck& check, const Envelope& envelope, const RemeshOptions& remesh);

}  // namespace ripstop
