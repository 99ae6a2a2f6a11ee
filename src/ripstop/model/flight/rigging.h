#pragma once

#include <string>
#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// The properties of a tape, rope or wire per length.
struct TapeMaterial {
    double stiffness = 80e3;  ///< EA [N]: force per unit strain
    double strength = 10e3;   ///< breaking force [N]
    double mass = 0.03;       ///< [kg/m]
};

/// A rope inside the envelope between two points, as drawn.
struct InnerTie {
    std::string name;
    Vec3 from = Vec3::Zero(), to = Vec3::Zero();  ///< [m]
    double length = 0;                            ///< length at rest [m]; 0: the drawn length
    TapeMaterial material = {};
};

/// How the mouth is held.
enum class MouthHold {
    automatic,  ///< by wires if load tapes end at the mouth, otherwise by its edge
    edge,       ///< the edge of the mouth is fixed
    wires,      ///< each load tape ends in a flying wire; the cloth between is free
};

/// The rigging of an envelope in flight: tapes, wires, ties and rings.
struct Rigging {
    TapeMaterial load_tape = {};  ///< for seams whose type has a tape (`SeamType::tape`)
    double foreshortening = 0;    ///< fraction by which load tapes are shorter than their seams, in [0, 0.2]
    TapeMaterial wire = {500e3, 10e3, 0.05};  ///< a flying wire
    double wire_length = 3;                   ///< from the mouth to the burner frame, in the direction of the tape [m]
    MouthHold mouth = MouthHold::automatic;
    bool crown_ring = true;    ///< the edge of the top opening keeps its x and y and moves freely up and down
    bool crown_closed = true;  ///< a parachute valve of the same cloth closes the opening and bears the pressure there
    std::vector<InnerTie> ties = {};
    std::vector<std::string> diaphragms = {};  ///< glob patterns of tiles inside the envelope, with gas on both sides
};

}  // namespace ripstop
