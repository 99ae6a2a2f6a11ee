#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// The text of flat/sewing.json: the plan without its meshes and flat positions (flat/NAME.obj). For tiles: corners,
/// warp, fabric, lengths on their seams' curves, compensation and outcome (`outcome_json`). For seams: each edge with
/// its type. Then tape lengths, tolerances and findings. Lengths are in metres and read back as the same doubles.
/// `files` holds, for each tile, the stem of its mesh file. `reproducible` leaves out the seconds.
std::string sewing_json(const CutPlan& plan, const std::vector<std::string>& files, bool reproducible = true);

/// A plan without meshes and flat positions, and the stems of the tiles' files. `read_sewing` throws InputError with
/// the file and the place for anything but what `sewing_json` writes.
struct Sewing {
    CutPlan plan;
    std::vector<std::string> files;
    std::vector<std::vector<int>> corners;  ///< for each tile, the vertices at which its chains start
};
Sewing read_sewing(std::istream& in, const std::string& name);

}  // namespace ripstop
