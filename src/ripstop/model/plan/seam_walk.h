#pragma once

#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// A match mark: the same place of the seam curve on both sides, and the gap between them there.
struct MatchMark {
    double at = 0;     ///< arc length along the seam's curve from its start [m]
    double drift = 0;  ///< length of side b less that of side a on the cloth, from the seam's start to here [m]
};

/// The result of walking a seam on the cloth, both sides at once from its start: the mismatch a sewer finds when one
/// side is laid along the other.
struct SeamWalk {
    double length = 0;               ///< length of the seam's curve as drawn [m]
    double flat_a = 0;               ///< length of side a on the cloth [m]
    double flat_b = 0;               ///< length of side b on the cloth [m]
    std::vector<MatchMark> notches;  ///< evenly spaced, without the two ends
    double drift_max = 0;            ///< largest |drift| along the seam, its end included [m]
    double drift_max_at = 0;         ///< where that is, along the seam's curve [m]
    Vec3 worst = Vec3::Zero();       ///< the same place on the surface: the midpoint of side a's edge
    double limit = 0;                ///< largest permitted drift [m]
    double uncertainty = 0;          ///< uncertainty of the seam's length due to the meshes [m]
    bool ok = false;                 ///< drift_max <= limit

    /// Whether the meshes are fine enough to decide if the sides agree.
    bool is_certain() const { return uncertainty <= limit; }
    double mismatch() const { return flat_b - flat_a; }  ///< positive if side b is longer [m]
    double mismatch_ratio() const { return mismatch() / length; }
};

}  // namespace ripstop
