#include "ripstop/flatten/seam/coarse_start.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ripstop/energy/woven_membrane.h"
#include "ripstop/flatten/map/boundary_first.h"
#include "ripstop/flatten/seam/seam_exact.h"
#include "ripstop/mesh/boundary.h"
#include "ripstop/mesh/change/flips.h"
#include "ripstop/tile/make_tile.h"
#include "ripstop/tile/targets.h"
#include "support/shapes.h"

namespace ripstop {
namespace coarse_start_test {

double worst_edge(const Tile& tile, const Points2& flat) {
    const Eigen::VectorXd lengths = edge_lengths(flat, closed(tile.boundary));
    return (lengths.cwiseQuotient(target_lengths(tile)).array() - 1).abs().maxCoeff();
}

TEST(CoarseStart, ComesWithinAPerCentOfTheLeastEnergyAndNearlyKeepsTheEdges) {
    for (const double shear : {400.0, 10.0}) {
        SCOPED_TRACE(shear);
        Fabric fabric;
        fabric.shear_stiffness = shear;
        const Tile tile = make_tile("lune", testing::lune(0.5, 24, 60), {.warp = Vec3::UnitZ()});
        const Points2 start = flatten_boundary_first(tile).positions;
        const Points2 coarse = coarse_solution(tile, fabric, start);
        const Points2 rest = flatten_seam_exact(tile, fabric).positions;
        const double least = membrane_energy(tile.mesh, rest, fabric);
        EXPECT_NEAR(membrane_energy(tile.mesh, coarse, fabric), least, 0.05 * least);
        EXPECT_GT(membrane_energy(tile.mesh, start, fabric), 1.1 * least);
        EXPECT_LT(worst_edge(tile, coarse), 2e-3);
        EXPECT_EQ(count_flipped(tile.mesh.triangles, coarse), 0);
    }
}

TEST(CoarseStart, LeavesADevelopableTileIsometric) {
    const Tile tile = make_tile("cone", testing::cone(0.5, 1, 1, 2, 30, 30));
    const Points2 start = flatten_boundary_first(tile).positions;
    // it may be rotated by about 1e-5, because the grain is sampled, and a linear rotation stretches by its square
    EXPECT_LT(worst_edge(tile, coarse_solution(tile, Fabric{}, start)), 1e-8);
}

TEST(CoarseStart, LeadsALargeTileToTheSameEndAsNone) {
    // 7,200 triangles: above the size from which seam-exact flattening uses it.
    const Tile tile = make_tile("square", testing::spherical_square(0.3, 60));
    const Flattening coarse_to_fine = flatten_seam_exact(tile, Fabric{});
    const Flattening fine = flatten_seam_exact(tile, Fabric{}, {.start = SeamStart::arap});
    ASSERT_EQ(coarse_to_fine.summary.termination, Termination::converged);
    EXPECT_LT((coarse_to_fine.positions - fine.positions).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LE(coarse_to_fine.summary.factorizations, 2);
}

}  // namespace coarse_start_test
}  // namespace ripstop
