#include "ripstop/flatten/seam/seam_stretch.h"

#include <gtest/gtest.h>

#include <set>

#include "ripstop/base/error.h"
#include "ripstop/tile/targets.h"
#include "support/sewn.h"
#include "support/sphere_patches.h"

namespace ripstop {
namespace seam_stretch_test {

/// A long tile in the west and two in the east, which meet in the middle of one of its edges; their vertices do
/// not match.
Envelope junction() {
    return testing::sewn_patches(
        {{"west", -0.4, 0, -0.4, 0.4, 5, 9}, {"south", 0, 0.3, -0.4, 0.03, 6, 13}, {"north", 0, 0.3, 0.03, 0.4, 4, 8}});
}

TEST(SeamStretch, OfTilesThatShareVerticesIsAnIntervalAnEdge) {
    const Envelope envelope = testing::gores({0.5, 0.3}, 4, 4, 12);
    const SeamStretch stretch = find_seam_stretch(envelope);
    // the tiles do not cover the whole sphere: 3 seams of 12 edges
    ASSERT_EQ(envelope.seams.size(), 3u);
    EXPECT_EQ(stretch.count, 36);
    for (std::size_t t = 0; t < 4; ++t) {
        const TileStretch& own = stretch.tiles[t];
        const Eigen::VectorXd lengths = target_lengths(envelope.tiles[t]);
        EXPECT_EQ(own.intervals.size(), t == 0 || t == 3 ? 12u : 24u);
        for (Eigen::Index e = 0; e < lengths.size(); ++e) {
            const bool sewn = (own.reach.row(e).array() != 0).any();
            EXPECT_EQ((own.reach.row(e).array() != 0).count(), sewn ? 1 : 0);
            EXPECT_NEAR(own.reach.row(e).sum(), sewn ? lengths[e] : 0, 1e-15);
        }
        EXPECT_EQ((own.reach.array() != 0).count(), static_cast<Eigen::Index>(own.intervals.size()));
    }
}

TEST(SeamStretch, OneStretchForAllStretchesEverySewnEdgeByItAndNoOther) {
    const Envelope envelope = junction();
    const SeamStretch stretch = find_seam_stretch(envelope);
    for (std::size_t t = 0; t < envelope.tiles.size(); ++t) {
        std::set<int> sewn;
        for (const Seam& seam : envelope.seams)
            for (const SeamSide* side : {&seam.a, &seam.b})
                if (side->tile == static_cast<int>(t))
                    for (const SeamPart& part : side->parts) sewn.insert(part.edge);
        const Eigen::VectorXd targets = target_lengths(envelope.tiles[t]),
                              sums = stretch.tiles[t].reach.rowwise().sum();
        for (int e = 0; e < targets.size(); ++e) EXPECT_NEAR(sums[e], sewn.contains(e) ? targets[e] : 0, 1e-14);
    }
}

TEST(SeamStretch, AnEdgeThatTwoSeamsShareHasOneStretch) {
    const Envelope envelope = junction();
    const SeamStretch stretch = find_seam_stretch(envelope);
    ASSERT_EQ(envelope.seams.size(), 3u);
    // an interval for each of the 9 edges of the west, including the one in both seams, and for the 4 between
    // south and north
    EXPECT_EQ(stretch.count, 9 + 4);
    const TileStretch& west = stretch.tiles[0];
    for (Eigen::Index e = 0; e < west.reach.rows(); ++e) EXPECT_LE((west.reach.row(e).array() > 1e-12).count(), 1);
}

TEST(SeamStretch, DoesNotCareWhichSideIsNamedFirst) {
    Envelope envelope = junction();
    const SeamStretch one = find_seam_stretch(envelope);
    for (Seam& seam : envelope.seams) {
        // the seam now starts at its other end
        std::swap(seam.a, seam.b);
    }
    const SeamStretch other = find_seam_stretch(envelope);
    ASSERT_EQ(one.count, other.count);
    for (std::size_t t = 0; t < one.tiles.size(); ++t) {
        const Eigen::MatrixXd a = one.tiles[t].reach, b = other.tiles[t].reach;
        EXPECT_LT((a * a.transpose() - b * b.transpose()).norm(), 1e-13);  // equal up to the intervals' numbering
    }
}

TEST(SeamStretch, CompensationIsTakenBesideTheStretch) {
    Envelope envelope = testing::gores({0.5}, 2, 4, 12);
    envelope.tiles[0].compensation = {0.01, 0.01, {}};
    const SeamStretch stretch = find_seam_stretch(envelope);
    EXPECT_NEAR(stretch.tiles[0].reach.sum(), 1.01 * stretch.tiles[1].reach.sum(), 1e-12);
}

TEST(SeamStretch, RefusesSeamsThatAreNone) {
    const Envelope good = testing::gores({0.5}, 2, 4, 12);
    const auto message = [&](auto&& spoil) -> std::string {
        Envelope envelope = good;
        spoil(envelope.seams.front());
        try {
            find_seam_stretch(envelope);
            return "";
        } catch (const InputError& error) {
            return error.what();
        }
    };
    EXPECT_EQ(message([](Seam&) {}), "");
    EXPECT_NE(message([](Seam& seam) { seam.b.tile = 2; }).find("names tile 2, there are 2"), std::string::npos);
    EXPECT_NE(message([](Seam& seam) { seam.a.parts[0].edge = 99; }).find("edge 99 of tile G1"), std::string::npos);
    EXPECT_NE(message([](Seam& seam) { seam.b.parts.clear(); }).find("has no part on tile G2"), std::string::npos);
    EXPECT_NE(message([](Seam& seam) { seam.a.parts.pop_back(); }).find("measure both on one curve"),
              std::string::npos);
}

}  // namespace seam_stretch_test
}  // namespace ripstop
