#pragma once

#include <string>
#include <vector>

#include "ripstop/model/tile/cad_model.h"
#include "ripstop/model/tile/tile.h"
#include "ripstop/tile/make_tile.h"

namespace ripstop {

/// Whether a curve shows the yarn: it, its layer or a layer above is called GRAIN, WARP or as one of `layers`, in any
/// case.
bool is_grain_line(const NamedCurve& curve, const std::vector<std::string>& layers = {});

/// Gives each surface a grain line lies on the attribute `warp`: the way from the line's start to its end (`x, y, z`),
/// before what the file says otherwise. A line lies on the surface it is nearest to, seen at its points and their
/// middles, if that is within 1/50 of its length. Returns a sentence for each line that lies on none, that ends where
/// it starts, or that comes second to another on its surface. O(#lines x #F) for the surfaces whose box holds the line.
std::vector<std::string> lay_grain_lines(CadModel& model, const std::vector<std::string>& layers = {});

/// The warp a surface came with, as options of its tile: the attribute `warp`, else the field of its triangles. Throws
/// InputError for an attribute that is no direction.
void take_warp(const NamedMesh& surface, TileOptions& options);

}  // namespace ripstop
