#include "ripstop/base/text/number_text.h"

#include <gtest/gtest.h>

namespace ripstop {
namespace number_text_test {

TEST(NumberText, IsPaddedToTheDigitsOfTheLastAndToTwoAtLeast) {
    EXPECT_EQ(padded(3, 9), "03");
    EXPECT_EQ(padded(3, 120), "003");
    EXPECT_EQ(padded(7, 480, 4), "0007");
    EXPECT_EQ(padded(1234, 99), "1234") << "a number is never cut";
}

}  // namespace number_text_test
}  // namespace ripstop
