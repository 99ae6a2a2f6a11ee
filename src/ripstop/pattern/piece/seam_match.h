#pragma once

#include <optional>
#include <vector>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// A side of a seam on one tile, and the side at the same place of the pattern that cuts the tile.
struct SeamMatch {
    int seam = 0, pattern_seam = 0;  ///< in `CutPlan::seams`
    bool reversed = false;           ///< one starts where the other ends
};

/// The ends of each tile's seams on its cloth. O(#seams).
class SeamEnds {
  public:
    explicit SeamEnds(const CutPlan& plan);

    /// Pairs the seams of `tile` with those of `pattern`, whose flat shape is the same (turned over if `mirrored`)
    /// up to a shift and half a turn. Returns nothing unless each seam ends where one of the other tile does,
    /// within a millimetre; the pattern's notches would be in the wrong places then. O(square of the tile's
    /// #seams).
    std::optional<std::vector<SeamMatch>> match(std::size_t tile, std::size_t pattern, bool mirrored) const;

  private:
    struct SeamRun {
        int seam = 0;
        Vec2 start = Vec2::Zero(), end = Vec2::Zero();  ///< relative to the piece's centre
    };
    std::vector<std::vector<SeamRun>> runs_;  ///< for each tile
};

/// The direction of a seam's marks, chosen so that it agrees on all pieces that one pattern cuts.
enum class MarkDirection {
    from_start,
    from_end,
    none,  ///< the pattern fits the seam either way round, so marks must not tell its ends apart
};

/// The direction for every seam of the plan. O(#seams).
std::vector<MarkDirection> mark_directions(const CutPlan& plan);

}  // namespace ripstop
