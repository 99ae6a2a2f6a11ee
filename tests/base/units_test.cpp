#include "ripstop/base/text/units.h"

#include <gtest/gtest.h>

#include "ripstop/base/error.h"

namespace ripstop {
namespace units_test {

TEST(ParseLength, TakesANumberWithItsUnit) {
    EXPECT_DOUBLE_EQ(parse_length("12mm", "--gap"), 0.012);
    EXPECT_DOUBLE_EQ(parse_length("1.5 m", "--gap"), 1.5);
    EXPECT_DOUBLE_EQ(parse_length("2in", "--gap"), 0.0508);
    EXPECT_DOUBLE_EQ(parse_length("1e-2mm", "--gap"), 1e-5);
    EXPECT_DOUBLE_EQ(parse_length("2E3mm", "--gap"), 2);
}

TEST(ParseLength, RefusesWhatHasNoUnitOrNoNumber) {
    for (const char* text : {"", "12", "mm", "12 ells", "1,5m", "e3m", "1e400m", "--1m"})
        EXPECT_THROW(parse_length(text, "--gap"), InputError) << text;
}

}  // namespace units_test
}  // namespace ripstop
