#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ripstop/model/piece/pattern_piece.h"
#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/model/plan/strain_map.h"

namespace ripstop {

/// Failing seams that have pictures of their own: the worst.
inline constexpr std::size_t most_seam_pictures = 24;

/// Writes what report.html shows as PNG pictures into a folder that exists, for e-mail and CI: envelope.png
/// (`envelope_png` in the page's first map) and envelope-MAP.png for each map there is; NAME.png for each tile
/// (`tile_png`), NAME as `file_stems` says, after `tile-` where it begins like one of the others (`envelope`, `seam-`,
/// `tile-`); seam-ID.png (`seam_png`) for the worst failing seams; seams.png, the picture `seam_picture`.
///
/// On `threads` threads (0: one a core); the same bytes on any number of them. Throws InputError where a file cannot be
/// written.
void write_png_pictures(const std::filesystem::path& folder, const CutPlan& plan,
                        const std::vector<PatternPiece>& pieces, const std::vector<StrainMap>& strains,
                        int threads = 0);

/// The failing seams that get pictures, in `CutPlan::seams`: the worst first, by how far their sides are apart against
/// what is allowed.
std::vector<std::size_t> pictured_seams(const CutPlan& plan);

}  // namespace ripstop
