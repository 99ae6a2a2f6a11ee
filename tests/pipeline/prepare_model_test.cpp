#include "ripstop/pipeline/read/prepare_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/shapes.h"

namespace ripstop {
namespace prepare_model_test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// A square of two triangles and one triangle without area, each with a warp. `apart` separates its two coinciding
/// corners in the drawn positions.
CadModel square_with_a_pole(double apart) {
    NamedMesh square{"S", {}};
    square.mesh.positions.resize(5, 3);
    square.mesh.positions << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 1, 0;
    square.mesh.triangles.resize(3, 3);
    square.mesh.triangles << 0, 1, 2, 3, 2, 4, 0, 2, 3;
    square.drawn = square.mesh.positions.leftCols(2);
    square.drawn->row(4).array() += apart;
    square.warp.resize(3, 3);
    square.warp << 1, 0, 0, 0, 1, 0, 1, 1, 0;
    CadModel model;
    model.surfaces = {square};
    return model;
}

TEST(MendSurfaces, TakesWarpsAndDrawnPositionsAlong) {
    CadModel model = square_with_a_pole(0);
    EXPECT_THAT(mend_surfaces(model, 0.0005),
                ElementsAre("1 vertex merged with another in the same place: in S, near (0.0000, 1.0000, 0.0000)",
                            "1 triangle without area removed: in S, near (0.0000, 1.0000, 0.0000)"));
    const NamedMesh& mended = model.surfaces[0];
    EXPECT_EQ(mended.mesh.vertex_count(), 4);
    ASSERT_TRUE(mended.drawn);
    EXPECT_EQ(*mended.drawn, mended.mesh.positions.leftCols(2));
    ASSERT_EQ(mended.warp.rows(), 2);
    EXPECT_EQ(mended.warp.row(1), Eigen::RowVector3d(1, 1, 0)) << "that of the triangle it is of";
    EXPECT_THAT(mend_surfaces(model, 0.0005), IsEmpty());
}

TEST(MendSurfaces, DropsDrawnPositionsThatDoNotAgree) {
    CadModel model = square_with_a_pole(0.1);
    mend_surfaces(model, 0.0005);
    EXPECT_FALSE(model.surfaces[0].drawn);
}

TEST(MendSurfaces, KeepsATipThatIsDrawnApart) {
    // a gore of two triangles, the second with a copy of the tip
    const auto gore = [](double apart) {
        NamedMesh fan{"G", {}};
        fan.mesh.positions.resize(5, 3);
        fan.mesh.positions << -1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 8, 0, 0, 8, 0;
        fan.mesh.triangles.resize(2, 3);
        fan.mesh.triangles << 0, 1, 3, 1, 2, 4;
        fan.drawn = fan.mesh.positions.leftCols(2);
        fan.drawn->row(4).array() += apart;
        CadModel model;
        model.surfaces = {fan};
        return model;
    };
    // two triangles joined at one point only are no tile; with their common edge they are one
    CadModel halves = gore(0);
    EXPECT_THAT(mend_surfaces(halves, 0.0005),
                ElementsAre("1 vertex merged with another in the same place: in G, near (0.0000, 8.0000, 0.0000)"));
    // with more cloth below, the copies are a tip
    const auto with_body = [&](double apart) {
        CadModel model = gore(apart);
        NamedMesh& fan = model.surfaces[0];
        fan.mesh.positions.conservativeResize(6, 3);
        fan.mesh.positions.row(5) << 0, -3, 0;
        fan.mesh.triangles.conservativeResize(4, 3);
        fan.mesh.triangles.row(2) << 5, 1, 0;
        fan.mesh.triangles.row(3) << 5, 2, 1;
        fan.drawn->conservativeResize(6, 2);
        fan.drawn->row(5) << 0, -3;
        return model;
    };
    CadModel tip = with_body(0);
    EXPECT_THAT(mend_surfaces(tip, 0.0005),
                ElementsAre("1 vertex of tips, separate for each triangle, welded: in G, near (0.0000, 8.0000, "
                            "0.0000)"));
    CadModel drawn_apart = with_body(0.1);
    EXPECT_THAT(mend_surfaces(drawn_apart, 0.0005), IsEmpty());
    EXPECT_EQ(drawn_apart.surfaces[0].mesh.vertex_count(), 6);
}

TEST(FarOrigin, IsOfTheAxesOnWhichTheModelLiesFarOff) {
    CadModel model;
    model.surfaces = {{"s", testing::rectangle(2, 1, 2, 2), {}}};
    EXPECT_TRUE(far_origin(model).isZero());
    model.surfaces[0].mesh.positions.rowwise() += Eigen::RowVector3d(500000.25, 1500, 0);
    EXPECT_EQ(far_origin(model), Vec3(500001, 0, 0));
    model.surfaces[0].mesh.positions.rowwise() += Eigen::RowVector3d(0, 5e6, -2500);
    EXPECT_EQ(far_origin(model), Vec3(500001, 5001501, -2500)) << "half a metre is rounded up";
}

TEST(FarOrigin, LosesNoDigitOfWhatTheFileHas) {
    CadModel model;
    model.surfaces = {{"s", testing::rectangle(2, 1, 3, 3), {}}};
    const Points3 near = model.surfaces[0].mesh.positions;
    model.surfaces[0].mesh.positions.rowwise() += Eigen::RowVector3d(500000, 5000000, 0);
    const Points3 far = model.surfaces[0].mesh.positions;
    const Vec3 origin = far_origin(model);
    count_from(origin, model);
    EXPECT_EQ(Points3(model.surfaces[0].mesh.positions.rowwise() + origin.transpose()), far) << "exactly";
    EXPECT_LT(
        (model.surfaces[0].mesh.positions - near + (Vec3(-500000, -5000000, 0) + origin).transpose().replicate(16, 1))
            .cwiseAbs()
            .maxCoeff(),
        1e-9);
}

TEST(Rounding, OfSinglePrecisionIsHalfAUnitInTheLastPlace) {
    EXPECT_EQ(single_rounding(0), 0);
    for (const double largest : {1.0, 1.5, 20.0, 500000.0, 5e6}) {
        const float up = std::nextafter(static_cast<float>(largest), 1e30F);
        EXPECT_EQ(single_rounding(largest), (static_cast<double>(up) - largest) / 2) << largest;
    }
}

}  // namespace prepare_model_test
}  // namespace ripstop
