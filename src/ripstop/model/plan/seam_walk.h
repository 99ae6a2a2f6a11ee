#pragma once

#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// A match mark: the same place of the seam curve on both sides, and the gap between them there.
struct Notch {
    double at = 0;     ///< arc length along the seam's curve from its start [m]
    double drift = 0;  ///< side b less side a on the cloth, from the seam's start to here [m]
};

/// A seam walked on the cloth, both sides at once from its start: what the sewer finds when one is laid along the
/// other.
struct SeamWalk {
    double length = 0;           ///< of the seam's curve as drawn [m]
    double flat_a = 0;           ///< of side a on the cloth [m]
    double flat_b = 0;           ///< of side b
    std::vector<Notch> notches;  ///< evenly spaced, without the ends
    double drift_max = 0;        ///< largest |drift| anywhere along the seam, its end included [m]
    double drift_max_at = 0;     ///< along the seam's curve [m]
    Vec3 worst = Vec3::Zero();   ///< middle of side a's edge at that place, on the surface
    double limit = 0;            ///< what the drift may be [m]
    double uncertainty = 0;      ///< by how much the meshes leave the seam's length open [m]
    bool ok = false;             ///< drift_max <= limit

    /// Can the meshes tell whether the sides agree? A finer one makes it certain.
    bool is_certain() const { return uncertainty <= limit; }
    double mismatch() const { return flat_b - flat_a; }  ///< positive where side b is longer [m]
    double mismatch_ratio() const { return mismatch() / length; }
};

}  // namespace ripstop
