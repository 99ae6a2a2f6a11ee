#pragma once

#include <set>
#include <vector>

#include "ripstop/base/index.h"
#include "ripstop/model/flight/sewn_envelope.h"

namespace ripstop {

/// Records which points of an envelope coincide and which depend linearly on others. Points start free. Each may be
/// joined to another or tied to several; the remaining free points are the nodes. Dependencies never form a cycle, in
/// whatever order joints are added.
class Joints {
  public:
    Joints(int points, int sectors);

    /// Makes two places coincide. Returns false, without a change, if both already depend on other points and nothing
    /// is left to move. If the places are a point and its own image under a rotation, the point is kept on the axis.
    bool join(const SewnPoint& a, const SewnPoint& b);

    /// The place as a combination of points that are still free, each once.
    SewnPoint resolved(const SewnPoint& place) const;

    bool is_free(int point) const { return hangs_on_[at(point)].shares.empty(); }
    const std::set<int>& on_axis() const { return on_axis_; }

  private:
    /// Requires that `one` has a single term.
    bool replace(const SewnPoint& one, const SewnPoint& by);

    int sectors_;
    double angle_;                     ///< angle of a sector [rad]
    std::vector<SewnPoint> hangs_on_;  ///< dependency of each point; empty: free
    std::set<int> on_axis_;
};

}  // namespace ripstop
