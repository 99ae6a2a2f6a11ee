#pragma once

#include "ripstop/model/plan/envelope_check.h"
#include "ripstop/model/tile/envelope.h"
#include "ripstop/pipeline/remesh/remesh_envelope.h"

namespace ripstop {

/// Adds the doubts about the seams to a check, with the same judgement as flattening.
///
/// A seam whose length is uncertain by more than the tolerance becomes the issue `uncertain`; its value is that
/// uncertainty [m]. If there is one, the envelope is remeshed as flattening would remesh it; a seam that becomes
/// certain is not an issue.
///
/// Zigzag edges (`find_zigzags`) go into `EnvelopeCheck::zigzags`, and the highest teeth into a note. Only flattening
/// shows whether their curve keeps its length.
void add_seam_doubts(EnvelopeCheck& check, const Envelope& envelope, const RemeshOptions& remesh);

}  // namespace ripstop
