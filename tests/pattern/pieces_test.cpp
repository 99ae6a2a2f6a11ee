#include "ripstop/pattern/piece/pieces.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "ripstop/geometry/polygon.h"
#include "ripstop/mesh/boundary.h"
#include "support/flat_tiles.h"

namespace ripstop {
namespace pieces_test {

Points2 polygon(std::initializer_list<std::array<double, 2>> corners) {
    Points2 result(static_cast<Eigen::Index>(corners.size()), 2);
    Eigen::Index i = 0;
    for (const auto& corner : corners) result.row(i++) << corner[0], corner[1];
    return result;
}

const Points2 l_shape = polygon({{0, 0}, {0.3, 0}, {0.3, 0.1}, {0.1, 0.1}, {0.1, 0.3}, {0, 0.3}});

/// A banana: two arcs about (0, -1), `width` apart, `half` radians to each side of upright.
Points2 banana(double width, double half) {
    constexpr int n = 40;
    Points2 result(2 * n, 2);
    for (int i = 0; i < n; ++i) {
        const double angle = half * (1 - 2.0 * i / (n - 1));
        result.row(i) << (1 + width) * std::sin(-angle), (1 + width) * std::cos(angle) - 1;
        result.row(2 * n - 1 - i) << std::sin(-angle), std::cos(angle) - 1;
    }
    return result.colwise().reverse();
}

PatternPiece piece_of(const std::string& name, const Points2& outline) {
    return testing::piece_of(testing::flat_polygon(name, outline));
}

/// The rectangle of a label's letters, each as wide as high.
Box box_of(const Label& label) {
    return {label.middle, label.height * Vec2(static_cast<double>(label.text.size()) / 2, 0.5), label.turn};
}

Box arrow_box(const PatternPiece& piece) {
    const Vec2 tail = piece.grain_line.row(0), head = piece.grain_line.row(1);
    const double length = (head - tail).norm();
    return {(tail + head) / 2, {length / 2, arrow_half_width(length)}, 0};
}

bool apart(const Box& a, const Box& b) {
    const auto reach = [](const Box& box) { return box.turn == 0 ? box.half : Vec2(box.half.y(), box.half.x()); };
    return ((a.centre - b.centre).cwiseAbs().array() >= (reach(a) + reach(b)).array()).any();
}

double width_at(const Points2& outline, double y, double x) {
    for (const auto& chord : horizontal_chords(outline, y))
        if (chord[0] <= x && x <= chord[1]) return chord[1] - chord[0];
    return 0;
}

TEST(PatternPiece, HasItsBoundaryWithinTheChordErrorOfItsSewLineCounterClockwise) {
    const FlatTile tile = testing::sinusoidal_gore("G01P01");
    const PatternPiece piece = testing::piece_of(tile);
    EXPECT_EQ(piece.name, "G01P01");
    const auto count = static_cast<Eigen::Index>(tile.tile.boundary.size());
    EXPECT_LE(piece.sew_line.rows(), count);
    for (const int v : tile.tile.boundary)
        EXPECT_LE(distance_to_outline(piece.sew_line, tile.flattening.positions.row(v)), PieceOptions{}.chord_error);
    EXPECT_GT(signed_area(piece.sew_line), 0);
    double length = 0;
    for (const PieceEdge& edge : piece.edges) length += edge.length;
    EXPECT_NEAR(length, edge_lengths(tile.flattening.positions, closed(tile.tile.boundary)).sum(), 1e-12)
        << "an edge's length is that of all its vertices";
}

TEST(PatternPiece, KeepsItsCornersExact) {
    const FlatTile tile = testing::flat_cylinder("G01P01");
    const PatternPiece piece = testing::piece_of(tile);
    ASSERT_EQ(piece.edges.size(), tile.tile.chains.size());
    EXPECT_EQ(piece.sew_line.rows(), 4) << "its edges are straight on the cloth";
    for (std::size_t e = 0; e < piece.edges.size(); ++e) {
        const Points2 line = piece.edge_line(e);
        const auto is_corner = [&](const Vec2& at) {
            return std::any_of(tile.tile.chains.begin(), tile.tile.chains.end(), [&](const Chain& chain) {
                return Vec2(tile.flattening.positions.row(chain.vertices.front())) == at;
            });
        };
        EXPECT_TRUE(is_corner(line.row(0)) && is_corner(line.row(line.rows() - 1)));
    }
}

TEST(PatternPiece, IsCutBeyondItsSewLineByWhatItsHemsTake) {
    const PatternPiece piece = piece_of("G01P01", polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
    const double hem = default_hem().allowance;
    ASSERT_GT(hem, 0);
    EXPECT_NEAR(signed_area(piece.cut_line), (1 + 2 * hem) * (1 + 2 * hem), 1e-6);
    EXPECT_NEAR(distance_to_outline(piece.cut_line, Vec2(0.5, 0)), hem, 1e-6);
    EXPECT_EQ(piece.edges[0].seam_type, default_hem().name);
}

TEST(PatternPiece, RunsCounterClockwiseAndStaysUnmirroredWhereTheFlatteningIsTurnedOver) {
    FlatTile tile = testing::flat_cylinder("over");
    tile.flattening.positions.col(0) *= -1;
    const PatternPiece piece = testing::piece_of(tile);
    EXPECT_GT(signed_area(piece.sew_line), 0);
    EXPECT_LE(piece.upper().x(), 0) << "the fault must stay visible, not be mirrored away";
}

struct Outline {
    const char* name;
    Points2 corners;
    double letters_at_least;  ///< [m]
};
void PrintTo(const Outline& outline, std::ostream* out) {
    *out << outline.name;
}
class EveryOutline : public ::testing::TestWithParam<Outline> {};

TEST_P(EveryOutline, HoldsItsLabelAndItsGrainArrowApart) {
    const PatternPiece piece = piece_of("G01P01", GetParam().corners);
    ASSERT_FALSE(piece.labels.empty());
    EXPECT_EQ(piece.labels[0].text, "G01P01");
    EXPECT_GE(piece.labels[0].height, GetParam().letters_at_least);
    EXPECT_LE(piece.labels[0].height, 0.040);
    ASSERT_EQ(piece.grain_line.rows(), 2);
    EXPECT_EQ(piece.grain_line(0, 1), piece.grain_line(1, 1)) << "the warp is level";
    EXPECT_LT(piece.grain_line(0, 0), piece.grain_line(1, 0)) << "and points to +x";
    const Box arrow = arrow_box(piece);
    EXPECT_TRUE(contains(piece.sew_line, arrow));
    EXPECT_LE(2 * arrow.half.x(), 0.6 * width_at(piece.sew_line, arrow.centre.y(), arrow.centre.x()) * (1 + 1e-12));
    for (const Label& label : piece.labels) {
        EXPECT_TRUE(contains(piece.sew_line, box_of(label))) << label.text;
        EXPECT_TRUE(apart(box_of(label), arrow)) << label.text;
    }
}

INSTANTIATE_TEST_SUITE_P(
    , EveryOutline,
    ::testing::Values(Outline{"square", polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), 0.040}, Outline{"l", l_shape, 0.010},
                      Outline{"banana", banana(0.1, 0.9), 0.010},
                      Outline{"thin_along", polygon({{0, 0}, {1, 0}, {1, 0.012}, {0, 0.012}}), 0.003},
                      Outline{"thin_upright", polygon({{0, 0}, {0.012, 0}, {0.012, 1}, {0, 1}}), 0.003},
                      Outline{"gore_tip", polygon({{0, -0.05}, {2, 0}, {0, 0.05}}), 0.010},
                      Outline{"tiny", polygon({{0, 0}, {0.02, 0}, {0.02, 0.015}, {0, 0.015}}), 0.001}),
    [](const auto& outline) { return std::string(outline.param.name); });

TEST(PatternPiece, TurnsItsLabelUprightWhereItIsNarrow) {
    EXPECT_GT(piece_of("G01P01", polygon({{0, 0}, {0.012, 0}, {0.012, 1}, {0, 1}})).labels[0].turn, 1.5);
    EXPECT_EQ(piece_of("G01P01", polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}})).labels[0].turn, 0);
}

