#include "ripstop/pipeline/envelope_faults.h"

#include <algorithm>
#include <array>

#include "ripstop/base/units.h"

namespace ripstop {
namespace {

bool may_be_meant(const EnvelopeIssue& issue) {
    constexpr std::array<const char*, 4> meant{"uncertain", "missing_tile", "apart", "unsewn"};
    return std::any_of(meant.begin(), meant.end(), [&](const char* code) { return issue.code == code; });
}

}  // namespace

void add_faults(CutPlan& plan, const EnvelopeCheck& check) {
    for (const EnvelopeIssue& issue : check.issues) {
        if (may_be_meant(issue)) continue;
        if (issue.code == "no_tile") {  // nothing is measured of it
            plan.findings.push_back({issue.code, issue.message, issue.at, 1, 0});
            continue;
        }
        const bool is_ratio = issue.code == "scaled";
        const double limit = issue.limit > 0 ? issue.limit : check.seam_tolerance;
        plan.findings.push_back({issue.code, issue.message, issue.at, is_ratio ? issue.value : issue.value / millimetre,
                                 is_ratio ? 1 : limit / millimetre});
    }
}

}  // namespace ripstop
