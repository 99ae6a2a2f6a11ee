#pragma once

#include <optional>
#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// An opening of a sew line that nothing cuts.
struct LostOpening {
    Vec2 at = Vec2::Zero();  ///< on the sew line, in its middle [m]
    double length = 0;       ///< of the sew line round it [m]
    double width = 0;        ///< across it, there [m]
};

/// The largest opening of a closed sew line that no cut line runs through. The largest ball outside that touches a
/// place of it meets another place; where the two are apart (`SewContour::is_apart`, with the allowance that nine in
/// ten places have at most) a cut line must lie between the ball's middle and either of them. So the ends of notches
/// and the corners that allowances close are none. Nothing where every opening is cut. At some hundred places,
/// O(#points) each.
std::optional<LostOpening> find_lost_opening(const Points2& sew_line, const std::vector<const Points2*>& cut_lines);

}  // namespace ripstop
