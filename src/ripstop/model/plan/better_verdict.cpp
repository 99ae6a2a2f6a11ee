#include "ripstop/model/plan/better_verdict.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace ripstop {
namespace {

std::map<std::string, double> worst_of_each_kind(const Verdict& verdict) {
    std::map<std::string, double> worst;
    for (const Finding& finding : verdict.findings) {
        double& here = worst[finding.code];
        here = std::max(here, std::abs(finding.value / (finding.limit != 0 ? finding.limit : 1)));
    }
    return worst;
}

}  // namespace

bool is_better(const Verdict& half, const Verdict& whole) {
    const auto before = worst_of_each_kind(whole), after = worst_of_each_kind(half);
    return std::all_of(after.begin(), after.end(), [&](const auto& kind) {
        const auto was = before.find(kind.first);
        return was != before.end() && kind.second < was->second;
    });
}

}  // namespace ripstop
