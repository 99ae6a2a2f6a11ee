#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "ripstop/assembly/seams/seam_runs.h"

namespace ripstop {

/// What of the chains is sewn already, and what lies on a seam of two others: there further sheets are sewn in, so that
/// no two of them make a seam of their own. `beside`: where chains lie on one another, whichever way they run; it must
/// outlive the claims.
class RunClaims {
  public:
    RunClaims(const std::vector<PlacedChain>& chains, const std::vector<Run>& beside, double tolerance);

    void clear();
    void take(const Run& run);
    /// Takes what is sewn into another seam: side a alone.
    void take_a(const Run& run) { take(run.a, run.start_a(), run.end_a()); }

    /// Is the place sewn, further than the tolerance from an end of what is?
    bool is_sewn(int chain, double at) const { return covers(sewn_, chain, at, tolerance_); }
    bool is_sewn(const Touch& touch) const { return is_sewn(touch.a, touch.at_a) || is_sewn(touch.b, touch.at_b); }
    /// Is it sewn or does it lie on a seam?
    bool is_taken(int chain, double at) const { return is_sewn(chain, at) || covers(on_seam_, chain, at, tolerance_); }
    bool is_taken(const Touch& touch) const { return is_taken(touch.a, touch.at_a) || is_taken(touch.b, touch.at_b); }

    /// Is nothing taken where the run goes, at its touches and between them?
    bool leave_free(const Run& run) const;
    /// Is nothing sewn where its chain a goes?
    bool leave_a_unsewn(const Run& run) const;
    /// The parts of a run where nothing is taken yet: from touch to touch, and of one that competes (`order_sheets`) up
    /// to where the others end, since these may end where neither of its chains has a vertex.
    std::vector<Run> free_parts(const Run& run) const;

  private:
    using Ranges = std::vector<std::vector<std::pair<double, double>>>;  ///< of each chain, by arc length [m]

    bool covers(const Ranges& ranges, int chain, double at, double margin) const;
    /// Where between two touches of a run, one taken and one not, what is taken ends.
    std::optional<Touch> end_of_taken(const Touch& taken, const Touch& open) const;
    void take(int chain, double from, double to);
    /// Is a chain of one of the tiles that a run joins?
    bool is_of_one_tile(int chain, const Run& run) const;
    void take_beside(const Run& run, int chain, double from, double to);

    const std::vector<PlacedChain>& chains_;
    const std::vector<Run>& beside_;
    std::vector<std::vector<std::size_t>> beside_on_;  ///< of each chain
    double tolerance_;
    Ranges sewn_, on_seam_;
};

}  // namespace ripstop
