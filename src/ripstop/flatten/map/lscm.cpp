#include "ripstop/flatten/map/lscm.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "ripstop/base/index.h"
#include "ripstop/flatten/tools/finish.h"
#include "ripstop/geometry/triangle.h"
#include "ripstop/numeric/symmetric_solver.h"

namespace ripstop {
namespace {

using Matrix26 = Eigen::Matrix<double, 2, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// The two boundary vertices that are farthest apart. A symmetric tile has several such pairs; then the one that
/// leans most to the left of the warp, so that the choice does not depend on rounding or numbering.
std::array<int, 2> pins(const Tile& tile) {
    const Vec3 warp = tile.grain.direction;
    const Vec3 weft = area_vector(tile.mesh).normalized().cross(warp);
    const auto count = static_cast<Eigen::Index>(tile.boundary.size());
    const Points3 points = tile.mesh.positions(tile.boundary, Eigen::all);
    std::array<Eigen::Index, 2> best = {0, 1};
    double longest = 0;
    double lean = 0;
    for (Eigen::Index i = 0; i < count; ++i)
        for (Eigen::Index j = i + 1; j < count; ++j) {
            const Vec3 span = (points.row(j) - points.row(i)).transpose();
            const double length = span.squaredNorm();
            if (length < longest * (1 - 1e-9)) continue;
            const double leans = span.dot(warp) * span.dot(weft);
            if (length > longest * (1 + 1e-9) || leans > lean + 1e-9 * length) {
                best = {i, j};
                longest = length;
                lean = leans;
            }
        }
    return {tile.boundary[at(best[0])], tile.boundary[at(best[1])]};
}

/// The conformal residual of a triangle: two linear functions of (ax, ay, bx, by, cx, cy) whose squares sum to A |∇v
/// - R ∇u|². With the flat corners z and their opposite edges w as complex numbers it is Σ w z / √A.
Matrix26 conformal_residual(const TriangleMesh& mesh, int triangle) {
    const Mat22 rest = lay_flat(mesh.corner(triangle, 0), mesh.corner(triangle, 1), mesh.corner(triangle, 2));
    const std::array<Vec2, 3> opposite = {rest.col(1) - rest.col(0), -rest.col(1), rest.col(0)};
    const double scale = 1 / std::sqrt(2 * rest.determinant());
    Matrix26 residual;
    for (int k = 0; k < 3; ++k) {
        const Vec2 w = scale * opposite[at(k)];
        residual.middleCols<2>(2 * k) << w.x(), -w.y(), w.y(), w.x();
    }
    return residual;
}

}  // namespace

Flattening flatten_lscm(const Tile& tile) {
    const TriangleMesh& mesh = tile.mesh;
    const std::array<int, 2> held = pins(tile);
    std::vector<int> unknown(static_cast<std::size_t>(mesh.vertex_count()));
    for (int v = 0, next = 0; v < mesh.vertex_count(); ++v) unknown[at(v)] = v == held[0] || v == held[1] ? -1 : next++;

    Flattening flat;
    flat.positions = Points2::Zero(mesh.vertex_count(), 2);
    flat.positions(held[1], 0) = (mesh.positions.row(held[1]) - mesh.positions.row(held[0])).norm();

    // column of each unknown; -1 if fixed
    std::vector<std::array<int, 6>> columns(static_cast<std::size_t>(mesh.triangle_count()));
    Couplings couplings;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        std::vector<int> members;
        for (int k = 0; k < 3; ++k)
            for (int axis = 0; axis < 2; ++axis) {
                const int u = unknown[at(mesh.triangles(t, k))];
                columns[at(t)][at(2 * k + axis)] = u < 0 ? -1 : 2 * u + axis;
                if (u >= 0) members.push_back(2 * u + axis);
            }
        couplings.add_element(members);
    }
    const int size = 2 * mesh.vertex_count() - 4;
    const SparsePattern pattern(size, couplings);
    Eigen::VectorXd values = Eigen::VectorXd::Zero(pattern.entry_count());
    Eigen::VectorXd right = Eigen::VectorXd::Zero(size);
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const Matrix26 residual = conformal_residual(mesh, t);
        const Eigen::Matrix<double, 6, 6> element = residual.transpose() * residual;
        const auto& column = columns[at(t)];
        Vector6 fixed = Vector6::Zero();
        for (int i = 0; i < 6; ++i)
            if (column[at(i)] < 0) fixed[i] = flat.positions(mesh.triangles(t, i / 2), i % 2);
        const Vector6 force = element * fixed;
        std::size_t entry = 0;
        const auto slots = pattern.slots(t);
        for (int i = 0; i < 6; ++i) {
            if (column[at(i)] < 0) continue;
            right[column[at(i)]] -= force[i];
            for (int j = 0; j <= i; ++j)
                if (column[at(j)] >= 0) values[slots[entry++]] += element(i, j);
        }
    }

    SymmetricSolver solver(pattern);
    const bool solved = solver.factorize(values);
    flat.summary.iterations = 1;
    flat.summary.factorizations = solver.factorizations();
    if (!solved) {
        flat.summary.reason = "the conformal system is singular";
        return flat;
    }
    Eigen::VectorXd x = solver.solve(right);
    x += solver.solve(right - product(pattern, values, x));  // one step of iterative refinement: lengths need the last
                                                             // digits, and it is cheap
    for (int v = 0; v < mesh.vertex_count(); ++v)
        if (const int u = unknown[at(v)]; u >= 0) flat.positions.row(v) = x.segment<2>(2 * u);
    scale_to_area(mesh, flat.positions);
    finish(tile, flat, Termination::converged, "one linear system solved");
    return flat;
}

}  // namespace ripstop
