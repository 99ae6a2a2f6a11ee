/// From the seams to the cloth: edges that are sewn together are cut to one length.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ripstop/mesh/boundary.h"
#include "ripstop/pipeline/flatten/flatten_envelope.h"
#include "ripstop/pipeline/read/read_envelope.h"
#include "ripstop/tile/targets.h"
#include "support/envelopes.h"

namespace ripstop {
namespace seams_test {

/// The length of a side of a seam on the cloth; an edge that two seams share counts in proportion.
double flat_length(const CutPlan& plan, const SeamSide& side) {
    const FlatTile& tile = plan.tiles[static_cast<std::size_t>(side.tile)];
    const Eigen::VectorXd flat = edge_lengths(tile.flattening.positions, closed(tile.tile.boundary));
    const Eigen::VectorXd drawn = drawn_lengths(tile.tile);
    double sum = 0;
    for (const SeamPart& part : side.parts) sum += part.length * flat[part.edge] / drawn[part.edge];
    return sum;
}

double worst_mismatch(const Envelope& envelope) {
    const CutPlan plan = flatten_envelope(envelope, {});
    double worst = 0;
    for (const Seam& seam : envelope.seams)
        worst = std::max(worst, std::abs(flat_length(plan, seam.a) - flat_length(plan, seam.b)) / seam.length);
    return worst;
}

/// The length difference of the two sides as polylines.
double polyline_mismatch(const Envelope& envelope) {
    double worst = 0;
    for (const Seam& seam : envelope.seams) {
        const auto chords = [&](const SeamSide& side) {
            const Tile& tile = envelope.tiles[static_cast<std::size_t>(side.tile)];
            const Eigen::VectorXd lengths = edge_lengths(tile.mesh.positions, closed(tile.boundary));
            const Eigen::VectorXd drawn = drawn_lengths(tile);
            double sum = 0;
            for (const SeamPart& part : side.parts) sum += part.length * lengths[part.edge] / drawn[part.edge];
            return sum;
        };
        worst = std::max(worst, std::abs(chords(seam.a) - chords(seam.b)) / seam.length);
    }
    return worst;
}

TEST(SeamExact, CutsTilesMeshedApartToTheSameLengths) {
    EnvelopeDesign design;
    design.gores = 24;
    design.panels = 8;
    const Envelope envelope = make_envelope(testing::meshed_apart(design, 2), {});
    ASSERT_EQ(static_cast<int>(envelope.seams.size()), testing::seam_count(design));
    EXPECT_GT(polyline_mismatch(envelope), 1e-4) << "as polylines they would differ: nothing was shown";
    // the solver's residual of an edge, far below the required 0.01 mm per metre
    EXPECT_LT(worst_mismatch(envelope), 1e-8);
}

TEST(SeamExact, CutsTilesThatMeetAtTJunctionsToTheSameLengths) {
    const Envelope envelope = make_envelope(testing::brick_wall(4, 24, 0.4), {});
    ASSERT_EQ(envelope.seams.size(), 4u * 24 + 3 * 48);
    EXPECT_GT(polyline_mismatch(envelope), 1e-5);
    EXPECT_LT(worst_mismatch(envelope), 1e-8);
}

}  // namespace seams_test
}  // namespace ripstop
