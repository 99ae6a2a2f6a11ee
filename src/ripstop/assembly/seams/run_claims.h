#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "ripstop/assembly/seams/seam_runs.h"

namespace ripstop {

/// Records which parts of the chains are sewn, and which lie on a seam of two others. Further sheets are sewn in
/// at the latter, so no two of them form their own seam. `beside` holds the runs of chains that lie on one
/// another, in either direction; it must outlive this object.
class RunClaims {
  public:
    RunClaims(const std::vector<PlacedChain>& chains, const std::vector<Run>& beside, double tolerance);

    void clear();
    void take(const Run& run);
    /// Claims side a of a run that is sewn into another seam.
    void take_a(const Run& run) { take(run.a, run.start_a(), run.end_a()); }

    /// True if the place is sewn and not within the tolerance of the end of a sewn part.
    bool is_sewn(int chain, double at) const { return covers(sewn_, chain, at, tolerance_); }
    bool is_sewn(const Touch& touch) const { return is_sewn(touch.a, touch.at_a) || is_sewn(touch.b, touch.at_b); }
    /// True if the place is sewn or lies on a seam.
    bool is_taken(int chain, double at) const { return is_sewn(chain, at) || covers(on_seam_, chain, at, tolerance_); }
    bool is_taken(const Touch& touch) const { return is_taken(touch.a, touch.at_a) || is_taken(touch.b, touch.at_b); }

    /// True if nothing is claimed along the run, at its touches and between them.
    bool leave_free(const Run& run) const;
    /// True if nothing is sewn along the run's chain a.
    bool leave_a_unsewn(const Run& run) const;
    /// The free parts of a run, from touch to touch. Those of a competing run (`order_sheets`) extend to the ends
    /// of the claimed parts, which may not be at a vertex of either chain.
    std::vector<Run> free_parts(const Run& run) const;

  private:
    using Ranges = std::vector<std::vector<std::pair<double, double>>>;  ///< for each chain, by arc length [m]

    bool covers(const Ranges& ranges, int chain, double at, double margin) const;
    /// The place where the claim ends between two touches of a run, of which one is claimed and the other free.
    std::optional<Touch> end_of_taken(const Touch& taken, const Touch& open) const;
    void take(int chain, double from, double to);
    /// True if the chain belongs to one of the two tiles of a run.
    bool is_of_one_tile(int chain, const Run& run) const;
    void take_beside(const Run& run, int chain, double from, double to);

    const std::vector<PlacedChain>& chains_;
    const std::vector<Run>& beside_;
    std::vector<std::vector<std::size_t>> beside_on_;  ///< for each chain
    double tolerance_;
    Ranges sewn_, on_seam_;
};

}  // namespace ripstop
