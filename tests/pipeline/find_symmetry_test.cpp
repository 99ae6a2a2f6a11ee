#include "ripstop/pipeline/flight/find_symmetry.h"

#include <gtest/gtest.h>

#include "ripstop/base/text/units.h"
#include "ripstop/pipeline/flatten/flatten_envelope.h"
#include "ripstop/pipeline/remesh/remesh_envelope.h"
#include "ripstop/remesh/remesh_disk.h"
#include "support/balloons.h"

namespace ripstop {
namespace find_symmetry_test {

EnvelopeDesign lobed() {
    return {.gores = 12, .panels = 6, .volume = 300, .bulge = 20 * degree, .edge_length = 0.6};
}

TEST(FindSymmetry, FindsEverySectorOfADesign) {
    const Symmetry symmetry = find_symmetry(testing::cut_balloon(lobed(), false));
    EXPECT_EQ(symmetry.sectors, 12);
    EXPECT_LT(symmetry.axis.head<2>().norm(), 1e-9);
}

// Its mouth edges turn by exactly ten times the largest turn of an edge: rounding must not divide some by ten and
// others by eleven.
TEST(FindSymmetry, FindsEverySectorOnceTheTilesAreRemeshed) {
    if (!can_remesh()) GTEST_SKIP() << "built without CGAL";
    Envelope envelope = testing::balloon(lobed());
    remesh_envelope(envelope, {.mode = RemeshMode::automatic});
    ASSERT_TRUE(envelope.tiles[0].remeshed);
    EXPECT_EQ(find_symmetry(flatten_envelope(envelope, {})).sectors, 12);
}

TEST(FindSymmetry, FindsNoneWhereOneTileIsCutOtherwise) {
    CutPlan plan = testing::cut_balloon(lobed(), false);
    plan.tiles[20].flattening.positions *= 1.001;
    EXPECT_EQ(find_symmetry(plan).sectors, 1);
}

}  // namespace find_symmetry_test
}  // namespace ripstop
