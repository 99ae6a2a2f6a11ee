#pragma once

#include <set>
#include <vector>

#include "ripstop/model/flight/sewn_envelope.h"

namespace ripstop {

/// Which points of an envelope are one, and which hang on others. Points start apart; each is joined to another or tied
/// to several, and what is left is free: the nodes. A point never comes to hang on itself, however joints are added.
class Joints {
  public:
    Joints(int points, int sectors);

    /// Makes two places the same place. False where both hang on other points already and nothing is left to move; then
    /// nothing changes. Where that place is one point turned about the axis onto itself, the point is kept on the axis.
    bool join(const Place& a, const Place& b);

    /// The place in points that are free so far, each once.
    Place resolved(const Place& place) const;

    bool is_free(int point) const { return hangs_on_[static_cast<std::size_t>(point)].empty(); }
    const std::set<int>& on_axis() const { return on_axis_; }

  private:
    /// `one` has a single part.
    bool replace(const Place& one, const Place& by);

    int sectors_;
    double angle_;                 ///< of a sector [rad]
    std::vector<Place> hangs_on_;  ///< of each point; empty: free
    std::set<int> on_axis_;
};

}  // namespace ripstop
