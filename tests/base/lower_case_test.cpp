#include "ripstop/base/text/lower_case.h"

#include <gtest/gtest.h>

namespace ripstop {
namespace {

TEST(LowerCase, ChangesTheLettersOfAsciiAlone) {
    EXPECT_EQ(lower_case("AZaz09 [`{@_.DXF"), "azaz09 [`{@_.dxf");
    EXPECT_EQ(lower_case("\xC3\x84"), "\xC3\x84");  // A umlaut
    EXPECT_EQ(lower_case(""), "");
}

}  // namespace
}  // namespace ripstop
