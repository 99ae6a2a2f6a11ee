#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <numbers>
#include <numeric>

#include "ripstop/design/natural/gores.h"
#include "ripstop/geometry/polygon.h"
#include "ripstop/pattern/piece/pieces.h"
#include "ripstop/pipeline/flatten/flatten_envelope.h"
#include "ripstop/pipeline/read/read_envelope.h"
#include "ripstop/tile/seam_place.h"
#include "support/envelopes.h"
#include "support/shapes.h"

namespace ripstop {
namespace pieces_of_envelope_test {

CutPlan flattened(std::vector<NamedMesh> tiles) {
    return flatten_envelope(make_envelope(std::move(tiles), {}), {});
}

/// A balloon whose panels are meshed independently, and a wall whose seams end within their neighbours' edges.
const CutPlan& balloon() {
    static const CutPlan plan =
        flattened(testing::meshed_apart({.gores = 8, .panels = 4, .volume = 500, .edge_length = 0.35}, 3));
    return plan;
}
const CutPlan& gores() {
    static const CutPlan plan = flattened(design_natural({.gores = 8, .panels = 3, .volume = 500, .edge_length = 0.5}));
    return plan;
}
const CutPlan& wall() {
    static const CutPlan plan = flattened(testing::brick_wall(4, 12, 0.5));
    return plan;
}

/// Right and left pieces: slanted pieces around a cylinder in three rows, each the mirror image of its neighbours.
const CutPlan& rights_and_lefts() {
    static const CutPlan plan = [] {
        constexpr int columns = 12, rows = 3, cells = 8;
        std::vector<NamedMesh> tiles;
        for (int c = 0; c < columns; ++c)
            for (int r = 0; r < rows; ++r) {
                const TriangleMesh mesh = testing::grid(cells, cells, [&](double u, double v) {
                    const double angle = (c + u) * std::numbers::pi / 6, slant = 0.4 * (c % 2 == 0 ? u : 1 - u);
                    return Vec3(3 * std::cos(angle), 3 * std::sin(angle), r + v + slant);
                });
                tiles.push_back({std::string(1, static_cast<char>('A' + c)).append(std::to_string(r + 1)), mesh});
            }
        return flattened(std::move(tiles));
    }();
    return plan;
}

/// The distance of a point along the sew line of an edge [m].
double along_edge(const PatternPiece& piece, int edge, const Vec2& point) {
    const Points2 line = piece.edge_line(static_cast<std::size_t>(edge));
    double walked = 0, best = 0, least = 1e9;
    for (Eigen::Index i = 0; i + 1 < line.rows(); ++i) {
        const Vec2 a = line.row(i), way = Vec2(line.row(i + 1)) - a;
        const double t = std::clamp((point - a).dot(way) / way.squaredNorm(), 0.0, 1.0);
        if (const double away = (a + t * way - point).norm(); away < least) {
            least = away;
            best = walked + t * way.norm();
        }
        walked += way.norm();
    }
    return best;
}

class EveryEnvelope : public ::testing::TestWithParam<const CutPlan& (*)()> {
  protected:
    const CutPlan& plan = GetParam()();
    const std::vector<PatternPiece> pieces = make_pieces(plan);

