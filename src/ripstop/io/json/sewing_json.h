#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// flat/sewing.json: what of a plan its meshes (flat/NAME.obj) do not say and sewing needs: the tiles' corners, warp,
/// fabric, lengths on their seams' curves and what they are cut longer for; the seams edge by edge with their types;
/// tape lengths, tolerances. Lengths in metres, numbers read back to the same doubles. `files`: of each tile the stem
/// of its mesh file.
std::string sewing_json(const CutPlan& plan, const std::vector<std::string>& files);

/// A plan without meshes and flattenings, and the stems of the tiles' files. Throws InputError naming the file and the
/// place for anything but what `sewing_json` writes.
struct Sewing {
    CutPlan plan;
    std::vector<std::string> files;
    std::vector<std::vector<int>> corners;  ///< of each tile: the vertex each chain starts at
};
Sewing read_sewing(std::istream& in, const std::string& name);

}  // namespace ripstop
