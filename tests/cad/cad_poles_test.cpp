#include <gmock/gmock.h>
#include <gtest/gtest.h>

#ifdef RIPSTOP_CAD_PROGRAM

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include "cad/cad_files.h"
#include "ripstop/io/mesh/mesh_file.h"
#include "support/outside.h"

namespace ripstop {
namespace cad_poles_test {

using testing::area_of;
using ::testing::HasSubstr;
using testing::read_cad;
using testing::ScratchDirectory;

/// The known figures of a solid of `write_solid`, in metres.
struct Known {
    testing::Solid solid;
    double area;
    std::function<double(const Vec3&)> distance;  ///< of a point from the surface
};

double cone_distance(const Vec3& p) {
    const double r = std::hypot(p.x(), p.y()), slant = std::hypot(0.5, 0.9);
    return std::min(std::abs(p.z()), std::abs(0.9 * (r - 0.5) + 0.5 * p.z()) / slant);
}

double torus_distance(const Vec3& p) {
    return std::abs(std::hypot(std::hypot(p.x(), p.y()) - 0.5, p.z()) - 0.15);
}

std::vector<Known> solids() {
    const double pi = std::numbers::pi;
    return {{testing::Solid::cone, pi * 0.5 * (std::hypot(0.5, 0.9) + 0.5), cone_distance},
            {testing::Solid::sphere, 4 * pi * 0.25, [](const Vec3& p) { return std::abs(p.norm() - 0.5); }},
            {testing::Solid::torus, 4 * pi * pi * 0.5 * 0.15, torus_distance}};
}

CadModel solid_of(const ScratchDirectory& scratch, testing::Solid solid, const MeshingOptions& options = {}) {
    const std::string file = scratch.path("solid.step");
    testing::write_solid(file, solid);
    return in_metres(read_cad(file, options), 0.001);
}

int triangles(const CadModel& model) {
    int sum = 0;
    for (const NamedMesh& surface : model.surfaces) sum += surface.mesh.triangle_count();
    return sum;
}

int most_triangles_of_a_face(const CadModel& model) {
    int most = 0;
    for (const NamedMesh& surface : model.surfaces) most = std::max(most, surface.mesh.triangle_count());
    return most;
}

Vec3 corner_of(const TriangleMesh& mesh, Eigen::Index triangle, int k) {
    return mesh.positions.row(mesh.triangles(triangle, k % 3));
}

/// The union of all surfaces' triangles; vertices in the same place are merged.
struct Together {
    int open = 0;            ///< edges that are not traversed once in each direction
    int folded = 0;          ///< edges within a surface whose triangles' normals differ by more than 120 degrees
    double least_shape = 1;  ///< minimum of 4 sqrt(3) A / (a² + b² + c²), which is 1 for equilateral triangles
    double mean_shape = 0;
};

Together together(const CadModel& model) {
    using Place = std::array<double, 3>;
    Together result;
    struct Side {
        Vec3 normal;
        const NamedMesh* surface;
    };
    std::map<std::pair<Place, Place>, std::vector<Side>> runs;
    for (const NamedMesh& surface : model.surfaces)
        for (Eigen::Index t = 0; t < surface.mesh.triangles.rows(); ++t) {
            const auto corner = [&](int k) { return corner_of(surface.mesh, t, k); };
            const Vec3 a = corner(1) - corner(0), b = corner(2) - corner(1), c = corner(0) - corner(2);
            const Vec3 normal = a.cross(b);
            const double shape =
                2 * std::sqrt(3.0) * normal.norm() / (a.squaredNorm() + b.squaredNorm() + c.squaredNorm());
            result.least_shape = std::min(result.least_shape, shape);
            result.mean_shape += shape / triangles(model);
            const auto place = [&](int k) { return Place{corner(k).x(), corner(k).y(), corner(k).z()}; };
            for (int k = 0; k < 3; ++k) runs[{place(k), place(k + 1)}].push_back({normal.normalized(), &surface});
        }
    for (const auto& [ends, sides] : runs) {
        const auto back = runs.find({ends.second, ends.first});
        const bool once = sides.size() == 1 && back != runs.end() && back->second.size() == 1;
        result.open += once ? 0 : 1;
        if (!once || sides[0].surface != back->second[0].surface) continue;
        result.folded += sides[0].normal.dot(back->second[0].normal) < -0.5 ? 1 : 0;
    }
    return result;
}

TEST(CadPoles, AreMeshedClosedAndRoundWithinTheirBound) {
    const ScratchDirectory scratch;
    for (const Known& known : solids()) {
        SCOPED_TRACE(static_cast<int>(known.solid));
        const CadModel model = solid_of(scratch, known.solid);
        EXPECT_LE(most_triangles_of_a_face(model), 20000);
        const Together all = together(model);
        EXPECT_EQ(all.open, 0);
        EXPECT_EQ(all.folded, 0);
        EXPECT_GT(all.least_shape, 0.1);
        EXPECT_GT(all.mean_shape, 0.85);
        // Edges that turn by 2.8 degrees lose 0.04 % of the area; those of a bounded torus are 2.5 times as long
        // and lose 0.25 %.
        EXPECT_NEAR(area_of(model) / known.area, 1, 3e-3);
        EXPECT_LT(area_of(model), known.area);
    }
}

TEST(CadPoles, AreAsNearToTheirTrianglesAsAsked) {
    const ScratchDirectory scratch;
    for (const Known& known : solids()) {
        SCOPED_TRACE(static_cast<int>(known.solid));
        const double chord_error = 2e-3;
        const CadModel model = solid_of(scratch, known.solid, {.chord_error = chord_error});
        EXPECT_THAT(model.remarks, Each(::testing::Not(HasSubstr("no mesh can reach"))));
        EXPECT_EQ(together(model).open, 0);
        double greatest = 0;
        for (const NamedMesh& surface : model.surfaces)
            for (Eigen::Index t = 0; t < surface.mesh.triangles.rows(); ++t) {
                const auto corner = [&](int k) { return corner_of(surface.mesh, t, k); };
                greatest = std::max(greatest, known.distance((corner(0) + corner(1) + corner(2)) / 3));
                for (int k = 0; k < 3; ++k)
                    greatest = std::max(greatest, known.distance((corner(k) + corner(k + 1)) / 2));
            }
        EXPECT_LE(greatest, chord_error * (1 + 1e-6));
        EXPECT_GT(greatest, chord_error / 6) << "far finer than asked";
    }
}

TEST(CadPoles, ANeedleIsBoundedAndItIsSaidHow) {
    const ScratchDirectory scratch;
    const CadModel model = solid_of(scratch, testing::Solid::needle);
    ASSERT_EQ(model.surfaces.size(), 1U);
    EXPECT_LE(triangles(model), 20000);
    EXPECT_THAT(model.remarks, ::testing::Contains(HasSubstr("ask for finer ones with --chord or --edge")));
    const double exact = std::numbers::pi * 0.06 * std::hypot(0.06, 3);
    EXPECT_NEAR(area_of(model) / exact, 1, 3e-3);
}

TEST(CadPoles, ManyFacesAreBoundedTogether) {
    const ScratchDirectory scratch;
    const CadModel model = solid_of(scratch, testing::Solid::tori);
    ASSERT_EQ(model.surfaces.size(), 12U);
    EXPECT_LE(triangles(model), 200000);
    EXPECT_GT(triangles(model), 100000);
    EXPECT_EQ(together(model).open, 0);
    EXPECT_THAT(model.remarks, ::testing::Contains(HasSubstr("12 faces have triangles up to")));
}

TEST(CadPoles, ATubeThinnerThanItsEdgesStaysRound) {
    const ScratchDirectory scratch;
    for (const double edge : {0.02, 0.2, 2.0}) {
        SCOPED_TRACE(edge);
        const CadModel model = solid_of(scratch, testing::Solid::wire, {.edge_length = edge});
        EXPECT_EQ(together(model).open, 0);
        // At least six edges around: 3 sin(60 degrees) / pi of the area.
        EXPECT_GT(area_of(model) / (2 * std::numbers::pi * 0.002 * 3.002), 0.82);
    }
}

}  // namespace cad_poles_test
}  // namespace ripstop

#endif
