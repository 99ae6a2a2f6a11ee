#include "ripstop/measure/judge_zigzags.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ripstop/flatten/method.h"
#include "ripstop/tile/find_zigzags.h"
#include "ripstop/tile/make_tile.h"
#include "support/zigzags.h"

namespace ripstop {
namespace judge_zigzags_test {

using namespace testing;
using ::testing::HasSubstr;

struct Judged {
    std::vector<ZigzagWalk> walks;
    Verdict verdict;
};

Judged judged(const TriangleMesh& mesh) {
    const Tile tile = make_tile("tile", mesh, {.warp = Vec3(0.6, 0.8, 0)});
    const Points2 flat = method_named("seam-exact").flatten(tile, Fabric{}).positions;
    Judged result{walk_zigzags(tile, flat, find_zigzags(std::vector<Tile>{tile}, {})), {}};
    judge_zigzags(tile, result.walks, Tolerances{}, result.verdict);
    return result;
}

// A circle on a sphere that encloses the curvature K contains K / (4 pi) more area than a flat circle of the same
// length. Teeth that fold keep the area, so the curve becomes longer by half of that. The fold is damped where
// teeth are coarse, by up to a sixth at seven edges to the middle.
TEST(JudgeZigzags, FindsTheCurveOfADiscTooLongByHalfOfWhatASmoothCutLosesOfItsArea) {
    for (const double curvature : {0.05, 0.1, 0.2, 0.3})
        for (const double jumble : {0.0, 0.25}) {
            const Judged found = judged(zigzag_disc(curvature, 8, jumble, 7));
            ASSERT_EQ(found.walks.size(), 1u) << curvature << " " << jumble;
            const double half = curvature / (8 * std::numbers::pi);
            EXPECT_GT(found.walks[0].error(), 0.8 * half) << curvature << " " << jumble;
            EXPECT_LT(found.walks[0].error(), 1.02 * half) << curvature << " " << jumble;
            EXPECT_NEAR(found.walks[0].flat_area, found.walks[0].area, 0.004 * found.walks[0].area);
            ASSERT_EQ(found.verdict.findings.size(), 1u);
            EXPECT_EQ(found.verdict.findings[0].code, "zigzag");
            EXPECT_THAT(found.verdict.findings[0].message, HasSubstr("--fair-seams"));
            EXPECT_NEAR(found.verdict.findings[0].value, 100 * found.walks[0].error(), 1e-9);
        }
}

TEST(JudgeZigzags, FindsNothingWhereTheSurfaceCanBeUnrolled) {
    const auto disc = [](const Vec2& point) { return point.norm() < 1 ? 0 : -1; };
    for (const double radius : {0.4, 1.0, 3.0}) {  // down to four edges
        const Judged found =
            judged(cut_along_mesh({0.1, 1, 0.2, 9}, disc, [&](const Vec2& p) {
                       return Vec3(radius * std::cos(p.x() / radius), p.y(), radius * std::sin(p.x() / radius));
                   }).front());
        ASSERT_EQ(found.walks.size(), 1u) << radius;
        EXPECT_LT(std::abs(found.walks[0].error()), 2e-4) << radius;  // the bending of the mesh of random triangles
        EXPECT_TRUE(found.verdict.findings.empty());
    }
    const Judged flat =
        judged(cut_along_mesh({0.1, 1, 0.2, 9}, disc, [](const Vec2& p) { return Vec3(p.x(), p.y(), 0); }).front());
    ASSERT_EQ(flat.walks.size(), 1u);
    EXPECT_LT(std::abs(flat.walks[0].error()), 1e-9);
}

}  // namespace judge_zigzags_test
}  // namespace ripstop
