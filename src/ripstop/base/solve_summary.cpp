#include "ripstop/base/solve_summary.h"

namespace ripstop {

const char* name(Termination termination) {
    switch (termination) {
        case Termination::failed:
            return "failed";
        case Termination::converged:
            return "converged";
        case Termination::stagnated:
            return "stagnated";
        case Termination::iteration_limit:
            return "iteration limit";
    }
    return "failed";
}

std::string SolveSummary::text() const {
    return std::string(name(termination)) + ": " + reason + " after " + std::to_string(iterations) +
           (iterations == 1 ? " iteration" : " iterations");
}

}  // namespace ripstop
