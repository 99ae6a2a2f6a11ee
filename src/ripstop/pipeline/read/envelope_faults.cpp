#include "ripstop/pipeline/read/envelope_faults.h"

#include <algorithm>
#include <utility>

#include "ripstop/assembly/faults/check_envelope.h"
#include "ripstop/base/text/units.h"

namespace ripstop {
namespace {

bool is_among(const std::string& code, const std::vector<std::string>& codes) {
    return std::find(codes.begin(), codes.end(), code) != codes.end();
}

bool may_be_meant(const EnvelopeIssue& issue) {
    return std::find(acceptable_issues.begin(), acceptable_issues.end(), issue.code) != acceptable_issues.end();
}

/// Keeps only issues that hold for some tiles regardless of the others.
void keep_what_a_part_shows(EnvelopeCheck& check, const std::optional<UnitDoubt>& doubt) {
    std::erase_if(check.issues, [](const EnvelopeIssue& issue) { return issue.code != "unit"; });
    if (check.issues.empty() && doubt && doubt->is_wrong) check.issues.push_back(unit_issue(*doubt));
    for (const EnvelopeIssue& issue : check.meant) std::erase(check.notes, issue.message);
    check.meant.clear();
}

}  // namespace

EnvelopeCheck judge_input(const EnvelopeInput& input, const JudgeOptions& options) {
    const Envelope& drawn = input.drawn ? input.drawn->envelope : input.envelope;
    EnvelopeCheck check = check_envelope(drawn, {options.seam_tolerance}, input.unit);
    if (!options.is_whole) keep_what_a_part_shows(check, input.doubt);
    check.issues.insert(check.issues.begin(), input.issues.begin(), input.issues.end());
    accept_issues(check, options.accept);
    return check;
}

void accept_issues(EnvelopeCheck& check, const std::vector<std::string>& codes) {
    std::vector<EnvelopeIssue> left;
    for (EnvelopeIssue& issue : check.issues) {
        if (!may_be_meant(issue) || !is_among(issue.code, codes)) {
            left.push_back(std::move(issue));
            continue;
        }
        issue.message = issue.fact + "; that is accepted (" + issue.code + ")";
        check.notes.push_back(issue.message);
        check.meant.push_back(std::move(issue));
    }
    check.issues = std::move(left);
}

void add_faults(CutPlan& plan, const EnvelopeCheck& check) {
    for (const EnvelopeIssue& issue : check.issues) {
        if (issue.code == "uncertain") continue;
        Finding finding{issue.code, issue.message, issue.at, 1, 0};
        finding.tiles = issue.tiles;
        const bool is_counted = issue.code == "no_tile" || may_be_meant(issue);
        if (issue.code == "scaled") {
            finding.value = issue.value;
            finding.limit = 1;
        } else if (!is_counted) {
            finding.value = issue.value / millimetre;
            finding.limit = (issue.limit > 0 ? issue.limit : check.seam_tolerance) / millimetre;
        }
        plan.findings.push_back(std::move(finding));
    }
    for (const EnvelopeIssue& issue : check.meant) plan.remarks.push_back(issue.message);
}

}  // namespace ripstop
