#pragma once

#include <string>
#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// A tape, rope or wire by the length.
struct TapeMaterial {
    double stiffness = 80e3;  ///< EA [N]: force a unit of stretch
    double strength = 10e3;   ///< at which it breaks [N]
    double mass = 0.03;       ///< [kg/m]
};

/// A rope within the envelope between two points of it, as the drawing has them.
struct InnerTie {
    std::string name;
    Vec3 from = Vec3::Zero(), to = Vec3::Zero();  ///< [m]
    double length = 0;                            ///< at rest [m]; 0: as drawn
    TapeMaterial material = {};
};

/// How the mouth is held.
enum class MouthHold {
    automatic,  ///< by wires where load tapes end at the mouth, else held
    edge,       ///< its edge does not move
    wires,      ///< each load tape ends in a flying wire; the cloth between is free
};

/// What is beside the cloth when an envelope flies: tapes, wires, ties, rings.
struct Rigging {
    TapeMaterial load_tape = {};              ///< of the seams whose type takes one (`SeamType::tape`)
    double foreshortening = 0;                ///< load tapes are shorter than their seams by this ratio, in [0, 0.2]
    TapeMaterial wire = {500e3, 10e3, 0.05};  ///< a flying wire
    double wire_length = 3;                   ///< from mouth to burner frame, along the run of the tape [m]
    MouthHold mouth = MouthHold::automatic;
    bool crown_ring = true;  ///< the edge of the opening at the top keeps its place in plan and rises and sinks freely
    bool crown_closed = true;  ///< a parachute valve of the same cloth closes it: it takes the pressure there
    std::vector<InnerTie> ties = {};
    std::vector<std::string> diaphragms = {};  ///< globs of tiles inside the envelope, with gas on both sides
};

}  // namespace ripstop