    struct Side {
        std::vector<const PieceNotch*> notches;
        std::vector<double> at;  ///< along the sew line from the seam's start [m]
    };
    /// The notches of a seam on one of its sides, from its start.
    Side side(const Seam& seam, bool second) const {
        const SeamSide& of = second ? seam.b : seam.a;
        const PatternPiece& piece = pieces[static_cast<std::size_t>(of.tile)];
        Side found;
        for (const PieceNotch& notch : piece.notches)
            if (notch.seam == seam.id && notch.along > 0 && notch.along < seam.length) found.notches.push_back(&notch);
        std::sort(found.notches.begin(), found.notches.end(),
                  [](const PieceNotch* a, const PieceNotch* b) { return a->along < b->along; });
        for (const PieceNotch* notch : found.notches) {
            const Vec2 start =
                flat_point(plan.tiles[static_cast<std::size_t>(of.tile)], place_on_side(plan.tiles, seam, second, 0));
            found.at.push_back(
                std::abs(along_edge(piece, notch->edge, notch->on_sew) - along_edge(piece, notch->edge, start)));
        }
        return found;
    }
};

TEST_P(EveryEnvelope, HasNotchesThatMeetOnBothSidesOfEverySeam) {
    ASSERT_GT(plan.seams.size(), 10U);
    for (const Seam& seam : plan.seams) {
        const Side a = side(seam, false), b = side(seam, true);
        ASSERT_EQ(a.at.size(), b.at.size()) << seam.id;
        EXPECT_GE(a.at.size(), seam.length > 0.08 ? 1U : 0U) << seam.id;
        for (std::size_t i = 0; i < a.at.size(); ++i) {
            EXPECT_NEAR(a.at[i], b.at[i], 1e-5) << seam.id << ": a hundredth of a millimetre, where a tenth is asked";
            EXPECT_NEAR(a.at[i], a.notches[i]->along, 1e-3 * seam.length) << seam.id;
            EXPECT_EQ(a.notches[i]->count, b.notches[i]->count);
        }
        const int all = std::accumulate(a.notches.begin(), a.notches.end(), 0,
                                        [](int sum, const PieceNotch* notch) { return sum + notch->count; });
        if (a.at.size() > 1) {
            EXPECT_EQ(all, int(a.at.size()) + 1) << seam.id << ": one of them is double";
            EXPECT_EQ(a.notches.front()->count + a.notches.back()->count, 3) << "at one of the ends";
        }
    }
}

TEST_P(EveryEnvelope, HasNoNotchAtACornerAndNoneAsDeepAsTheAllowance) {
    for (std::size_t t = 0; t < pieces.size(); ++t) {
        const PatternPiece& piece = pieces[t];
        for (const PieceNotch& notch : piece.notches) {
            for (const Chain& chain : plan.tiles[t].tile.chains)
                EXPECT_GT((notch.on_sew - Vec2(plan.tiles[t].flattening.positions.row(chain.vertices.front()))).norm(),
                          0.025)
                    << piece.name;
            EXPECT_GT(notch.depth, 0);
            EXPECT_LE(notch.depth, 0.4 * notch.reach);
            EXPECT_LT(distance_to_outline(piece.sew_line, notch.on_sew), 0.06e-3);
            EXPECT_LT(distance_to_outline(piece.cut_line, notch.on_cut()), 0.2e-3)
                << "bends between two vertices of the sew line";
            EXPECT_TRUE(contains(piece.cut_line, Vec2(notch.on_cut() - notch.depth * notch.outward)));
        }
    }
}

TEST_P(EveryEnvelope, IsCutAtTheAllowanceFromEveryEdge) {
    for (const PatternPiece& piece : pieces) {
        for (std::size_t e = 0; e < piece.edges.size(); ++e) {
            const Points2 line = piece.edge_line(e);
            double least = 1e9;
            for (Eigen::Index i = 0; i < line.rows(); ++i) {
                EXPECT_TRUE(contains(piece.cut_line, Vec2(line.row(i))));
                least = std::min(least, distance_to_outline(piece.cut_line, line.row(i)));
            }
            EXPECT_NEAR(least, piece.edges[e].allowance, 1e-6) << piece.name;
        }
        EXPECT_EQ(self_intersections(piece.cut_line).count, 0) << piece.name;
    }
}

TEST_P(EveryEnvelope, KnowsTheMatesOfEveryEdge) {
    std::map<std::string, std::vector<double>> lengths;
    for (const PatternPiece& piece : pieces)
        for (const PieceEdge& edge : piece.edges)
            for (const Mate& mate : edge.mates) lengths[mate.seam].push_back(mate.length);
    ASSERT_EQ(lengths.size(), plan.seams.size());
    for (const Seam& seam : plan.seams) {
        ASSERT_EQ(lengths[seam.id].size(), 2U) << seam.id;
        for (const double length : lengths[seam.id]) EXPECT_NEAR(length, seam.length, 1e-6 * seam.length) << seam.id;
    }
}

TEST_P(EveryEnvelope, NotchesPiecesOfOnePatternAlike) {
    const std::vector<Vec2> middles = [this] {
        std::vector<Vec2> found;
        for (const PatternPiece& piece : pieces) found.push_back(area_centroid(piece.sew_line));
        return found;
    }();
    int copies = 0;
    for (std::size_t t = 0; t < pieces.size(); ++t) {
        const FlatTile& tile = plan.tiles[t];
        if (tile.equal_to < 0) continue;
        ++copies;
        const auto first = static_cast<std::size_t>(tile.equal_to);
        ASSERT_EQ(pieces[t].notches.size(), pieces[first].notches.size()) << pieces[t].name;
        // up to half a turn, which the warp leaves open
        const auto fits = [&](double half_turn) {
            const Vec2 signs(half_turn, tile.mirrored ? -half_turn : half_turn);
            return std::all_of(pieces[t].notches.begin(), pieces[t].notches.end(), [&](const PieceNotch& notch) {
                return std::any_of(
                    pieces[first].notches.begin(), pieces[first].notches.end(), [&](const PieceNotch& other) {
                        const Vec2 there = (other.on_sew - middles[first]).cwiseProduct(signs);
                        return other.count == notch.count && (notch.on_sew - middles[t] - there).norm() < 0.5e-3;
                    });
            });
        };
        EXPECT_TRUE(fits(1) || fits(-1)) << pieces[t].name << " and " << pieces[first].name;
    }
    EXPECT_EQ(copies > 3, GetParam() != &balloon) << "panels meshed each on its own are not equal";
}

TEST_P(EveryEnvelope, CarriesTheNamesOfTheNeighbours) {
    int named = 0, mates = 0;
    for (const PatternPiece& piece : pieces)
        for (const PieceEdge& edge : piece.edges)
            for (const Mate& mate : edge.mates) {
                ++mates;
                named += std::any_of(piece.labels.begin(), piece.labels.end(),
                                     [&mate](const Label& label) { return label.text == mate.piece; });
            }
    EXPECT_GT(named, 0.9 * mates);
}

INSTANTIATE_TEST_SUITE_P(, EveryEnvelope, ::testing::Values(&balloon, &gores, &wall, &rights_and_lefts),
                         [](const auto& plan) {
                             return plan.param == &balloon ? "balloon"
                                    : plan.param == &gores ? "gores"
                                    : plan.param == &wall  ? "wall"
                                                           : "rights_and_lefts";
                         });

/// The gores with one changed: the patterns that cut their panels.
std::vector<Quantity> quantities_of(const std::function<void(Envelope&)>& change) {
    Envelope envelope = make_envelope(design_natural({.gores = 8, .panels = 2, .volume = 500, .edge_length = 0.8}), {});
    change(envelope);
    return quantities(flatten_envelope(envelope, {}));
}

TEST(Pieces, WithoutCornersAreNotchedWhereverTwoMatesMeet) {
    // A disk in a ring of six.
    constexpr int mates = 6, edges = 10;
    const auto on_circle = [](double radius, double angle) {
        return Vec3(radius * std::cos(angle), radius * std::sin(angle), 0);
    };
    TriangleMesh disc;
    disc.positions = Points3::Zero(mates * edges + 1, 3);
    disc.triangles.resize(mates * edges, 3);
    for (int i = 0; i < mates * edges; ++i) {
        disc.positions.row(i + 1) = on_circle(1, 2 * std::numbers::pi * i / (mates * edges));
        disc.triangles.row(i) << 0, i + 1, (i + 1) % (mates * edges) + 1;
    }
    std::vector<NamedMesh> tiles{{"disc", disc}};
    for (int m = 0; m < mates; ++m)
        tiles.push_back({std::string("M").append(std::to_string(m)), testing::grid(4, edges, [&](double u, double v) {
                             return on_circle(1 + u, (m + v) * 2 * std::numbers::pi / mates);
                         })});
    const CutPlan plan = flattened(std::move(tiles));
    const PatternPiece piece = make_pieces(plan).front();
    int ends = 0;
    for (const PieceNotch& notch : piece.notches) {
        const auto seam = std::find_if(plan.seams.begin(), plan.seams.end(),
                                       [&notch](const Seam& other) { return other.id == notch.seam; });
        ends += notch.along == 0 || notch.along == seam->length;
    }
    EXPECT_EQ(piece.edges.size(), 1U);
    EXPECT_EQ(ends, mates);
}

TEST(Pieces, OfTwoColoursHaveTwoPatterns) {
    const std::vector<Quantity> cut = quantities_of([](Envelope& envelope) {
        for (std::size_t t = 0; t < envelope.tiles.size(); ++t)
            envelope.tiles[t].attributes["material"] = t / 2 % 2 == 0 ? "red" : "blue";
    });
    for (std::size_t t = 0; t < cut.size(); ++t) EXPECT_EQ(cut[t].same + cut[t].mirrored, t < 4 ? 4 : 0) << t;
}

TEST(Pieces, WithOtherLinesDrawnOnThemHaveAnotherPattern) {
    const std::vector<Quantity> cut = quantities_of([](Envelope& envelope) {
        for (const std::size_t t : {std::size_t(0), std::size_t(4)}) {  // the same line on two equal panels
            const Tile& tile = envelope.tiles[t];
            SurfaceLine line{"tape", Points3(2, 3)};
            line.points.row(0) = tile.mesh.positions.row(tile.mesh.triangles(0, 0));
            line.points.row(1) = tile.mesh.positions.row(tile.mesh.triangles(0, 1));
            envelope.tiles[t].lines.push_back(line);
        }
    });
    EXPECT_EQ(cut[0].same + cut[0].mirrored, 2);
    EXPECT_EQ(cut[2].same + cut[2].mirrored, 6);
    EXPECT_EQ(cut[1].same + cut[1].mirrored, 8);
}

TEST(Pieces, CountEachPartOfASeamWithItsOwnTypeAndAnEdgeWithMostOfIt) {
    CutPlan plan = wall();
    const auto lengths = [&plan] {
        std::map<std::string, double> sum;
        for (const PatternPiece& piece : make_pieces(plan))
            for (const PieceEdge& edge : piece.edges)
                for (const Mate& mate : edge.mates) sum[mate.type + " " + mate.seam] += mate.length;
        return sum;
    };
    for (std::size_t s = 0; s < plan.seams.size(); s += 2) plan.seams[s].type = {"taped", 0.025, 4, true};
    for (const PatternPiece& piece : make_pieces(plan))
        for (const PieceEdge& edge : piece.edges) {
            std::map<std::string, double> of_type;
            for (const Mate& mate : edge.mates) of_type[mate.type] += mate.length;
            for (const auto& [type, length] : of_type)
                EXPECT_LE(length, of_type.at(edge.seam_type) + 0.1) << "within a mesh edge at either end";
        }
    const auto found = lengths();
    EXPECT_EQ(found.size(), plan.seams.size()) << "no part of a seam counts with another's type";
    for (const Seam& seam : plan.seams)
        EXPECT_NEAR(found.at(seam.type.name + " " + seam.id), 2 * seam.length, 1e-6) << seam.id;
}

TEST(SeamMarks, StandCloserWhereTheSeamBends) {
    const CutPlan& plan = balloon();
    double widest = 0, closest = 1e9;
    for (const Seam& seam : plan.seams) {
        const std::vector<SeamMark> marks = seam_marks(plan.tiles, seam);
        for (std::size_t i = 1; i < marks.size(); ++i) {
            widest = std::max(widest, marks[i].along - marks[i - 1].along);
            closest = std::min(closest, marks[i].along - marks[i - 1].along);
        }
    }
    EXPECT_LE(widest, NotchOptions{}.straight_spacing * (1 + 1e-9));
    EXPECT_LT(closest, widest);
}

TEST(Pieces, DrawTheMarksWhereNothingIsAllowedToBeCut) {
    CutPlan plan = balloon();
    for (Seam& seam : plan.seams) seam.type = {"raw", 0, 0, false};
    for (const PatternPiece& piece : make_pieces(plan)) {
        std::size_t strokes = 0;
        for (const PieceNotch& notch : piece.notches) {
            EXPECT_EQ(notch.slits().empty(), notch.reach == 0);
            if (notch.reach == 0) strokes += static_cast<std::size_t>(notch.count);
        }
        ASSERT_GT(strokes, 2U);
        EXPECT_EQ(piece.lines.size(), strokes);
        for (const DrawnLine& line : piece.lines) {
            EXPECT_LT(distance_to_outline(piece.sew_line, line.points.row(0)), 0.2e-3);
            EXPECT_TRUE(contains(piece.sew_line, Vec2(line.points.row(1)))) << "and goes inwards";
        }
    }
}

TEST(Pieces, NotchWhereASeamEndsWithinAnEdge) {
    int ends = 0;
    for (const PatternPiece& piece : make_pieces(wall()))
        for (const PieceNotch& notch : piece.notches) {
            const auto seam = std::find_if(wall().seams.begin(), wall().seams.end(),
                                           [&notch](const Seam& other) { return other.id == notch.seam; });
            ends += notch.along == 0 || notch.along == seam->length;
        }
    EXPECT_GT(ends, 12) << "bricks are staggered: each row meets the middles of the next";
}

}  // namespace pieces_of_envelope_test
}  // namespace ripstop
