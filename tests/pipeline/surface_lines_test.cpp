#include "ripstop/pipeline/read/surface_lines.h"

#include <gmock/gmock.h>

#include <cmath>

#include "ripstop/pattern/piece/pieces.h"
#include "ripstop/pipeline/flatten/flatten_envelope.h"
#include "ripstop/pipeline/read/read_envelope.h"
#include "support/shapes.h"

namespace ripstop {
namespace surface_lines_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Two adjacent parts of a cylinder about the z axis, 1 m in radius and height.
std::vector<NamedMesh> two_sheets() {
    TriangleMesh left = testing::cylinder(1, 0.5, 1, 24, 12), right = left;
    const double turn = 0.5;
    for (int v = 0; v < right.vertex_count(); ++v) {
        const Vec3 p = right.positions.row(v);
        right.positions.row(v) << p.x() * std::cos(turn) - p.y() * std::sin(turn),
            p.x() * std::sin(turn) + p.y() * std::cos(turn), p.z();
    }
    return {{"left", left}, {"right", right}};
}

double length(const Points2& line) {
    return (line.bottomRows(line.rows() - 1) - line.topRows(line.rows() - 1)).rowwise().norm().sum();
}

TEST(SurfaceLines, AreCutAtTheSeamAndKeepTheirLengthOnTheCloth) {
    Envelope envelope = make_envelope(two_sheets(), {});
    // A helix across both, from the middle of one sheet to the middle of the other.
    const Vec3 from = envelope.tiles[0].mesh.positions.colwise().mean(),
               to = envelope.tiles[1].mesh.positions.colwise().mean();
    const double first = std::atan2(from.y(), from.x()), last = std::atan2(to.y(), to.x());
    NamedCurve helix{"stripe", Points3(101, 3), {{"layer", "artwork"}}};
    for (int i = 0; i <= 100; ++i) {
        const double angle = first + (last - first) * i / 100;
        helix.points.row(i) << std::cos(angle), std::sin(angle), 0.2 + 0.6 * i / 100;
    }
    CadModel model;
    model.curves = {helix};
    EXPECT_TRUE(lay_lines(model, envelope).empty());
    ASSERT_EQ(envelope.tiles[0].lines.size(), 1U);
    ASSERT_EQ(envelope.tiles[1].lines.size(), 1U);
    const std::vector<PatternPiece> pieces = make_pieces(flatten_envelope(envelope, {}));
    const double drawn = std::hypot(std::abs(last - first), 0.6);
    EXPECT_NEAR(length(pieces[0].lines.at(0).points) + length(pieces[1].lines.at(0).points), drawn, 1e-3 * drawn);
    EXPECT_EQ(pieces[0].lines[0].name, "stripe");
    // A helix is straight on the cloth.
    for (const PatternPiece& piece : pieces) {
        const Points2& line = piece.lines[0].points;
        EXPECT_NEAR((line.row(line.rows() - 1) - line.row(0)).norm(), length(line), 1e-4);
    }
    // It continues where it stopped: both ends at the seam have the same height.
    const auto end = [&](int tile, bool last_point) {
        const Points3& points = envelope.tiles[static_cast<std::size_t>(tile)].lines[0].points;
        return Vec3(points.row(last_point ? points.rows() - 1 : 0));
    };
    EXPECT_NEAR((end(0, true) - end(1, false)).norm(), 0, 3e-5);
}

TEST(SurfaceLines, LeaveOutTheSeamsThemselvesAndSayWhatLiesNowhere) {
    Envelope envelope = make_envelope(two_sheets(), {});
    CadModel model;
    const Tile& left = envelope.tiles[0];
    const Chain& seam = left.chains[0];
    NamedCurve drawn_seam{"seam", Points3(static_cast<Eigen::Index>(seam.vertices.size()), 3), {}};
    for (std::size_t i = 0; i < seam.vertices.size(); ++i)
        drawn_seam.points.row(static_cast<Eigen::Index>(i)) = left.mesh.positions.row(seam.vertices[i]);
    Points3 axis(2, 3);
    axis << 0, 0, 0, 0, 0, 1;
    model.curves = {drawn_seam, {"axis", axis, {}}};
    EXPECT_THAT(lay_lines(model, envelope), ElementsAre(HasSubstr("curve axis left out: it lies on no tile")));
    EXPECT_TRUE(envelope.tiles[0].lines.empty());
    EXPECT_TRUE(envelope.tiles[1].lines.empty());
}

/// Flat sheets of these widths side by side along x, one metre high.
Envelope sheets(const std::vector<double>& widths) {
    std::vector<NamedMesh> tiles;
    double x = 0;
    for (const double width : widths) {
        tiles.push_back({std::string("sheet").append(std::to_string(tiles.size())),
                         testing::grid(4, 4, [&](double u, double v) { return Vec3(x + u * width, v, 0); })});
        x += width;
    }
    return make_envelope(tiles, {});
}

CadModel tape(const Points3& points) {
    CadModel model;
    model.curves = {{"tape", points, {}}};
    return model;
}

TEST(SurfaceLines, StepOverNoNarrowTile) {
    Envelope envelope = sheets({1, 0.012, 1});
    Points3 points(2, 3);
    points << 0.1, 0.5, 0, 1.9, 0.5, 0;
    EXPECT_TRUE(lay_lines(tape(points), envelope).empty());
    ASSERT_EQ(envelope.tiles[1].lines.size(), 1U);
    const Points3& narrow = envelope.tiles[1].lines[0].points;
    EXPECT_NEAR(narrow(narrow.rows() - 1, 0) - narrow(0, 0), 0.012, 5e-5);
}

TEST(SurfaceLines, SayHowMuchOfACurveIsLost) {
    Envelope envelope = sheets({1, 1});
    Points3 points(5, 3);
    points << 0.1, 0.5, 0, 0.8, 0.5, 0, 0.8, 0.5, 0.2, 1.2, 0.5, 0.2, 1.2, 0.5, 0;
    EXPECT_THAT(lay_lines(tape(points), envelope),
                ElementsAre(::testing::ContainsRegex("curve tape: 7[78][0-9] mm of it are more than 10 mm off")));
}

}  // namespace surface_lines_test
}  // namespace ripstop
