/// The two edges of a strip are neither a gap nor an overlap, whatever its length and width; slits, gaps and
/// overlaps still are.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ripstop/assembly/faults/check_envelope.h"
#include "support/envelopes.h"
#include "support/shapes.h"

namespace ripstop {
namespace strips_test {

using std::numbers::pi;
using testing::grid;
using ::testing::HasSubstr;

NamedMesh tile(const std::string& name, const TriangleMesh& mesh) {
    return {name, mesh, {}};
}

TriangleMesh shifted(TriangleMesh mesh, const Vec3& by) {
    mesh.positions.rowwise() += by.transpose();
    return mesh;
}

std::string faults_of(const std::vector<NamedMesh>& tiles, const SeamOptions& options = {}) {
    std::string text;
    for (const EnvelopeIssue& issue : check_envelope(testing::tiles_of(tiles), options).issues)
        text += issue.code + ": " + issue.message + "\n";
    return text;
}

int seams_of(const std::vector<NamedMesh>& tiles, const SeamOptions& options = {}) {
    return check_envelope(testing::tiles_of(tiles), options).seams;
}

/// A flat part of a ring, of at most one winding.
TriangleMesh ring(double radius, double width, double angle, int along, int across) {
    return grid(along, across, [&](double u, double v) {
        const double r = radius + width * (1 - v);
        return Vec3(r * std::cos(angle * u), r * std::sin(angle * u), 0);
    });
}

/// A flat spiral strip of `turns` windings, `pitch` apart.
TriangleMesh spiral(double turns, double pitch, double width, int along) {
    return grid(along, 1, [&](double u, double v) {
        const double angle = 2 * pi * turns * u, r = 0.5 + pitch * turns * u + width * (1 - v);
        return Vec3(r * std::cos(angle), r * std::sin(angle), 0);
    });
}

/// A strip around a cylinder; it climbs by `pitch` per turn.
TriangleMesh helix(double radius, double turns, double pitch, double width, int along) {
    return grid(along, 2, [&](double u, double v) {
        const double angle = 2 * pi * turns * u;
        return Vec3(radius * std::cos(angle), radius * std::sin(angle), pitch * turns * u + width * v);
    });
}

/// A straight strip with an arc as cross-section.
TriangleMesh channel(double length, double radius, double angle, int around) {
    return grid(7, around, [&](double u, double v) {
        return Vec3(length * u, radius * std::sin(angle * v), -radius * std::cos(angle * v));
    });
}

TEST(Strips, AreSoundHoweverNarrow) {
    for (const double length : {0.4, 2.0, 5.2})
        for (const double width : {0.003, 0.005, 0.02, 0.1, 0.25})
            for (const auto& [along, across] : {std::pair(1, 1), std::pair(9, 1), std::pair(200, 3)}) {
                const NamedMesh belt = tile("belt", testing::rectangle(length, width, along, across));
                EXPECT_EQ(faults_of({belt}), "") << length << " x " << width << ", " << along << " x " << across;
                EXPECT_EQ(seams_of({belt}), 0);
            }
}

TEST(Strips, AreSoundHoweverTheyLieAndAreMeshed) {
    const TriangleMesh belt = testing::rectangle(3, 0.04, 60, 2);
    EXPECT_EQ(faults_of({tile("moved", testing::moved(belt))}), "");
    EXPECT_EQ(faults_of({tile("shuffled", testing::shuffled(belt, 5))}), "");
    EXPECT_EQ(faults_of({tile("mirrored", testing::mirrored(belt))}), "");
    // one long edge has 40 segments, the other one
    TriangleMesh fan;
    fan.positions.resize(43, 3);
    for (int i = 0; i <= 40; ++i) fan.positions.row(i) << 0.05 * i, 0, 0;
    fan.positions.row(41) << 2, 0.05, 0;
    fan.positions.row(42) << 0, 0.05, 0;
    fan.triangles.resize(41, 3);
    for (int i = 0; i < 40; ++i) fan.triangles.row(i) << i, i + 1, i < 20 ? 42 : 41;
    fan.triangles.row(40) << 20, 41, 42;
    EXPECT_EQ(faults_of({tile("fan", fan)}), "");
}

TEST(Strips, AreSoundWhereTheyAreBent) {
    for (const double width : {0.005, 0.05, 0.2}) {
        for (const double angle : {1.0, 4.0, 6.1}) {
            EXPECT_EQ(faults_of({tile("ring", ring(2, width, angle, 90, 1))}), "") << width << ", " << angle;
            EXPECT_EQ(faults_of({tile("cone", testing::cone(0.6, angle, 2, 2 + width, 60, 2))}), "") << width;
            EXPECT_EQ(faults_of({tile("collar", testing::cylinder(0.8, angle, width, 60, 2))}), "") << width;
        }
        EXPECT_EQ(faults_of({tile("spiral", spiral(3, 3 * width + 0.1, width, 300))}), "") << width;
        EXPECT_EQ(faults_of({tile("helix", helix(1, 2.5, 2 * width + 0.1, width, 200))}), "") << width;
    }
    EXPECT_EQ(faults_of({tile(
                  "pennant",
                  grid(40, 1, [](double u, double v) { return Vec3(2 * u, 0.15 * (1 - 0.999 * u) * (v - 0.5), 0); }))}),
              "");
    for (const double angle : {pi / 4, pi / 2, 0.98 * pi})
        EXPECT_EQ(faults_of({tile("channel", channel(4, 0.03, angle, 12))}), "") << angle;
}

TEST(Strips, ClosedIntoARingHaveOneSeamAndNoFault) {
    for (const double height : {0.004, 0.05, 0.25}) {
        const NamedMesh collar = tile("collar", testing::cylinder(5.2 / (2 * pi), 2 * pi, height, 48, 1));
        EXPECT_EQ(faults_of({collar}), "") << height;
        EXPECT_EQ(seams_of({collar}), 1) << height;
    }
}

TEST(Strips, SewnAlongOrAcrossAreSound) {
    // two belts side by side, and one in four slanting parts: the free edges belong to different tiles
    const TriangleMesh half = testing::rectangle(2, 0.03, 20, 1);
    const std::vector<NamedMesh> along{tile("a", half), tile("b", shifted(half, {0, 0.03, 0}))};
    EXPECT_EQ(faults_of(along), "");
    EXPECT_EQ(seams_of(along), 1);
    std::vector<NamedMesh> across;
    for (int i = 0; i < 4; ++i)
        across.push_back(tile(std::string("p").append(std::to_string(i)), grid(6, 1, [&](double u, double v) {
                                  return Vec3(0.5 * i + 0.5 * u + 0.4 * v, 0.02 * v, 0);
                              })));
    EXPECT_EQ(faults_of(across), "");
    EXPECT_EQ(seams_of(across), 3);
}

TEST(Strips, BetweenTwoSheetsAreSewnToBoth) {
    const NamedMesh low = tile("low", testing::rectangle(2, 1, 8, 4));
    const NamedMesh band = tile("band", shifted(testing::rectangle(2, 0.02, 8, 1), {0, 1, 0}));
    const NamedMesh high = tile("high", shifted(testing::rectangle(2, 1, 8, 4), {0, 1.02, 0}));
    EXPECT_EQ(faults_of({low, band, high}), "");
    EXPECT_EQ(seams_of({low, band, high}), 2);
}

TEST(Strips, NarrowerThanTheSeamToleranceAreNotSewnToThemselves) {
    EXPECT_EQ(seams_of({tile("tape", testing::rectangle(2, 0.0015, 40, 1))}, {0.002}), 0);
    // the two edges of a gore of one degree are within half a millimetre for the last 28 mm
    const NamedMesh gore = tile(
        "gore", grid(40, 1, [](double u, double v) { return Vec3(2 * u, (1 - 0.9995 * u) * 0.035 * (v - 0.5), 0); }));
    EXPECT_EQ(seams_of({gore}), 0);
    EXPECT_EQ(faults_of({gore}), "");
}

TEST(Slit, InATubeIsStillAGapAndItsLapAnOverlap) {
    for (const double miss : {0.001, 0.003, 0.01}) {
        const double round = 2 * pi;
        EXPECT_THAT(faults_of({tile("tube", testing::cylinder(1, round - miss, 2, 64, 4))}),
                    HasSubstr("they are not sewn; close the gap"))
            << miss;
        EXPECT_THAT(faults_of({tile("tube", testing::cylinder(1, round + miss, 2, 64, 4))}),
                    HasSubstr("there the tiles overlap; trim the overlap"))
            << miss;
    }
    EXPECT_EQ(seams_of({tile("tube", testing::cylinder(1, 2 * pi - 0.0003, 2, 64, 4))}), 1);
}

TEST(Dart, IsSewnToItsTip) {
    // a rectangle with a slit from its lower edge to its middle; the sides of the slit coincide or are 0.3 mm
    // apart
    for (const double open : {0.0, 0.0003}) {
        TriangleMesh mesh = testing::rectangle(2, 1, 8, 8);
        const Eigen::Index count = mesh.positions.rows();
        mesh.positions.conservativeResize(count + 4, 3);
        for (int j = 0; j < 4; ++j) {
            const int v = 9 * j + 4;
            mesh.positions.row(count + j) = mesh.positions.row(v);
            mesh.positions(count + j, 0) += open * (4 - j) / 4;
            for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
                const bool right = mesh.positions(mesh.triangles(t, 0), 0) + mesh.positions(mesh.triangles(t, 1), 0) +
                                       mesh.positions(mesh.triangles(t, 2), 0) >
                                   3 * mesh.positions(v, 0) + 0.01;
                for (int k = 0; k < 3; ++k)
                    if (right && mesh.triangles(t, k) == v) mesh.triangles(t, k) = static_cast<int>(count) + j;
            }
        }
        EXPECT_EQ(seams_of({tile("dart", mesh)}), 1) << open;
        EXPECT_EQ(faults_of({tile("dart", mesh)}), "") << open;
    }
}

TEST(NarrowStrips, ThatOverlapOrLeaveAGapAreNamed) {
    const TriangleMesh strip = testing::rectangle(2, 0.03, 20, 1);
    for (const double miss : {0.0015, 0.004}) {
        const std::string apart = " apart at";
        const std::string distance = "but " + std::to_string(miss * 1000).substr(0, 3) + "0 mm" + apart;
        const std::string lap = faults_of({tile("a", strip), tile("b", shifted(strip, {0, 0.03 - miss, 0}))});
        EXPECT_THAT(lap, HasSubstr("there the tiles overlap; trim the overlap"));
        EXPECT_THAT(lap, HasSubstr(distance));
        const std::string gap = faults_of({tile("a", strip), tile("b", shifted(strip, {0, 0.03 + miss, 0}))});
        EXPECT_THAT(gap, HasSubstr("they are not sewn; close the gap, or"));
        EXPECT_THAT(gap, HasSubstr(distance)) << "not the far edges";
    }
}

}  // namespace strips_test
}  // namespace ripstop
