#include "ripstop/tile/cloth_warp.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "ripstop/base/index.h"
#include "ripstop/geometry/triangle.h"
#include "ripstop/mesh/unroll.h"

namespace ripstop {
namespace {

constexpr double agreement = 0.3;  ///< 1: all parallel; below this, no direction represents the whole
constexpr double longer = 0.05;    ///< relative to the sum of the moments: below this, neither axis is the longer one
constexpr double rounding_of_unit = 1e-6;  ///< relative to a unit vector: a smaller part along the triangle is rounding

/// The axes of `lay_flat` in space as columns: along corner 0 to 1, and across.
Mat32 axes_of(const TriangleMesh& mesh, int t) {
    const Vec3 a = mesh.corner(t, 0);
    const Vec3 e1 = (mesh.corner(t, 1) - a).normalized();
    const Vec3 normal = e1.cross(mesh.corner(t, 2) - a).normalized();
    Mat32 axes;
    axes << e1, normal.cross(e1);
    return axes;
}

struct Axis {
    Vec2 direction = Vec2::UnitX();
    double clarity = 0;  ///< (largest - smallest) / sum of the eigenvalues: 0 is isotropic, 1 a line
};

Axis axis_of(const Mat22& moment) {
    const Eigen::SelfAdjointEigenSolver<Mat22> solver(moment);
    const double sum = solver.eigenvalues().sum();
    if (!(sum > 0)) return {};
    return {solver.eigenvectors().col(1), (solver.eigenvalues()[1] - solver.eigenvalues()[0]) / sum};
}

/// The corners of a triangle on the unrolled tile, as columns.
Eigen::Matrix<double, 2, 3> laid_corners(const TriangleMesh& mesh, const std::vector<LaidTriangle>& laid, int t) {
    const LaidTriangle& here = laid[at(t)];
    Eigen::Matrix<double, 2, 3> corners;
    corners << Vec2::Zero(), lay_flat(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
    return (here.turn * corners).colwise() + here.origin;
}

/// The area centroid of the unrolled tile and its principal axis of largest second moment.
struct Whole {
    Vec2 centre;
    Axis axis;
};

Whole whole_of(const TriangleMesh& mesh, const std::vector<LaidTriangle>& laid) {
    double area = 0;
    Vec2 sum = Vec2::Zero();
    Mat22 moment = Mat22::Zero();
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const Eigen::Matrix<double, 2, 3> corners = laid_corners(mesh, laid, t);
        const double own = triangle_area(mesh, t);
        const Vec2 corner_sum = corners.rowwise().sum();
        moment += own / 12 * (corners * corners.transpose() + corner_sum * corner_sum.transpose());
        sum += own / 3 * corner_sum;
        area += own;
    }
    return {sum / area, axis_of(moment - sum * sum.transpose() / area)};
}

std::vector<LaidTriangle> unrolled(const TriangleMesh& mesh) {
    return unroll(mesh, Adjacency(mesh.triangles, mesh.vertex_count()));
}

}  // namespace

ClothWarp lay_on_cloth(const TriangleMesh& mesh, const Points3& directions) {
    const int count = mesh.triangle_count();
    ClothWarp warp{Eigen::Matrix2Xd::Zero(2, count)};
    const std::vector<LaidTriangle> laid = unrolled(mesh);
    double area = 0;
    Vec2 mean = Vec2::Zero(), sense = Vec2::Zero();
    Mat22 spread = Mat22::Zero();
    for (int t = 0; t < count; ++t) {
        const Vec3 direction = directions.row(directions.rows() > 1 ? t : 0);
        const Mat32 axes = axes_of(mesh, t);
        const Vec2 part(direction.dot(axes.col(0)), direction.dot(axes.col(1)));
        const double own = triangle_area(mesh, t), length = part.norm();
        area += own;
        if (!(length > rounding_of_unit)) continue;
        warp.along.col(t) = part / length;
        const Vec2 turned = laid[at(t)].turn * part;
        mean += own * turned / length;
        spread += own * turned * turned.transpose();
        if (sense.isZero()) sense = turned;
    }
    if (mean.norm() >= agreement * area) return warp;
    warp.laid_on_cloth = true;
    const Axis axis = axis_of(spread);
    Vec2 one = axis.clarity >= agreement ? axis.direction : whole_of(mesh, laid).axis.direction;
    if (one.dot(mean.norm() > rounding_of_unit * area ? mean : sense) < 0) one = -one;
    for (int t = 0; t < count; ++t) warp.along.col(t) = laid[at(t)].turn.transpose() * one;
    return warp;
}

std::optional<Vec3> longest_axis_on_cloth(const TriangleMesh& mesh) {
    const std::vector<LaidTriangle> laid = unrolled(mesh);
    const Whole whole = whole_of(mesh, laid);
    if (whole.axis.clarity < longer) return std::nullopt;
    int middle = 0;
    double least = std::numeric_limits<double>::infinity();
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const double away = (laid_corners(mesh, laid, t).rowwise().mean() - whole.centre).norm();
        if (away >= least * (1 - 1e-9)) continue;  // rounding must not decide between equal distances
        least = away;
        middle = t;
    }
    return axes_of(mesh, middle) * (laid[at(middle)].turn.transpose() * whole.axis.direction);
}

Points3 warp_in_space(const TriangleMesh& mesh, const Eigen::Matrix2Xd& warp, double angle) {
    const Eigen::Rotation2Dd turn(angle);
    Points3 directions(mesh.triangle_count(), 3);
    for (int t = 0; t < mesh.triangle_count(); ++t)
        directions.row(t) = (axes_of(mesh, t) * (turn * warp.col(t))).transpose();
    return directions;
}

}  // namespace ripstop
