#pragma once

#include <string>

namespace ripstop {

/// Why an iteration ended.
enum class Termination {
    failed,          ///< no usable result; `SolveSummary::reason` says why
    converged,       ///< the method's own convergence test holds
    stagnated,       ///< no further decrease is possible at working precision
    iteration_limit  ///< stopped by the limit; the result is usable but has not converged
};

/// How an iterative result was computed. The default is `failed`, so a solver that forgets to fill it in is not
/// trusted.
struct SolveSummary {
    Termination termination = Termination::failed;
    int iterations = 0;      ///< iterations of the outer loop
    int factorizations = 0;  ///< sparse factorizations, failed attempts included
    std::string reason = "not run";

    bool usable() const { return termination != Termination::failed; }
    /// `converged: energy at rest after 812 iterations`
    std::string text() const;
};

/// The enumerator as text: `converged`.
const char* name(Termination termination);

}  // namespace ripstop
