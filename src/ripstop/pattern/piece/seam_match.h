#pragma once

#include <optional>
#include <vector>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// A side of a seam on one tile and the side that lies at the same place of the pattern the tile is cut by.
struct SeamMatch {
    int seam = 0, pattern_seam = 0;  ///< in `CutPlan::seams`
    bool reversed = false;           ///< the one starts where the other ends
};

/// Where the seams of each tile begin and end on its cloth. O(#seams).
class SeamEnds {
  public:
    explicit SeamEnds(const CutPlan& plan);

    /// The seams of `tile` against those of `pattern`, whose flat shape is the same (`mirrored`: turned over) up to a
    /// shift and half a turn. Nothing unless each seam of the one ends where one of the other does, within a
    /// millimetre: else the notches of the pattern are in the wrong places. O(square of the tile's #seams).
    std::optional<std::vector<SeamMatch>> match(std::size_t tile, std::size_t pattern, bool mirrored) const;

  private:
    struct Run {
        int seam = 0;
        Vec2 start = Vec2::Zero(), end = Vec2::Zero();  ///< from the piece's middle
    };
    std::vector<std::vector<Run>> runs_;  ///< of each tile
};

/// How the marks of a seam run, so that they agree on all pieces that are cut by one pattern.
enum class MarkDirection {
    from_start,
    from_end,
    none,  ///< the pattern goes with the seam either way round: no mark may tell its ends apart
};

/// Of every seam of the plan. O(#seams).
std::vector<MarkDirection> mark_directions(const CutPlan& plan);

}  // namespace ripstop
