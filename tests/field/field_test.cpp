#include "field/field_case.h"
#include "support/sanitized.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

namespace ripstop::field {
namespace field_test {

TEST(Field, HasAtLeastTwoThousandCases) {
    EXPECT_GE(field_cases().size(), 2000U);
}

/// A fixed sample of `make field`: a few cases of each family, in different variants.
TEST(Field, HoldsInASampleOfEveryFamily) {
    RIPSTOP_TOO_LONG_SANITIZED();
    std::map<std::string, int> seen;
    std::map<std::string, int> counts;
    for (const Case& each : field_cases()) ++counts[each.family];
    for (const Case& each : field_cases()) {
        // Steps that are coprime to the number of variants.
        const int step = std::max(1, counts[each.family] / 6) | 1;
        if (seen[each.family]++ % step != 0) continue;
        for (const std::string& sentence : failures_of(each)) ADD_FAILURE() << each.text() << ": " << sentence;
    }
}

}  // namespace field_test
}  // namespace ripstop::field
