#include "ripstop/io/text/escape.h"

#include <gtest/gtest.h>

namespace ripstop {
namespace escape_test {

TEST(AsciiText, LosesAccentsAndKeepsTheRest) {
    EXPECT_EQ(ascii_text("Příliš žluťoučký kůň"), "Prilis zlutoucky kun");
    EXPECT_EQ(ascii_text("ĎÁBELSKÉ ÓDY łódź Straße Ærø"), "DABELSKE ODY lodz Strasse Aro");
    EXPECT_EQ(ascii_text("G01::P-02 (a)"), "G01::P-02 (a)");
}

TEST(AsciiText, LeavesNoLineEndsAndNoForeignBytes) {
    EXPECT_EQ(ascii_text("a\r\nb\tc"), "a  b c");
    EXPECT_EQ(ascii_text("\xff\xc3.\xe2\x82"), "??.??");
    EXPECT_EQ(ascii_text("\xc0\xaf"), "??") << "an overlong slash is no slash";
}

TEST(AsciiText, SpellsGreekAndCyrillicAndDropsAccentsThatStandAlone) {
    EXPECT_EQ(ascii_text("Шар Щука ёж объём Київ"), "Shar Shchuka ezh obem Kiyiv");
    EXPECT_EQ(ascii_text("Αερόστατο Ψ ως Ώ"), "Aerostato Ps os O");
    EXPECT_EQ(ascii_text("cafe\u0301 12°\u00a0– n\u0303"), "cafe 12 deg - n");
}

TEST(AsciiText, KeepsNamesInOtherLettersApart) {
    EXPECT_EQ(ascii_text("日本"), "U65E5U672C");
    EXPECT_EQ(ascii_text("中国"), "U4E2DU56FD");
    EXPECT_EQ(ascii_text("🎈"), "U1F388");
    EXPECT_EQ(ascii_text("\U0010FFFD"), "U10FFFD");
}

TEST(XmlText, EscapesMarkupAndReplacesWhatXmlCannotHold) {
    EXPECT_EQ(xml_text("<a & \"b\" 'c'>"), "&lt;a &amp; &quot;b&quot; &#39;c&#39;&gt;");
    EXPECT_EQ(xml_text("Bílý 気球 🎈"), "Bílý 気球 🎈");
    EXPECT_EQ(xml_text("a\x01\xff"), "a\xEF\xBF\xBD\xEF\xBF\xBD");
}

}  // namespace escape_test
}  // namespace ripstop
