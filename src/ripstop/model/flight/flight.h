#pragma once

#include "ripstop/model/flight/inflated.h"
#include "ripstop/model/flight/rigging.h"

namespace ripstop {

/// Which seams take a load tape.
enum class TapedSeams {
    by_type,    ///< those whose type says so (`SeamType::tape`)
    meridians,  ///< these, and all that run up the envelope
    none,
};

/// How an envelope flies: what is in it and what is beside the cloth.
struct Flight {
    LoadCase load = {};
    Rigging rigging = {};
    TapedSeams tapes = TapedSeams::by_type;
};

}  // namespace ripstop
