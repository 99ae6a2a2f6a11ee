#pragma once

#include <string>

namespace ripstop {

/// Why an iteration ended.
enum class Termination {
    failed,          ///< nothing usable came out; `SolveSummary::reason` says why
    converged,       ///< the method's own test was met
    stagnated,       ///< no further decrease is possible at working precision
    iteration_limit  ///< stopped by the limit; the result is usable but not at rest
};

/// How a result came about. Born failed: a solver that forgets to fill it in is not believed.
struct SolveSummary {
    Termination termination = Termination::failed;
    int iterations = 0;      ///< of the method's outer loop
    int factorizations = 0;  ///< of sparse matrices, all attempts counted
    std::string reason = "not run";

    bool usable() const { return termination != Termination::failed; }
    /// `converged: energy at rest after 812 iterations`
    std::string text() const;
};

/// The enumerator as text: `converged`.
const char* name(Termination termination);

}  // namespace ripstop
