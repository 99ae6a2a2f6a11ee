#include "ripstop/inflate/sew.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>

#include "ripstop/base/error.h"
#include "ripstop/inflate/inflate.h"
#include "ripstop/io/json/fabric_json.h"
#include "ripstop/pipeline/flatten/flatten_envelope.h"
#include "ripstop/pipeline/flight/find_symmetry.h"
#include "ripstop/pipeline/flight/tape_seams.h"
#include "ripstop/pipeline/read/read_envelope.h"
#include "ripstop/tile/seam_place.h"
#include "support/balloons.h"
#include "support/envelopes.h"
#include "support/refusal.h"
#include "support/shapes.h"

namespace ripstop {
namespace sew_test {

using namespace testing;

const EnvelopeDesign small{.gores = 8, .panels = 2, .volume = 600, .edge_length = 0.8};

CutPlan small_plan(bool with_tapes = false) {
    return cut_balloon(small, with_tapes);
}

FlattenOptions nylon() {
    FlattenOptions options;
    options.fabric = fabric_named("nylon");
    return options;
}

Vec3 at(const SewnEnvelope& sewn, const Points3& nodes, int tile, int vertex) {
    return position(sewn.places[static_cast<std::size_t>(sewn.first_vertex[static_cast<std::size_t>(tile)] + vertex)],
                    nodes, 2 * std::numbers::pi / sewn.sectors);
}

/// The boundary vertices of a side of a seam.
std::vector<int> vertices_of(const CutPlan& plan, const SeamSide& side) {
    const std::vector<int>& boundary = plan.tiles[static_cast<std::size_t>(side.tile)].tile.boundary;
    std::vector<int> vertices = {boundary[static_cast<std::size_t>(side.parts[0].edge)]};
    for (const SeamPart& part : side.parts)
        vertices.push_back(boundary[static_cast<std::size_t>(part.edge + 1) % boundary.size()]);
    return vertices;
}

/// The largest difference between the motion of vertices inside one side of a seam and that of the same places on
/// the other.
double tear(const CutPlan& plan, const SewnEnvelope& sewn, const Points3& nodes, const Seam& seam, bool second) {
    const auto moved = [&](int tile, int vertex) -> Vec3 {
        return at(sewn, nodes, tile, vertex) - at(sewn, sewn.nodes, tile, vertex);
    };
    const SeamSide &own = second ? seam.b : seam.a, &other = second ? seam.a : seam.b;
    const std::vector<int>& mates = plan.tiles[static_cast<std::size_t>(other.tile)].tile.boundary;
    const std::vector<int> vertices = vertices_of(plan, own);
    double most = 0, along = 0;
    for (std::size_t i = 0; i + 1 < own.parts.size(); ++i) {
        along += own.parts[i].length;
        const BoundaryPlace mate = place_on_side(plan.tiles, seam, !second, second ? seam.length - along : along);
        const auto edge = static_cast<std::size_t>(mate.edge);
        const Vec3 expected = (1 - mate.share) * moved(other.tile, mates[edge]) +
                              mate.share * moved(other.tile, mates[(edge + 1) % mates.size()]);
        most = std::max(most, (moved(own.tile, vertices[i + 1]) - expected).norm());
    }
    return most;
}

/// Moves every node; seams must stay closed.
Points3 thrown(const SewnEnvelope& sewn) {
    Points3 nodes = sewn.nodes;
    for (Eigen::Index n = 0; n < nodes.rows(); ++n)
        nodes.row(n) +=
            0.05 * Eigen::RowVector3d(std::sin(7.0 * static_cast<double>(n)), std::cos(3.0 * static_cast<double>(n)),
                                      std::sin(5.0 * static_cast<double>(n)));
    return nodes;
}

using testing::refusal;

TEST(Sew, VerticesThatMeetOnASeamAreOne) {
    const CutPlan plan = small_plan();
    const SewnEnvelope sewn = sew(plan);
    EXPECT_LT(sewn.seam_gap, 1e-12);
    const Points3 nodes = thrown(sewn);
    int shared = 0;
    for (const Seam& seam : plan.seams) {
        std::vector<int> a = vertices_of(plan, seam.a), b = vertices_of(plan, seam.b);
        ASSERT_EQ(a.size(), b.size());
        std::reverse(b.begin(), b.end());
        for (std::size_t i = 0; i < a.size(); ++i, ++shared)
            EXPECT_EQ(at(sewn, nodes, seam.a.tile, a[i]), at(sewn, nodes, seam.b.tile, b[i]));
    }
    EXPECT_GT(shared, 100);
    int vertices = 0;
    for (const FlatTile& tile : plan.tiles) vertices += tile.tile.mesh.vertex_count();
    EXPECT_LT(sewn.nodes.rows(), vertices);
}

TEST(Sew, UnequalSidesBecomeEase) {
    // Every second gore is cut 2 % larger: its sides differ at rest but coincide in space.
    CutPlan plan = small_plan();
    for (std::size_t i = 0; i < plan.tiles.size(); ++i)
        if (i / 2 % 2 == 1) plan.tiles[i].flattening.positions *= 1.02;
    const Inflated inflated = inflate(plan, {});
    ASSERT_EQ(inflated.summary.termination, Termination::converged);
    const auto cut_length = [&](const SeamSide& side) {
        const std::vector<int> line = vertices_of(plan, side);
        const Points2& u = plan.tiles[static_cast<std::size_t>(side.tile)].flattening.positions;
        double sum = 0;
        for (std::size_t i = 1; i < line.size(); ++i) sum += (u.row(line[i]) - u.row(line[i - 1])).norm();
        return sum;
    };
    int eased = 0;
    for (const Seam& seam : plan.seams) {
        std::vector<int> a = vertices_of(plan, seam.a), b = vertices_of(plan, seam.b);
        std::reverse(b.begin(), b.end());
        for (std::size_t i = 0; i < a.size(); ++i)
            EXPECT_EQ(inflated.tiles[static_cast<std::size_t>(seam.a.tile)].positions.row(a[i]),
                      inflated.tiles[static_cast<std::size_t>(seam.b.tile)].positions.row(b[i]));
        if (seam.a.tile / 2 % 2 == seam.b.tile / 2 % 2) continue;
        EXPECT_NEAR(std::abs(std::log(cut_length(seam.a) / cut_length(seam.b))), std::log(1.02), 1e-9);
        ++eased;
    }
    EXPECT_EQ(eased, 16);
    // Along the gores, the larger ones are stretched less.
    double larger = 0, smaller = 0;
    for (std::size_t i = 0; i < plan.tiles.size(); ++i)
        (i / 2 % 2 == 1 ? larger : smaller) += inflated.tiles[i].strain.col(0).mean() / 8;
    EXPECT_GT(smaller, larger + 0.002);
}

TEST(Sew, TJunctionsAndNeighboursMeshedDifferentlyLeaveNoGap) {
    const std::vector<std::pair<const char*, Envelope>> envelopes = {
        {"bricks", make_envelope(brick_wall(4, 5), {})},
        {"meshed separately", make_envelope(meshed_apart(small, 3), {.seam_tolerance = 0.02})}};
    for (const auto& [name, envelope] : envelopes) {
        const CutPlan plan = flatten_envelope(envelope, nylon());
        const SewnEnvelope sewn = sew(plan);
        const Points3 nodes = thrown(sewn);
        int hanging = 0;
        for (const SewnPoint& place : sewn.places) {
            double sum = 0;
            for (const NodeShare& part : place.shares) sum += part.weight;
            EXPECT_NEAR(sum, 1, 1e-12);
            hanging += !place.is_node();
        }
        EXPECT_GT(hanging, 50) << name;
        // Nothing leaves its drawn place, except where the ends of seams are drawn apart.
        EXPECT_LT(sewn.seam_gap, 1e-3) << name;
        for (const Seam& seam : plan.seams) {
            // The finer side hangs on the edges of the coarser one.
            const double a = tear(plan, sewn, nodes, seam, false), b = tear(plan, sewn, nodes, seam, true);
            EXPECT_LT(std::min(a, b), 1e-5) << name << " " << seam.id;  // places are equal to 1e-5 of an edge
        }
    }
}

TEST(Sew, TilesMeshedApartInflateLikeTheSameShapeMeshedAsOne) {
    const EnvelopeDesign design{.gores = 8, .panels = 2, .volume = 600, .edge_length = 0.5};
    const ReadOptions reading{.seam_tolerance = 0.02, .fabric = nylon().fabric};
    const Inflated apart = inflate(flatten_envelope(make_envelope(meshed_apart(design, 3, 1.5), reading), nylon()), {});
    const Inflated one = inflate(cut_balloon(design, false), {});
    ASSERT_EQ(apart.summary.termination, Termination::converged);
    // Edges of a tenth of the radius: each mesh has an error of some tenths of a per cent.
    EXPECT_NEAR(apart.volume, one.volume, 0.005 * one.volume);
    EXPECT_NEAR(apart.height, one.height, 0.005 * one.height);
    EXPECT_NEAR(apart.imbalance, 0, 1e-6);
}

TEST(FindSymmetry, FindsAllEqualSectors) {
    const CutPlan plan = small_plan(true);
    const Symmetry symmetry = find_symmetry(plan);
    EXPECT_EQ(symmetry.sectors, 8);
    EXPECT_LT(symmetry.axis.head<2>().norm(), 1e-9);
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        EXPECT_EQ(symmetry.tiles[i].of, static_cast<int>(i % 2));
        const Eigen::AngleAxisd turn(symmetry.tiles[i].turns * symmetry.angle(), Vec3::UnitZ());
        const Points3& x = plan.tiles[i].tile.mesh.positions;
        const Points3& first = plan.tiles[i % 2].tile.mesh.positions;
        for (Eigen::Index v = 0; v < x.rows(); ++v) {
            const std::vector<int>& to = symmetry.tiles[i].vertex;
            const Eigen::Index mate = to.empty() ? v : to[static_cast<std::size_t>(v)];
            EXPECT_LT((turn * Vec3(first.row(mate)) - Vec3(x.row(v))).norm(), 1e-6);
        }
    }
}

TEST(FindSymmetry, FindsTheAxisWhereverItStands) {
    EnvelopeDesign design = small;
    std::vector<NamedMesh> tiles = design_natural(design);
    for (NamedMesh& tile : tiles) tile.mesh.positions.rowwise() += Eigen::RowVector3d(30, -20, 5);
    const CutPlan plan = flatten_envelope(make_envelope(tiles, {.fabric = nylon().fabric}), nylon());
    const Symmetry symmetry = find_symmetry(plan);
    EXPECT_EQ(symmetry.sectors, 8);
    EXPECT_NEAR(symmetry.axis.x(), 30, 1e-6);
    EXPECT_NEAR(symmetry.axis.y(), -20, 1e-6);
}

TEST(FindSymmetry, FindsNoneWhereOneTileOrSeamDiffers) {
    CutPlan longer = small_plan(true), moved = longer, taped = longer;
    longer.tiles[5].flattening.positions *= 1.0001;
    EXPECT_EQ(find_symmetry(longer).sectors, 1);
    moved.tiles[5].tile.mesh.positions(3, 2) += 1e-4;
    EXPECT_EQ(find_symmetry(moved).sectors, 1);
    for (Seam& seam : taped.seams)
        if (seam.type.tape) {
            seam.type.tape = false;
            break;
        }
    EXPECT_EQ(find_symmetry(taped).sectors, 1);
}

TEST(TapeMeridians, FollowTheGoresAndNoOtherSeams) {
    const CutPlan plan = small_plan(true);
    int taped = 0;
    for (const Seam& seam : plan.seams) {
        EXPECT_EQ(seam.type.tape, seam.a.tile / 2 != seam.b.tile / 2) << seam.id;
        taped += seam.type.tape;
    }
    EXPECT_EQ(taped, 16);
}

TEST(Sew, LoadTapesAreShorterThanTheirSeamsAsAsked) {
    CutPlan plan = small_plan(true);
    plan.tape_factors.assign(plan.seams.size(), 1.01);
    SewOptions options;
    options.rigging.foreshortening = 0.02;
    std::map<int, double> lengths;
    for (const SewnTape& tape : sew(plan, options).tapes)
        if (tape.kind == TapeKind::load) lengths[tape.source] += tape.rest;
    EXPECT_EQ(lengths.size(), 16u);
    for (const auto& [seam, length] : lengths)
        EXPECT_NEAR(length, 0.98 * 1.01 * plan.seams[static_cast<std::size_t>(seam)].length, 1e-9);
}

TEST(Sew, WiresHoldTheMouthAndBearTheLift) {
    const CutPlan plan = small_plan(true);
    const SewnEnvelope sewn = sew(plan);
    const Equilibrium found = rest(sewn, sewn.nodes);
    Balance balance(sewn, hot_air(sewn), 0);
    balance.set_residual(1e-4);
    double pull = 0, weight = 0;
    int wires = 0;
    for (const SewnTape& tape : sewn.tapes) {
        if (tape.kind != TapeKind::wire) continue;
        const Vec3 a = position(tape.a, found.nodes, 0), b = position(tape.b, found.nodes, 0);
        const double stretch = (a - b).norm() / tape.rest;
        pull += tape.stiffness * 0.5 * (stretch * stretch - 1) * stretch * (a - b).normalized().z();
        weight += 9.80665 * tape.mass * tape.rest;
        ++wires;
    }
    EXPECT_EQ(wires, 8);
    EXPECT_EQ(sewn.held.size(), 8u);
    EXPECT_NEAR(pull - 0.5 * weight, balance.lift(found.nodes),
                1e-6 * pull);  // half of the wires' weight hangs on the frame
}

/// A flat lid across the envelope at the seams between the first two panels, with its edge on their vertices.
NamedMesh lid(const Envelope& envelope) {
    std::map<long, Vec3> rim;  // by angle
    double z = 0;
    for (const Seam& seam : envelope.seams)
        if (seam.a.tile / 2 == seam.b.tile / 2) {
            const Tile& tile = envelope.tiles[static_cast<std::size_t>(seam.a.tile)];
            for (const SeamPart& part : seam.a.parts) {
                const Vec3 x = tile.mesh.positions.row(tile.boundary[static_cast<std::size_t>(part.edge)]);
                rim[std::lround(1e6 * std::atan2(x.y(), x.x()))] = x;
                const Vec3 next = tile.mesh.positions.row(
                    tile.boundary[static_cast<std::size_t>(part.edge + 1) % tile.boundary.size()]);
                rim[std::lround(1e6 * std::atan2(next.y(), next.x()))] = next;
                z = x.z();
            }
        }
    // Duplicate vertices where two seams meet are merged to a micrometre; two rings inside the rim.
    std::vector<Vec3> points;
    for (const auto& [angle, x] : rim)
        if (points.empty() || (points.back() - x).norm() > 1e-4) points.push_back(x);
    if ((points.front() - points.back()).norm() < 1e-4) points.pop_back();
    const int n = static_cast<int>(points.size());
    NamedMesh mesh{"LID", {}};
    mesh.mesh.positions.resize(2 * n + 1, 3);
    mesh.mesh.triangles.resize(3 * n, 3);
    mesh.mesh.positions.row(2 * n) << 0, 0, z;
    for (int k = 0; k < n; ++k) {
        const int next = (k + 1) % n;
        mesh.mesh.positions.row(k) = points[static_cast<std::size_t>(k)];
        mesh.mesh.positions.row(n + k) = 0.5 * (points[static_cast<std::size_t>(k)] + Vec3(0, 0, z));
        mesh.mesh.triangles.row(3 * k) << k, next, n + k;
        mesh.mesh.triangles.row(3 * k + 1) << next, n + next, n + k;
        mesh.mesh.triangles.row(3 * k + 2) << n + k, n + next, 2 * n;
    }
    return mesh;
}

CutPlan plan_with_lid(double cut) {
    std::vector<NamedMesh> tiles = design_natural(small);
    tiles.push_back(lid(make_envelope(tiles, {.fabric = nylon().fabric})));
    CutPlan plan = flatten_envelope(make_envelope(tiles, {.fabric = nylon().fabric}), nylon());
    plan.tiles.back().flattening.positions *= cut;
    return plan;
}

Inflated with_diaphragm(const CutPlan& plan) {
    InflateOptions options;
    options.sewing.rigging.diaphragms = {"LID"};
    return inflate(plan, options);
}

double rim_radius(const CutPlan& plan, const Inflated& inflated) {
    double sum = 0;
    for (const int v : plan.tiles.back().tile.boundary)
        sum += inflated.tiles.back().positions.row(v).head<2>().norm() /
               static_cast<double>(plan.tiles.back().tile.boundary.size());
    return sum;
}

TEST(Sew, ADiaphragmHoldsTheSkinIn) {
    const CutPlan large = plan_with_lid(1.2), fitting = plan_with_lid(1), small_lid = plan_with_lid(0.9);
    const Inflated free = with_diaphragm(large), held = with_diaphragm(small_lid);
    ASSERT_EQ(free.summary.termination, Termination::converged);
    ASSERT_EQ(held.summary.termination, Termination::converged);
    EXPECT_NEAR(rim_radius(small_lid, held) / rim_radius(large, free), 0.9, 0.03);
    EXPECT_GT(held.tiles.back().tension_max, 20);
    // In flight its edge stays on the skin, on the same vertices.
    EXPECT_LT(held.seam_gap, 1e-9);
    EXPECT_NEAR(held.imbalance, 0, 1e-6);
}

TEST(Sew, ASlackDiaphragmHasGasOnBothSidesAndChangesNothing) {
    CutPlan with = plan_with_lid(1.2);
    const CutPlan without = flatten_envelope(make_envelope(design_natural(small), {.fabric = nylon().fabric}), nylon());
    for (FlatTile& tile : with.tiles)
        if (tile.tile.name == "LID") {
            tile.tile.fabric = with.fabric;
            tile.tile.fabric->mass = 1e-6;
        }
    const Inflated found = with_diaphragm(with), bare = inflate(without, {});
    ASSERT_EQ(found.summary.termination, Termination::converged);
    // Its residual stiffness pushes outwards by 1e-4 of 60 kN/m, times a fifth.
    EXPECT_NEAR(found.volume, bare.volume, 1e-3 * bare.volume);
    EXPECT_NEAR(found.lift, bare.lift, 1e-3 * bare.lift);
    for (std::size_t i = 0; i < bare.tiles.size(); ++i)
        EXPECT_LT((found.tiles[i].positions - bare.tiles[i].positions).rowwise().norm().maxCoeff(), 0.02);
}

/// A tie between two opposite vertices of the skin, between the panels.
InnerTie tie_across(const CutPlan& plan, double share) {
    const Tile& tile = plan.tiles[0].tile;
    Vec3 from = tile.mesh.positions.row(0);
    for (Eigen::Index v = 0; v < tile.mesh.positions.rows(); ++v)
        if (tile.mesh.positions(v, 2) > from.z()) from = tile.mesh.positions.row(v);
    const Vec3 to(-from.x(), -from.y(), from.z());
    return {"T1", from, to, share * (to - from).norm(), {500e3, 10e3, 0}};
}

TEST(Sew, ATieHoldsItsEndsAtItsLengthAndDoesNothingWhereItIsSlack) {
    const CutPlan plan = small_plan();
    const Inflated bare = inflate(plan, {});
    for (const double share : {0.85, 1.3}) {
        InflateOptions options;
        options.sewing.rigging.ties = {tie_across(plan, share)};
        const Inflated found = inflate(plan, options);
        ASSERT_EQ(found.summary.termination, Termination::converged);
        ASSERT_EQ(found.tapes.size(), 1u);
        const InflatedTape& tie = found.tapes[0];
        EXPECT_EQ(tie.kind, TapeKind::tie);
        EXPECT_NEAR(tie.cut_length, options.sewing.rigging.ties[0].length, 1e-12);
        if (share > 1) {
            EXPECT_EQ(tie.force_max, 0);
            for (std::size_t i = 0; i < bare.tiles.size(); ++i)
                EXPECT_LT((found.tiles[i].positions - bare.tiles[i].positions).rowwise().norm().maxCoeff(), 1e-3);
            continue;
        }
        EXPECT_GT(tie.force_max, 50);
        EXPECT_LT(tie.worst.head<2>().norm(), 0.05);  // its middle, on the axis
        EXPECT_LT(found.volume, bare.volume);
        double nearest = 1e300;  // distance to where one end must be, half the length from the axis
        for (const InflatedTile& tile : found.tiles)
            for (Eigen::Index v = 0; v < tile.positions.rows(); ++v)
                nearest = std::min(nearest, std::abs(tile.positions.row(v).head<2>().norm() - 0.5 * tie.cut_length) +
                                                std::abs(tile.positions(v, 2) - tie.worst.z()));
        EXPECT_LT(nearest, 0.01);  // the tie stretches by its force over 500 kN
    }
}

TEST(Sew, WhatCannotBeSewnIsRefusedInOneSentence) {
    using ::testing::HasSubstr;
    CutPlan plan = small_plan();
    CutPlan unflattened = plan, flipped = plan;
    unflattened.tiles[3].flattening.positions.resize(0, 2);
    EXPECT_THAT(refusal([&] { sew(unflattened); }), HasSubstr("tile G02P02: has no flat positions"));
    flipped.tiles[3].flattening.positions.col(0) *= -1;
    EXPECT_THAT(refusal([&] { sew(flipped); }), HasSubstr("tile G02P02: triangle 1 is flipped or without area"));

    SewOptions options;
    options.rigging.mouth = MouthHold::wires;
    EXPECT_THAT(refusal([&] { sew(plan, options); }), HasSubstr("fewer than three load tapes end at it"));
    options = {};
    options.rigging.diaphragms = {"RIB*"};
    EXPECT_THAT(refusal([&] { sew(plan, options); }), HasSubstr("diaphragm \"RIB*\": fits no tile"));
    options = {};
    options.rigging.ties = {{"T7", Vec3(0, 0, 3), Vec3(1, 0, 3), 0, {}}};
    EXPECT_THAT(refusal([&] { sew(plan, options); }),
                HasSubstr("tie T7: its end at (0.000, 0.000, 3.000) m is further than 20 mm from the skin"));

    std::vector<NamedMesh> tiles = design_natural(small);
    tiles.push_back({"RIB", rectangle(1, 1, 2, 2)});
    tiles.back().mesh.positions.col(2).array() += 4;
    const CutPlan with_rib = flatten_envelope(make_envelope(tiles, {.fabric = nylon().fabric}), nylon());
    options = {};
    options.rigging.diaphragms = {"RIB"};
    EXPECT_THAT(refusal([&] { sew(with_rib, options); }),
                HasSubstr("diaphragm RIB: its edge lies nowhere within 20 mm of the skin"));
}

}  // namespace sew_test
}  // namespace ripstop
