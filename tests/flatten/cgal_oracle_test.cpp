/// Our conformal and as-rigid-as-possible maps compared with those of CGAL, an independent implementation.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "ripstop/flatten/map/arap.h"
#include "ripstop/flatten/map/lscm.h"
#include "ripstop/tile/make_tile.h"
#include "support/shapes.h"
#ifdef RIPSTOP_CGAL
#include "bench/cgal_parameterization.h"
#endif

namespace ripstop {
namespace cgal_oracle_test {

#ifdef RIPSTOP_CGAL

/// An asymmetric patch of the sphere, so that one pair of boundary vertices is farthest apart. Its triangles have
/// equal areas (longitude by height, sheared), because CGAL omits the weights 1 / sqrt(A) of Levy's equations.
Tile uneven_patch() {
    return make_tile("patch", testing::grid(48, 40, [](double u, double v) {
                         const double z = 0.8 * v - 0.3, longitude = u + 0.3 * v, r = std::sqrt(1 - z * z);
                         return Vec3(r * std::cos(longitude), r * std::sin(longitude), z);
                     }));
}

std::array<int, 2> farthest_pair(const Tile& tile) {
    std::array<int, 2> best{};
    double longest = 0;
    for (const int a : tile.boundary)
        for (const int b : tile.boundary) {
            const double length = (tile.mesh.positions.row(a) - tile.mesh.positions.row(b)).norm();
            if (length > longest) best = {a, b};
            longest = std::max(longest, length);
        }
    return best;
}

/// The largest distance between the points of two maps after the best rotation, shift and scale of the second,
/// over the size of the first.
double difference(const Points2& first, const Points2& second) {
    const auto complex = [](const Points2& points) {
        const Points2 centred = points.rowwise() - points.colwise().mean();
        Eigen::VectorXcd z(points.rows());
        for (Eigen::Index i = 0; i < z.size(); ++i) z[i] = {centred(i, 0), centred(i, 1)};
        return z;
    };
    const Eigen::VectorXcd z = complex(first), w = complex(second);
    const std::complex<double> fit = w.dot(z) / w.squaredNorm();
    return (z - fit * w).cwiseAbs().maxCoeff() / z.cwiseAbs().maxCoeff();
}

TEST(CgalOracle, LscmIsTheSameUpToTurnShiftAndScale) {
    const Tile tile = uneven_patch();
    CgalParameterization cgal(tile.mesh);
    ASSERT_TRUE(cgal.lscm(farthest_pair(tile)));
    EXPECT_LT(difference(flatten_lscm(tile).positions, cgal.positions()), 1e-5);  // the areas differ by 1e-4
}

TEST(CgalOracle, ArapIsTheSameAsFarAsCgalFollowsIt) {
    // CGAL stops at a relative energy change of 1e-6 or after 50 steps; ours stops when no vertex moves any more
    const Tile tile = uneven_patch();
    CgalParameterization cgal(tile.mesh);
    ASSERT_TRUE(cgal.arap());
    EXPECT_LT(difference(flatten_arap(tile).positions, cgal.positions()), 2e-3);
}

#else

TEST(CgalOracle, IsNotInThisBuild) {
    GTEST_SKIP() << "built without CGAL";
}

#endif

}  // namespace cgal_oracle_test
}  // namespace ripstop
