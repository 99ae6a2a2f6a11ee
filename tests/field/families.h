#pragma once

#include "field/field_case.h"

namespace ripstop::field {

/// Developable strips: straps around a cylinder, belts, curved hems.
std::vector<Case> straps();
std::vector<Case> belts();

/// Tiles sewn to themselves: tubes and cones that are cut open, and rings.
std::vector<Case> sleeves();
std::vector<Case> rings();
std::vector<Case> skirts();

/// Flat panels with an outline that nearly touches itself.
std::vector<Case> keyholes();

/// Gores of a sphere with points, short edges, openings or unwelded triangles at their tips.
std::vector<Case> gores();

/// Several sheets on one edge.
std::vector<Case> ribs();
std::vector<Case> fins();

/// Curved shapes on a flat floor, tents of equal segments, covers of strips.
std::vector<Case> pools();
std::vector<Case> tents();
std::vector<Case> covers();

}  // namespace ripstop::field
