#include "ripstop/base/text/utf8.h"

#include <gtest/gtest.h>

namespace ripstop {
namespace utf8_test {

TEST(Utf8, CountsLettersNotBytes) {
    EXPECT_EQ(letters_in(""), 0u);
    EXPECT_EQ(letters_in("gore"), 4u);
    EXPECT_EQ(letters_in("Größe ≥ 5"), 9u);
}

}  // namespace utf8_test
}  // namespace ripstop
