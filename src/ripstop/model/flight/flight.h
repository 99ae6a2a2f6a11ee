#pragma once

#include "ripstop/model/flight/inflated.h"
#include "ripstop/model/flight/rigging.h"

namespace ripstop {

/// Which seams take a load tape.
enum class TapedSeams {
    by_type,    ///< seams whose type has one (`SeamType::tape`)
    meridians,  ///< those and every seam that runs up the envelope
    none,
};

/// The flight conditions of an envelope: the air and the rigging.
struct Flight {
    LoadCase load = {};
    Rigging rigging = {};
    TapedSeams tapes = TapedSeams::by_type;
};

}  // namespace ripstop
