#include "ripstop/io/print/marker_pdf.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "ripstop/nest/laid_piece.h"
#include "support/loose_pieces.h"
#include "support/outside.h"

namespace ripstop {
namespace marker_pdf_test {

using ::testing::HasSubstr;

/// 120 rectangles of about 1 m side by side on a roll of 1.5 m with joins.
std::string long_marker() {
    PatternPiece piece = testing::rectangle_piece("G03P07", 0.99, 1.4);
    piece.quantity = 120;
    Marker marker{"nylon", "red", 1.5, 120};
    marker.parts = {{0, 50, 50}, {50, 70, 70}};
    std::vector<PatternPiece> pieces;
    for (int i = 0; i < 120; ++i) pieces.push_back(laid_piece(piece, {0, i + 1, false, false, 0, Vec2(i, 0)}));
    std::ostringstream out;
    write_marker_pdf(out, marker, pieces, "envelope.obj, revision A");
    return out.str();
}

TEST(MarkerPdf, ShowsTheRollInSmallOnSheets) {
    if (testing::run_command("pdftotext -v").code != 0) GTEST_SKIP() << "no pdftotext here";
    const testing::ScratchDirectory scratch;
    testing::write_text(scratch.path("marker.pdf"), long_marker());
    // 1:40: 10.92 m per strip, eleven strips, four per page
    EXPECT_THAT(testing::run_command("pdfinfo " + scratch.path("marker.pdf")).output,
                AllOf(HasSubstr("Pages:           3\n"), HasSubstr("(A4)")));
    const std::string text = testing::run_command("pdftotext -layout " + scratch.path("marker.pdf") + " -").output;
    EXPECT_THAT(text, HasSubstr("envelope.obj, revision A, 1:40, page 1 of 3"));
    for (const char* const shown : {"G03P07 1/120", "G03P07 120/120", "0 m", "120 m"})
        EXPECT_THAT(text, HasSubstr(shown));
}

TEST(MarkerPdf, HasTheSameBytesEachTime) {
    EXPECT_EQ(long_marker(), long_marker());
}

}  // namespace marker_pdf_test
}  // namespace ripstop
