/// A tile that is not in its place, or not in its size, is named with how far or how much.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/checked_balloon.h"

namespace ripstop {
namespace faults_moved_test {

using ::testing::HasSubstr;
using namespace checked_balloon;

TEST(ShiftedTile, IsNamedWithHowFar) {
    for (std::vector<NamedMesh> balloon : both_balloons())
        for (const double distance : {0.003, 0.05, 0.4}) {
            const Vec3 by = distance * Vec3(0.6, -0.64, 0.48);
            std::vector<NamedMesh> shifted = balloon;
            move(shifted[middle].mesh, by);
            const EnvelopeCheck result = check(shifted);
            EXPECT_THAT(named(result), ::testing::ElementsAre("shifted " + balloon[middle].name)) << distance;
            if (result.issues.empty()) continue;
            // within the tolerance of a seam, because the neighbours determine its place
            EXPECT_NEAR(result.issues[0].value, distance, 0.0005) << result.issues[0].message;
            EXPECT_THAT(result.issues[0].message, HasSubstr("away from its place"));
        }
}

TEST(ShiftedTile, IsNamedHoweverFarItWentSideways) {
    for (const std::vector<NamedMesh>& balloon : both_balloons()) {
        const Vec3 place = middle_of(balloon[middle].mesh);
        const Vec3 sideways = Vec3(-place.y(), place.x(), 0).normalized();
        for (const double distance :
             {0.001, 0.002, 0.005, 0.01, 0.03, 0.1, 0.2, 0.3, 0.5, 0.8, 1.0, 1.3, 1.6, 2.0, 2.3, 2.6, 3.0}) {
            std::vector<NamedMesh> shifted = balloon;
            move(shifted[middle].mesh, distance * sideways);
            const EnvelopeCheck result = check(shifted);
            EXPECT_THAT(named(result), ::testing::ElementsAre("shifted " + balloon[middle].name)) << distance;
        }
    }
}

TEST(ShiftedTile, AtTheMouthIsNamedToo) {
    std::vector<NamedMesh> balloon = design_natural(small_balloon());
    move(balloon[6].mesh, Vec3(0.01, 0.01, 0.02));
    EXPECT_THAT(named(check(balloon)), ::testing::ElementsAre("shifted " + balloon[6].name));
}

TEST(ScaledTile, IsNamedWithTheRatio) {
    for (std::vector<NamedMesh> balloon : both_balloons())
        for (const double ratio : {1.01, 0.97, 1.25, 1000.0}) {
            for (const bool about_itself : {true, false}) {
                std::vector<NamedMesh> scaled = balloon;
                scale_about(scaled[middle].mesh, about_itself ? middle_of(scaled[middle].mesh) : Vec3::Zero(), ratio);
                const EnvelopeCheck result = check(scaled);
                EXPECT_THAT(named(result), ::testing::ElementsAre("scaled " + balloon[middle].name))
                    << ratio << about_itself;
                if (result.issues.empty()) continue;
                EXPECT_NEAR(result.issues.back().value, ratio, 1e-3 * ratio) << result.issues.back().message;
            }
        }
}

TEST(ScaledTile, IsNoExplanationWhereItShrinksToASpeckOnAnEdge) {
    // two pairs of neighbours, 8 m apart; the second pair has the same two edges
    const EnvelopeCheck result =
        check({strip("A", 0, 2, 0.3), strip("B", 2, 4, 0.5), strip("C", 10, 12, 0.5), strip("D", 10, 12, 0.1)});
    EXPECT_GT(result.seams, 0);
    for (const EnvelopeIssue& issue : result.issues) {
        EXPECT_NE(issue.code, "scaled") << issue.message;
        EXPECT_NE(issue.code, "shifted") << issue.message;
        EXPECT_THAT(issue.message, ::testing::Not(HasSubstr("no seams")));
        EXPECT_LT(issue.at.norm(), 13) << "in the envelope: " << issue.message;
    }
    EXPECT_THAT(meant(result), ::testing::ElementsAre("apart C"));
}

TEST(ScaledTile, IsNamedWhereItsUnitWasMistaken) {
    for (const double ratio : {1 / 25.4, 1 / 304.8, 0.001, 25.4, 304.8}) {
        std::vector<NamedMesh> balloon = design_natural(small_balloon());
        scale_about(balloon[middle].mesh, Vec3::Zero(), ratio);
        const EnvelopeCheck result = check(balloon);
        EXPECT_THAT(named(result), ::testing::ElementsAre("scaled " + balloon[middle].name)) << ratio;
        if (result.issues.empty()) continue;
        EXPECT_NEAR(result.issues[0].value, ratio, 1e-3 * ratio);
    }
}

}  // namespace faults_moved_test
}  // namespace ripstop
