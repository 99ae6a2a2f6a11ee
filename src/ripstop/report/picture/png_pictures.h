#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ripstop/model/piece/pattern_piece.h"
#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/model/plan/strain_map.h"

namespace ripstop {

/// Maximum number of failing seams with a picture of their own: the worst ones.
inline constexpr std::size_t most_seam_pictures = 24;

/// Writes the views of report.html as PNG pictures into an existing folder, for e-mail and CI: envelope.png
/// (`envelope_png` in the page's first map) and envelope-MAP.png for each available map; NAME.png for each tile
/// (`tile_png`), with NAME from `file_stems`, prefixed by `tile-` if it begins like one of the others (`envelope`,
/// `seam-`, `tile-`); seam-ID.png (`seam_png`) for the worst failing seams; seams.png, the picture `seam_picture`.
///
/// Uses `threads` threads (0: one per core); their number does not change the bytes. Throws InputError if a file cannot
/// be written.
void write_png_pictures(const std::filesystem::path& folder, const CutPlan& plan,
                        const std::vector<PatternPiece>& pieces, const std::vector<StrainMap>& strains,
                        int threads = 0);

/// The failing seams that get pictures, as indices of `CutPlan::seams`: the worst first, by the distance between their
/// sides relative to the limit.
std::vector<std::size_t> pictured_seams(const CutPlan& plan);

}  // namespace ripstop
