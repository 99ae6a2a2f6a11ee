/// Openings of pieces in the files for cutters: what the reader of each format finds must match the piece's sew
/// line.
#include <gmock/gmock.h>

#include <regex>
#include <sstream>

#include "ripstop/geometry/polygon.h"
#include "ripstop/io/dxf/dxf_dialect.h"
#include "ripstop/io/dxf/dxf_read.h"
#include "ripstop/io/dxf/moved_piece.h"
#include "ripstop/io/print/hpgl.h"
#include "ripstop/io/print/pdf.h"
#include "ripstop/io/svg/svg.h"
#include "ripstop/io/svg/svg_read.h"
#include "ripstop/pattern/cut/cut_check.h"
#include "ripstop/pattern/drawing/check_drawing.h"
#include "ripstop/pattern/drawing/drawing_layers.h"
#include "support/dxf_pieces.h"
#include "support/openings.h"
#include "support/outside.h"
#include "support/plotter.h"

namespace ripstop {
namespace openings_as_written_test {

struct Opened {
    std::string what;
    PatternPiece piece;
    Vec2 inside;  ///< a point in the opening
};

/// Small enough for a page of a roll.
std::vector<Opened> opened_pieces() {
    constexpr double allowance = 0.025, round = 6.283185307179586;
    return {
        {"a wide slit", testing::cut_piece(testing::square_keyhole(0.06, 0.3, allowance)), {0.4, 0.4}},
        {"a narrow slit", testing::cut_piece(testing::square_keyhole(0.03, 0.3, allowance)), {0.4, 0.4}},
        {"a slit of 1 mm", testing::cut_piece(testing::square_keyhole(0.001, 0.3, allowance)), {0.4, 0.4}},
        {"a slit without width", testing::cut_piece(testing::square_keyhole(0, 0.3, allowance)), {0.4, 0.4}},
        {"a round keyhole", testing::cut_piece(testing::round_keyhole(0.03, 0.1, allowance)), {0.4, 0.4}},
        {"a ring of 356 degrees", testing::cut_piece(testing::open_ring(round * 356 / 360, allowance, 0.5)), {0, 0}},
        {"a whole ring", testing::cut_piece(testing::open_ring(round, allowance, 0.5)), {0, 0}},
        {"a dart", testing::cut_piece(testing::notched_strip(round / 90, allowance)), {0, 0.95}}};
}

void expect_as_cut(const Opened& opened, const PatternPiece& written) {
    std::string faults;
    for (const CutFault& fault : check_cut_line(written)) faults += fault.message + "; ";
    EXPECT_EQ(faults, "") << opened.what;
    EXPECT_EQ(testing::turns_round(written.cut_line, opened.inside), 0) << opened.what;
    EXPECT_NEAR(signed_area(written.cut_line), signed_area(opened.piece.cut_line),
                0.02e-3 * perimeter(opened.piece.cut_line))
        << opened.what;
}

bool touches_itself(const PatternPiece& piece) {
    for (const MetAllowances& met : piece.met)
        if (met.gap < 1e-5) return true;
    return false;
}

/// Expects the contours of a drawing of one piece, as a cutter reads them, to match the piece.
void expect_drawn_as_cut(const Opened& opened, const PatternDrawing& drawing) {
    const LayerConvention convention = convention_of(drawing);
    ASSERT_NE(convention, LayerConvention::unknown) << opened.what;
    std::vector<const DrawnPath*> paths;
    for (const DrawnPath& path : drawing.paths) paths.push_back(&path);
    std::vector<Points2> cut, sew;
    for (const LayerLines& layer : join_layers(paths, drawing.units.front().unit.metres, 1e-5))
        for (const JoinedLine& line : layer.lines) {
            const LayerUse use = use_of(convention, layer.layer);
            if (use == LayerUse::cut && line.is_closed) cut.push_back(line.points);
            if (use == LayerUse::sew && line.is_closed) sew.push_back(line.points);
        }
    ASSERT_EQ(cut.size(), 1U) << opened.what;
    if (touches_itself(opened.piece)) {  // edges that are drawn separately may join in either way there
        double length = 0;
        for (const Points2& line : sew) length += perimeter(line);
        EXPECT_NEAR(length, perimeter(opened.piece.sew_line), 1e-4) << opened.what;
        PatternPiece written = opened.piece;
        written.cut_line = cut[0];
        written.cut_line.rowwise() += opened.piece.lower().transpose() - Vec2(written.lower()).transpose();
        expect_as_cut(opened, written);
    } else {
        ASSERT_EQ(sew.size(), 1U) << opened.what;
        expect_as_cut(opened, testing::as_written(opened.piece, cut[0], sew[0]));
    }
    for (const DrawingIssue& issue : check_drawing(drawing).issues)
        EXPECT_NE(issue.code, "opening") << opened.what << ": " << issue.message;
}

TEST(OpeningsAsWritten, AreCutInEveryDialectOfDxf) {
    for (const Opened& opened : opened_pieces())
        for (const DxfDialect& dialect : dxf_dialects()) {
            // Separate open lines cannot distinguish coinciding ends of a seam.
            if (!dialect.closed_contours && touches_itself(opened.piece)) continue;
            std::istringstream in(testing::dxf_of({opened.piece}, dialect.name));
            Opened turned = opened;
            turned.what += " in " + std::string(dialect.name);
            if (dialect.grain_up) {
                turned.piece = moved_piece(opened.piece, Vec2::Zero(), true);
                turned.inside = {-opened.inside.y(), opened.inside.x()};
            }
            expect_drawn_as_cut(turned, read_dxf(in, "piece.dxf"));
        }
}

TEST(OpeningsAsWritten, AreCutInSvg) {
    for (const Opened& opened : opened_pieces()) {
        std::stringstream svg;
        write_svg(svg, {opened.piece});
        expect_drawn_as_cut(opened, read_svg(svg, "piece.svg"));
    }
}

TEST(OpeningsAsWritten, AreCutInHpgl) {
    for (const Opened& opened : opened_pieces()) {
        std::ostringstream out;
        write_hpgl(out, {opened.piece}, {}, {});
        const testing::Plot plot = testing::plot_of(out.str());
        ASSERT_EQ(plot.strokes.at(2).size(), 1U) << opened.what;
        const Points2& stroke = plot.strokes.at(2)[0];
        ASSERT_EQ(stroke.row(0), stroke.bottomRows(1)) << opened.what;
        PatternPiece written = opened.piece;
        written.cut_line = stroke.topRows(stroke.rows() - 1) * 0.025e-3;
        // The plotter has steps of 0.025 mm, so its corner is off by at most half a step, as everything else.
        written.cut_line.rowwise() += opened.piece.lower().transpose() - Vec2(written.lower()).transpose();
        expect_as_cut(opened, written);
    }
}

/// The red lines of a page, as poppler draws it, in metres.
std::vector<Points2> red_lines(const std::string& svg) {
    const std::regex path("<path style=\"[^\"]*stroke:rgb\\(79.9[0-9]*%,0%,0%\\)[^\"]*\" d=\"([^\"]*)\"");
    const std::regex step("[ML] ?(-?[0-9.]+) (-?[0-9.]+)");
    std::vector<Points2> lines;
    for (std::sregex_iterator it(svg.begin(), svg.end(), path), end; it != end; ++it) {
        const std::string d = (*it)[1];
        std::vector<Vec2> points;
        for (std::sregex_iterator s(d.begin(), d.end(), step), none; s != none; ++s)
            points.emplace_back(std::stod((*s)[1]), std::stod((*s)[2]));
        while (points.size() > 1 && points.back() == points.front()) points.pop_back();
        Points2 line(static_cast<Eigen::Index>(points.size()), 2);
        for (std::size_t i = 0; i < points.size(); ++i) line.row(static_cast<Eigen::Index>(i)) = points[i];
        lines.push_back(line * (0.0254 / 72));
    }
    return lines;
}

TEST(OpeningsAsWritten, AreCutInPdf) {
    if (testing::run_command("pdftocairo -v").code != 0) GTEST_SKIP() << "no poppler-utils here";
    const testing::ScratchDirectory scratch;
    std::vector<PatternPiece> pieces;
    for (const Opened& opened : opened_pieces()) pieces.push_back(opened.piece);
    std::ostringstream out;
    write_pdf(out, pieces, {"openings.obj", "A", "roll", ""});
    testing::write_text(scratch.path("p.pdf"), out.str());
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Opened opened = opened_pieces()[i];
        const std::string page = std::to_string(i + 2), svg = scratch.path("page.svg");
        ASSERT_EQ(
            testing::run_command("pdftocairo -svg -f " + page + " -l " + page + " " + scratch.path("p.pdf") + " " + svg)
                .code,
            0);
        std::vector<Points2> lines = red_lines(testing::content(svg));
        ASSERT_EQ(lines.size(), 1U) << opened.what;
        if (signed_area(lines[0]) < 0) lines[0].col(1) *= -1;  // y down
        PatternPiece written = opened.piece;
        const Eigen::RowVector2d lower = lines[0].colwise().minCoeff();
        written.cut_line = lines[0].rowwise() + (opened.piece.lower().transpose() - lower);
        expect_as_cut(opened, written);
    }
}

}  // namespace openings_as_written_test
}  // namespace ripstop
