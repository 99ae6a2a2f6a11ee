#pragma once

#include <string>
#include <vector>

#include "ripstop/model/tile/cad_model.h"
#include "ripstop/model/tile/tile.h"
#include "ripstop/tile/make_tile.h"

namespace ripstop {

/// Whether a curve shows the yarn direction: it, its layer or a parent layer is named GRAIN, WARP or like one of
/// `layers`, regardless of case.
bool is_grain_line(const NamedCurve& curve, const std::vector<std::string>& layers = {});

/// Gives each surface with a grain line the attribute `warp`: the direction from the line's start to its end (`x, y,
/// z`). It takes precedence over what the file says otherwise. A line belongs to the surface nearest to it, measured at
/// its points and midpoints, if the distance is within 1/50 of its length. Returns a sentence for each line that lies
/// on no surface, has equal ends, or is the second one on its surface. O(#lines x #F) for surfaces whose box holds the
/// line.
std::vector<std::string> lay_grain_lines(CadModel& model, const std::vector<std::string>& layers = {});

/// The warp that came with a surface, as options of its tile: the attribute `warp`, else the field of its triangles.
/// Throws InputError if the attribute is not a direction.
void take_warp(const NamedMesh& surface, TileOptions& options);

}  // namespace ripstop
