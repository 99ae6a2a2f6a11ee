#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ripstop/model/tile/cad_model.h"
#include "ripstop/model/tile/fabric.h"

/// Families of made envelopes over sizes, resolutions, orders, poses, units and cloths, and what must hold of each.
namespace ripstop::field {

struct Expected {
    std::optional<bool> manufacturable = true;  ///< empty: only that `check` and `flatten` agree
    bool is_isometric = false;                  ///< every tile flattens without strain
    double area_least = 0, area_most = 1e30;    ///< of all flat tiles [m2]
    std::optional<int> seams = {};
    std::optional<int> kinds = {};  ///< patterns that are cut, equal tiles counted once
};

/// How the same shape reaches the program.
struct Variant {
    std::string name;
    bool remesh = false;      ///< `--remesh auto`, else never
    bool is_moved = false;    ///< turned and shifted in space
    unsigned order = 0;       ///< seed that shuffles tiles and vertices; 0: as made
    std::string unit = "";    ///< through an OBJ file of this unit and the decimals that a CAD writes; empty: in memory
    std::string fabric = "";  ///< a fabric that comes with the program; empty: the standard one
};

struct Case {
    std::string family;
    std::string name;
    std::vector<NamedMesh> tiles;  ///< [m]
    Expected expected;
    Variant variant = {};

    std::string text() const { return family + " " + name + " (" + variant.name + ")"; }
};

/// Every shape of every family as made, in the order of the families.
std::vector<Case> field_shapes();

/// Each shape in the variants that its place in the list gives it, 4 of 8: at least 2,000 cases.
std::vector<Case> field_cases();

/// Runs a case as `check` and `flatten` do. Returns what does not hold, a sentence each; empty: all holds.
std::vector<std::string> failures_of(const Case& each);

}  // namespace ripstop::field
