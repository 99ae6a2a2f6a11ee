#include "ripstop/flatten/seam/seam_matched.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "ripstop/base/error.h"
#include "ripstop/base/text/units.h"
#include "ripstop/energy/boundary_bending.h"
#include "ripstop/flatten/seam/seam_exact.h"
#include "ripstop/flatten/seam/seam_problem.h"
#include "ripstop/measure/measure_accuracy.h"
#include "ripstop/mesh/boundary.h"
#include "ripstop/tile/make_tile.h"
#include "ripstop/tile/targets.h"
#include "support/fabrics.h"
#include "support/flat_errors.h"
#include "support/sewn.h"
#include "support/shapes.h"
#include "support/sphere_patches.h"

namespace ripstop {
namespace seam_matched_test {

constexpr double pi = std::numbers::pi;

using testing::cloth;

const Fabric isotropic = cloth(0.3, 1 / 2.6);
const Fabric weak = cloth(0, 0.01);

/// Gores of 40 and 20 degrees in turn, all around.
Envelope alternating(int columns = 8, int rows = 36) {
    return testing::gores({40 * degree, 20 * degree}, 12, columns, rows);
}

struct Result {
    std::vector<Flattening> flats;
    std::vector<Points2> positions;
    std::vector<double> area_errors;
    double energy = 0;  ///< of the cloth of all tiles [J]
};

Result measured(const Envelope& envelope, const Fabric& fabric, std::vector<Flattening> flats) {
    Result result;
    for (std::size_t t = 0; t < flats.size(); ++t) {
        const Accuracy found = measure_accuracy(envelope.tiles[t], flats[t].positions, fabric);
        result.energy += found.energy;
        result.area_errors.push_back(found.area_error);
        result.positions.push_back(flats[t].positions);
        EXPECT_EQ(found.flipped, 0);
    }
    result.flats = std::move(flats);
    return result;
}

Result matched(const Envelope& envelope, const Fabric& fabric, const SeamMatchedOptions& options = {}) {
    Result result = measured(envelope, fabric, flatten_seam_matched(envelope, fabric, options));
    for (const Flattening& flat : result.flats) {
        EXPECT_EQ(flat.summary.termination, Termination::converged) << flat.summary.text();
        EXPECT_TRUE(flat.certificate && flat.certificate->strict_minimum);
        EXPECT_LT(flat.certificate->force_residual, 1e-6);
        EXPECT_LT(flat.certificate->length_residual, 1e-10);
    }
    return result;
}

/// Every tile separately, with seams as drawn.
Result drawn(const Envelope& envelope, const Fabric& fabric) {
    std::vector<Flattening> flats;
    for (const Tile& tile : envelope.tiles) flats.push_back(flatten_seam_exact(tile, fabric));
    return measured(envelope, fabric, std::move(flats));
}

/// Every tile separately with free edges; no set of tiles has less energy.
Result loose(const Envelope& envelope, const Fabric& fabric) {
    std::vector<Flattening> flats;
    for (const Tile& tile : envelope.tiles) {
        const SeamProblem problem(tile, fabric, {.bending = 1e-5});
        SeamNewton newton(problem);
        const SeamSolution found = newton.minimize(seam_start(tile, SeamStart::arap), {.hold_edges = false});
        flats.emplace_back();
        flats.back().positions = Eigen::Map<const Points2>(found.u.data(), found.u.size() / 2, 2);
    }
    return measured(envelope, fabric, std::move(flats));
}

Eigen::VectorXd turnings(const Tile& tile, const Points2& flat) {
    const auto count = static_cast<int>(tile.boundary.size());
    const auto at = [&](int i) { return Vec2(flat.row(tile.boundary[static_cast<std::size_t>((i + count) % count)])); };
    Eigen::VectorXd turns(count);
    for (int i = 0; i < count; ++i) turns[i] = turning(at(i - 1), at(i), at(i + 1));
    return turns;
}

/// The root mean square, over a gore's seams, of a vertex's turn minus the mean of its neighbours', tips excluded.
double zigzag(const Tile& tile, const Points2& flat) {
    const Eigen::VectorXd turns = turnings(tile, flat);
    const Eigen::Index count = turns.size();
    double sum = 0;
    int vertices = 0;
    for (Eigen::Index i = 0; i < count; ++i) {
        const double before = turns[(i + count - 1) % count], after = turns[(i + 1) % count];
        if (std::max({std::abs(before), std::abs(turns[i]), std::abs(after)}) > 0.5) continue;
        const double deviation = turns[i] - 0.5 * (before + after);
        sum += deviation * deviation;
        ++vertices;
    }
    return std::sqrt(sum / vertices);
}

TEST(SeamMatched, AlternatingGoresGiveTheKnownFigures) {
    const Envelope envelope = alternating(16, 72);
    // in per cent: mismatch of the free tiles, area errors of the wide and the narrow gore; E drawn / E matched:
    // 3.2
    const Result free = loose(envelope, isotropic), exact = drawn(envelope, isotropic);
    const Result both = matched(envelope, isotropic);
    EXPECT_NEAR(testing::worst_mismatch(envelope, free.positions) / percent, 1.58, 0.05 * 1.58);
    EXPECT_NEAR(both.area_errors[0] / percent, -0.45, 0.05 * 0.45);
    EXPECT_NEAR(both.area_errors[1] / percent, 1.01, 0.05 * 1.01);
    EXPECT_NEAR(exact.energy / both.energy, 3.2, 0.05 * 3.2);
    EXPECT_LT(testing::worst_drift(envelope, both.positions), 1e-12);
    EXPECT_LE(both.flats[0].summary.iterations, 4);
}

TEST(SeamMatched, ClothThatShearsGetsNoWaves) {
    const Envelope envelope = alternating(16, 72);
    const Result free = loose(envelope, weak), both = matched(envelope, weak);
    EXPECT_NEAR(testing::worst_mismatch(envelope, free.positions) / percent, 2.19, 0.05 * 2.19);
    EXPECT_LT(testing::worst_drift(envelope, both.positions), 1e-12);
    EXPECT_LE(both.flats[0].summary.iterations, 6);
    for (std::size_t t = 0; t < 2; ++t) {
        EXPECT_LT(zigzag(envelope.tiles[t], both.positions[t]) / degree, 0.1);
        Eigen::VectorXd change =
            turnings(envelope.tiles[t], both.positions[t]) - turnings(envelope.tiles[t], free.positions[t]);
        for (const Chain& chain : envelope.tiles[t].chains)
            for (std::size_t i = 0; i < envelope.tiles[t].boundary.size(); ++i)
                if (envelope.tiles[t].boundary[i] == chain.vertices.front()) change[static_cast<Eigen::Index>(i)] = 0;
        EXPECT_LT(change.cwiseAbs().maxCoeff() / degree, 0.15);
    }
    EXPECT_LT(both.energy, 0.3 * drawn(envelope, weak).energy);
}

TEST(SeamMatched, TheWeakestShearOfTheTablesConvergesToo) {
    const Envelope envelope = alternating();
    const Result both = matched(envelope, cloth(0, 0.002));
    EXPECT_LT(testing::worst_drift(envelope, both.positions), 1e-12);
    for (std::size_t t = 0; t < 2; ++t) EXPECT_LT(zigzag(envelope.tiles[t], both.positions[t]) / degree, 0.1);
}

TEST(SeamMatched, BendingOfTheCutLineCostsUnderATenthOfAPerCentOfTheEnergy) {
    const Envelope envelope = alternating();
    // too little bending leads to saddles of the energy instead of minima, but no wave here is worth a joule
    const Result least = measured(envelope, weak, flatten_seam_matched(envelope, weak, {.bending = 1e-4}));
    EXPECT_LT(matched(envelope, weak).energy / least.energy - 1, 0.001);
}

TEST(SeamMatched, BetweenIdenticalNeighboursItIsFreeOfCharge) {
    for (const Fabric& fabric : {isotropic, weak}) {
        const Envelope envelope = testing::gores({30 * degree}, 12, 8, 36);
        const Result both = matched(envelope, fabric), free = loose(envelope, fabric);
        EXPECT_LT(testing::worst_drift(envelope, both.positions), 1e-12);
        // bending of the cut line changes both by a part in a hundred thousand
        EXPECT_NEAR(both.energy, free.energy, 1e-4 * free.energy);
        // neighbours hardly pull at each other: the forces correspond to strains a thousand times smaller than the
        // tile's
        for (const Flattening& flat : both.flats)
            EXPECT_LT(flat.seam_tension.cwiseAbs().maxCoeff(),
                      1e-3 * drawn(envelope, fabric).flats[0].seam_tension.maxCoeff());
    }
}

TEST(SeamMatched, TightSeamsKeepTheirBoundsAndCostMoreThanFreeOnesAndLessThanDrawnOnes) {
    for (const Fabric& fabric : {isotropic, weak})
        for (const Envelope& envelope : {alternating(), testing::gores({30 * degree}, 12, 8, 36)}) {
            const Result tight = matched(envelope, fabric, {.slack = 0.001});
            EXPECT_LT(testing::worst_drift(envelope, tight.positions), 1e-12);
            double longest = 0;
            for (std::size_t t = 0; t < tight.positions.size(); ++t) {
                const Eigen::ArrayXd flat = edge_lengths(tight.positions[t], closed(envelope.tiles[t].boundary));
                longest = std::max(longest, (flat / drawn_lengths(envelope.tiles[t]).array() - 1).abs().maxCoeff());
            }
            EXPECT_LT(longest, 0.001 + 1e-10);  // edges are kept to 1e-11
            EXPECT_GT(longest, 0.001 - 1e-10);  // and the seams of gores tend to be longer
            EXPECT_LT(tight.energy, drawn(envelope, fabric).energy);
            EXPECT_GT(tight.energy, matched(envelope, fabric).energy);
        }
}

TEST(SeamMatched, WhatTheBoundsDoNotReachIsAsIfThereWereNone) {
    const Envelope envelope = alternating();
    const Result wide = matched(envelope, isotropic, {.slack = 0.5}), none = matched(envelope, isotropic);
    for (std::size_t t = 0; t < 12; ++t) EXPECT_EQ(wide.positions[t], none.positions[t]);
}

/// Three tiles without shared vertices: one in the west, two in the east that meet within one of its edges.
Envelope junction() {
    return testing::sewn_patches({{"west", -0.5, 0, -0.4, 0.4, 8, 15},
                                  {"south", 0, 0.3, -0.4, 0.03, 9, 19},
                                  {"north", 0, 0.3, 0.03, 0.4, 7, 11}});
}

TEST(SeamMatched, SeamsMatchWhereVerticesDifferAndAcrossAJunction) {
    const Envelope envelope = junction();
    ASSERT_EQ(envelope.seams.size(), 3u);
    for (const Fabric& fabric : {isotropic, weak}) {
        const Result both = matched(envelope, fabric);
        EXPECT_LT(testing::worst_mismatch(envelope, both.positions), 1e-10);
        // the change of stretch between edges, up to 0.6 %, times a quarter of an edge's share of its seam, at
        // most 1/7
        EXPECT_LT(testing::worst_drift(envelope, both.positions), 2e-4);
        EXPECT_GT(testing::worst_mismatch(envelope, loose(envelope, fabric).positions), 1e-4);
        EXPECT_LT(both.energy, drawn(envelope, fabric).energy);
    }
}

TEST(SeamMatched, EdgesInNoSeamStayAsDrawn) {
    const Envelope envelope = junction();
    const Result both = matched(envelope, isotropic);
    int held = 0;
    for (int t = 0; t < 3; ++t) {
        std::vector<bool> sewn(envelope.tiles[static_cast<std::size_t>(t)].boundary.size());
        for (const Seam& seam : envelope.seams)
            for (const SeamSide* side : {&seam.a, &seam.b})
                if (side->tile == t)
                    for (const SeamPart& part : side->parts) sewn[static_cast<std::size_t>(part.edge)] = true;
        const Tile& tile = envelope.tiles[static_cast<std::size_t>(t)];
        const Eigen::VectorXd flat = edge_lengths(both.positions[static_cast<std::size_t>(t)], closed(tile.boundary));
        for (std::size_t e = 0; e < sewn.size(); ++e)
            if (!sewn[e]) {
                EXPECT_NEAR(flat[static_cast<Eigen::Index>(e)], drawn_lengths(tile)[static_cast<Eigen::Index>(e)],
                            1e-11);
                ++held;
            }
    }
    EXPECT_GT(held, 40);
}

TEST(SeamMatched, ATileWithoutSeamsIsFlattenedSeamExactly) {
    const Envelope envelope{{make_tile("tile", testing::spherical_square(0.3, 8), {.warp = Vec3::UnitX()})}};
    const Flattening flat = flatten_seam_matched(envelope, weak)[0];
    EXPECT_EQ(flat.positions, flatten_seam_exact(envelope.tiles[0], weak).positions);
    EXPECT_NE(flat.note.find("has no seam with a neighbour"), std::string::npos);
}

TEST(SeamMatched, ATileSewnToItselfMatchesItself) {
    // a cone that is cut open along a ruling, and a bulged one, whose two sides would have different lengths
    const auto closed_tile = [](double bulge) {
        return testing::grid(24, 6, [&](double u, double v) {
            const double turn = 2 * pi * u,
                         radius = 0.3 + 0.5 * v + bulge * std::sin(pi * v) * (1 + 0.4 * std::sin(turn));
            return Vec3(radius * std::cos(turn), radius * std::sin(turn), -v);
        });
    };
    const Envelope cone = testing::sewn({make_tile("cone", closed_tile(0), {.warp = Vec3(1, 0.2, 0)})});
    ASSERT_EQ(cone.seams.size(), 1u);
    EXPECT_EQ(cone.seams[0].a.tile, cone.seams[0].b.tile);
    EXPECT_LT(testing::worst_edge_error(cone.tiles[0].mesh, matched(cone, isotropic).positions[0]), 1e-9);
    const Envelope bulged = testing::sewn({make_tile("bulged", closed_tile(0.04), {.warp = Vec3(1, 0.2, 0)})});
    const Result both = matched(bulged, isotropic);
    EXPECT_LT(testing::worst_drift(bulged, both.positions), 1e-11);
    EXPECT_LE(both.energy, drawn(bulged, isotropic).energy);
}

TEST(SeamMatched, CompensatedSidesMatchBesideTheirCompensation) {
    Envelope envelope = testing::gores({0.5, 0.3}, 3, 4, 16);
    envelope.tiles[1].compensation = {0.01, 0.01, {}};
    const Result both = matched(envelope, isotropic);
    for (const Seam& seam : envelope.seams) {
        const auto length = [&](const SeamSide& side) {
            const auto t = static_cast<std::size_t>(side.tile);
            const Eigen::VectorXd flat = edge_lengths(both.positions[t], closed(envelope.tiles[t].boundary));
            double sum = 0;
            for (const SeamPart& part : side.parts) sum += flat[part.edge];
            return sum / (side.tile == 1 ? 1.01 : 1);
        };
        EXPECT_NEAR(length(seam.a), length(seam.b), 1e-10);
    }
}

/// Axes that rotate with the mesh: those of its first triangle.
Eigen::Matrix3d frame(const TriangleMesh& mesh) {
    const Vec3 along = (mesh.corner(0, 1) - mesh.corner(0, 0)).normalized();
    const Vec3 up = along.cross(mesh.corner(0, 2) - mesh.corner(0, 0)).normalized();
    Eigen::Matrix3d axes;
    axes << along, up.cross(along), up;
    return axes;
}

TEST(SeamMatched, DoesNotCareHowTilesAreOrderedOrWhereTheyStand) {
    const Envelope envelope = junction();
    const Result there = matched(envelope, weak);
    Envelope other;
    const std::vector<int> order{2, 0, 1};  // the new tile i was tile order[i]
    for (const int t : order) {
        Tile tile = envelope.tiles[static_cast<std::size_t>(t)];
        const TriangleMesh turned = testing::moved(tile.mesh);
        tile.grain.direction = frame(turned) * frame(tile.mesh).transpose() * tile.grain.direction;
        tile.mesh = turned;
        other.tiles.push_back(tile);
    }
    for (Seam seam : envelope.seams) {
        for (SeamSide* side : {&seam.a, &seam.b})
            side->tile = static_cast<int>(std::find(order.begin(), order.end(), side->tile) - order.begin());
        std::swap(seam.a, seam.b);
        other.seams.insert(other.seams.begin(), seam);
    }
    const Result elsewhere = matched(other, weak);
    for (std::size_t i = 0; i < order.size(); ++i)
        EXPECT_LT((elsewhere.positions[i] - there.positions[static_cast<std::size_t>(order[i])]).cwiseAbs().maxCoeff(),
                  1e-7);
}

TEST(SeamMatched, GivesTheSameBytesOnAnyNumberOfThreads) {
    const Envelope envelope = alternating();
    const std::vector<Flattening> one = flatten_seam_matched(envelope, weak, {.threads = 1});
    for (const int threads : {2, 5}) {
        const std::vector<Flattening> more = flatten_seam_matched(envelope, weak, {.threads = threads});
        for (std::size_t t = 0; t < one.size(); ++t) {
            EXPECT_EQ(one[t].positions, more[t].positions);
            EXPECT_EQ(one[t].seam_tension, more[t].seam_tension);
        }
    }
}

TEST(SeamMatched, ATileThatCannotBeHeldSaysSoAndItsSeamsStayAsDrawn) {
    Envelope envelope = testing::gores({0.5, 0.3}, 4, 4, 16);
    // an edge in no seam, drawn three metres long, leaves no closed outline
    Tile& broken = envelope.tiles.front();
    broken.curve_lengths = drawn_lengths(broken);
    std::vector<bool> sewn(broken.boundary.size());
    for (const Seam& seam : envelope.seams)
        if (seam.a.tile == 0)
            for (const SeamPart& part : seam.a.parts) sewn[static_cast<std::size_t>(part.edge)] = true;
    broken.curve_lengths[std::find(sewn.begin(), sewn.end(), false) - sewn.begin()] = 30;
    const std::vector<Flattening> flats = flatten_seam_matched(envelope, isotropic);
    EXPECT_NE(flats[0].summary.termination, Termination::converged);
    EXPECT_NE(flats[0].note.find("flattened with its seams as drawn"), std::string::npos);
    for (std::size_t t = 1; t < 4; ++t) EXPECT_EQ(flats[t].summary.termination, Termination::converged);
    for (const Seam& seam : envelope.seams) {
        const auto b = static_cast<std::size_t>(seam.b.tile);
        const Eigen::VectorXd flat = edge_lengths(flats[b].positions, closed(envelope.tiles[b].boundary));
        double stretch = 0;
        for (const SeamPart& part : seam.b.parts)
            stretch = std::max(stretch, std::abs(flat[part.edge] / part.length - 1));
        if (seam.a.tile == 0)
            EXPECT_LT(stretch, 1e-10);
        else
            EXPECT_GT(stretch, 1e-4);
    }
}

TEST(SeamMatched, TellsHowFarFromDrawnTheSeamsAreCut) {
    for (const Flattening& flat : flatten_seam_matched(alternating(), isotropic))
        EXPECT_NE(flat.note.find("% longer than drawn"), std::string::npos);
}

TEST(SeamMatched, RefusesOptionsOutOfRange) {
    const Envelope envelope = alternating(4, 12);
    EXPECT_THROW(flatten_seam_matched(envelope, isotropic, {.slack = 0}), InputError);
    EXPECT_THROW(flatten_seam_matched(envelope, isotropic, {.bending = 0}), InputError);
    EXPECT_THROW(flatten_seam_matched(envelope, isotropic, {.max_iterations = 0}), InputError);
}

}  // namespace seam_matched_test
}  // namespace ripstop
