#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ripstop/model/tile/cad_model.h"
#include "ripstop/model/tile/fabric.h"

/// Families of generated envelopes with various sizes, resolutions, orders, poses, units and cloths, and the
/// properties that must hold for each.
namespace ripstop::field {

struct Expected {
    std::optional<bool> manufacturable = true;  ///< empty: only that `check` and `flatten` agree
    bool is_isometric = false;                  ///< every tile flattens without strain
    double area_least = 0, area_most = 1e30;    ///< of all flat tiles [m²]
    std::optional<int> seams = {};
    std::optional<int> kinds = {};  ///< number of patterns; equal tiles share one
};

/// How a shape is passed to the program.
struct Variant {
    std::string name;
    bool remesh = false;      ///< `--remesh auto`, else never
    bool is_moved = false;    ///< rotated and shifted in space
    unsigned order = 0;       ///< seed that shuffles tiles and vertices; 0: unshuffled
    std::string unit = "";    ///< passed as an OBJ file in this unit, with a CAD's decimals; empty: in memory
    std::string fabric = "";  ///< a preset; empty: the default fabric
};

struct Case {
    std::string family;
    std::string name;
    std::vector<NamedMesh> tiles;  ///< [m]
    Expected expected;
    Variant variant = {};

    std::string text() const { return family + " " + name + " (" + variant.name + ")"; }
};

/// Every shape of every family, unmodified, in the order of the families.
std::vector<Case> field_shapes();

/// Each shape in 4 of 8 variants, chosen by its place in the list: at least 2,000 cases.
std::vector<Case> field_cases();

/// Runs a case as `check` and `flatten` do. Returns a sentence for each property that does not hold; empty if all
/// hold.
std::vector<std::string> failures_of(const Case& each);

}  // namespace ripstop::field
