#pragma once

#include <optional>
#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// An opening of a sew line that no cut line reaches.
struct LostOpening {
    Vec2 at = Vec2::Zero();  ///< on the sew line, in the middle of the opening [m]
    double length = 0;       ///< of the sew line around it [m]
    double width = 0;        ///< across it, at `at` [m]
};

/// Finds the largest opening of a closed sew line that no cut line passes through; nothing if every opening is
/// cut. For a place on the sew line, the largest empty ball outside that touches it also touches a second place.
/// If the two are apart (`SewContour::is_apart`, with the allowance that nine in ten places do not exceed), a cut
/// line must lie between the ball's centre and each of them. So ends of notches and corners that allowances close
/// are not openings. Tests some hundred places, O(#points) each.
std::optional<LostOpening> find_lost_opening(const Points2& sew_line, const std::vector<const Points2*>& cut_lines);

}  // namespace ripstop
