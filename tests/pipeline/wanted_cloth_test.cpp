#include "ripstop/pipeline/flight/wanted_cloth.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "ripstop/assembly/seams/find_seams.h"
#include "ripstop/pipeline/read/read_envelope.h"
#include "ripstop/tile/targets.h"
#include "support/envelopes.h"
#include "support/sewn.h"

namespace ripstop {
namespace wanted_cloth_test {

/// The wanted length of the cloth of each side of a seam.
double cloth_of(const Envelope& envelope, const SeamSide& side) {
    const Tile& tile = envelope.tiles[static_cast<std::size_t>(side.tile)];
    const Eigen::VectorXd drawn = drawn_lengths(tile), wanted = target_lengths(tile);
    double sum = 0;
    for (const SeamPart& part : side.parts) sum += wanted[part.edge] * part.length / drawn[part.edge];
    return sum;
}

TEST(WantedCloth, OfTheDrawingIsTheDrawing) {
    Envelope envelope = testing::gores({0.5}, 4, 4, 8);
    compensate_tiles(drawn_cloth(envelope), envelope);
    for (const Tile& tile : envelope.tiles) {
        EXPECT_LT(tile.compensation.strain.cwiseAbs().maxCoeff(), 1e-13);
        EXPECT_LT((tile.compensation.edges.array() - 1).abs().maxCoeff(), 1e-13);
    }
}

TEST(WantedCloth, OfALargerTargetIsThatMuchLarger) {
    Envelope envelope = testing::gores({0.5}, 4, 4, 8);
    WantedCloth wanted = drawn_cloth(envelope);
    for (Points3& target : wanted.target) target *= 1.03;
    const Eigen::VectorXd drawn = drawn_lengths(envelope.tiles[1]);
    compensate_tiles(wanted, envelope);
    EXPECT_LT((target_lengths(envelope.tiles[1]) - 1.03 * drawn).cwiseAbs().maxCoeff(), 1e-13);
    const double area = target_triangles(envelope.tiles[1])[3].determinant();
    envelope.tiles[1].compensation = {};
    EXPECT_NEAR(area, 1.03 * 1.03 * target_triangles(envelope.tiles[1])[3].determinant(), 1e-14);
    const std::vector<double> factors = tape_factors(wanted, envelope);
    for (const double factor : factors) EXPECT_NEAR(factor, 1.03, 1e-13);
}

TEST(WantedCloth, IsAsLongOnBothSidesOfEverySeamHoweverTheyAreMeshed) {
    // every second row is shifted by half a tile, and each row has its own number of edges: T-junctions within
    // edges
    Envelope envelope = testing::tiles_of(testing::brick_wall(3, 5));
    add_seams(envelope, {});
    ASSERT_GT(envelope.seams.size(), 15u);
    WantedCloth wanted = drawn_cloth(envelope);
    std::srand(7);
    for (Points3& strain : wanted.strain) strain = 0.01 * Points3::Random(strain.rows(), 3);
    compensate_tiles(wanted, envelope);
    for (const Seam& seam : envelope.seams) {
        EXPECT_NEAR(cloth_of(envelope, seam.a) / cloth_of(envelope, seam.b), 1, 1e-9) << seam.id;
    }
}

TEST(WantedCloth, ShortensTapesForTheStrainTheyHaveInFlight) {
    Envelope envelope = testing::gores({0.5}, 4, 4, 8);
    WantedCloth wanted = drawn_cloth(envelope);
    wanted.tape_strain.assign(envelope.seams.size(), 0.01);
    for (const double factor : tape_factors(wanted, envelope)) EXPECT_NEAR(factor, 1 / std::sqrt(1.02), 1e-12);
}

}  // namespace wanted_cloth_test
}  // namespace ripstop