TEST(PatternPiece, HasALongArrowOnASlenderGore) {
    const PatternPiece piece = piece_of("G01P01", polygon({{-1.5, 0}, {0, -0.012}, {1.5, 0}, {0, 0.012}}));
    EXPECT_GT(piece.grain_line(1, 0) - piece.grain_line(0, 0), 0.3);
}

TEST(PatternPiece, PutsTheLabelOfASpeckAtItsMiddle) {
    const PatternPiece piece = piece_of("a name far too long", polygon({{0, 0}, {3e-3, 0}, {3e-3, 2e-3}, {0, 2e-3}}));
    EXPECT_EQ(piece.labels[0].height, 0.001);
    EXPECT_NEAR((piece.labels[0].middle - Vec2(1.5e-3, 1e-3)).norm(), 0, 6e-4);
    ASSERT_EQ(piece.grain_line.rows(), 2);
    EXPECT_TRUE(contains(piece.sew_line, Vec2(piece.grain_line.row(0))));
    EXPECT_TRUE(contains(piece.sew_line, Vec2(piece.grain_line.row(1))));
}

TEST(PatternPiece, OfAnOutlineWithoutInsideStillEnds) {
    for (const double x : {0.0, 1.0}) {
        FlatTile tile = testing::flat_cylinder("flat");
        tile.flattening.positions.col(0) *= x;
        tile.flattening.positions.col(1).setZero();
        const PatternPiece piece = testing::piece_of(tile);
        EXPECT_EQ(piece.sew_line.rows(), 4) << "corners stay where they are, though they coincide";
        EXPECT_EQ(piece.labels.size(), 1u);
        EXPECT_TRUE(piece.grain_line.allFinite());
    }
}

TEST(PatternPiece, IsMadeOnlyOfATileThatWasFlattened) {
    CutPlan plan = testing::two_tile_plan();
    plan.tiles[0].flattening = {};
    EXPECT_FALSE(plan.tiles[0].is_flat());
    EXPECT_EQ(make_pieces(plan).size(), 1u);
    plan.tiles[1].flattening.positions(3, 1) = std::nan("");
    EXPECT_TRUE(make_pieces(plan).empty());
}

}  // namespace pieces_test
}  // namespace ripstop
