#include "ripstop/flatten/map/arap.h"

#include <Eigen/LU>
#include <array>
#include <cmath>

#include "ripstop/base/error.h"
#include "ripstop/base/index.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/flatten/map/lscm.h"
#include "ripstop/flatten/tools/finish.h"
#include "ripstop/geometry/triangle.h"
#include "ripstop/numeric/symmetric_solver.h"

namespace ripstop {
namespace {

/// A triangle laid flat: its area and the gradients N of its barycentric coordinates (columns). J = Σ_k u_k N_kᵀ, and
/// A Nᵀ N is its cotangent matrix.
struct Rest {
    double area;
    Eigen::Matrix<double, 2, 3> N;
};

Rest rest_state(const TriangleMesh& mesh, int t) {
    const Mat22 edges = lay_flat(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
    return {0.5 * edges.determinant(), corner_gradients(edges)};
}

/// The rotation closest to J, as (cos, sin).
Vec2 nearest_rotation(const Mat22& J) {
    const Vec2 turn(J(0, 0) + J(1, 1), J(1, 0) - J(0, 1));
    const double length = turn.norm();
    return length > 0 ? Vec2(turn / length) : Vec2(1, 0);
}

/// The global step. Vertex 0 is fixed during the solve, which only removes the translation.
class ForceBalance {
  public:
    explicit ForceBalance(const TriangleMesh& mesh) : mesh_(mesh), pattern_(pattern(mesh)), solver_(pattern_) {
        Eigen::VectorXd values = Eigen::VectorXd::Zero(pattern_.entry_count());
        for (int t = 0; t < mesh.triangle_count(); ++t) {
            const Rest& rest = rest_.emplace_back(rest_state(mesh, t));
            const Eigen::Matrix3d element = rest.area * rest.N.transpose() * rest.N;
            std::size_t entry = 0;
            const auto slots = pattern_.slots(t);
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j <= i; ++j)
                    if (mesh.triangles(t, i) > 0 && mesh.triangles(t, j) > 0) values[slots[entry++]] += element(i, j);
        }
        usable_ = solver_.factorize(values);
    }

    bool usable() const { return usable_; }

    /// One local and one global step from `u`; the result is centred at the origin.
    Points2 step(const Points2& u) const {
        Eigen::MatrixXd right = Eigen::MatrixXd::Zero(mesh_.vertex_count(), 2);
        for (int t = 0; t < mesh_.triangle_count(); ++t) {
            const auto& [area, N] = rest_[at(t)];
            Mat22 J = Mat22::Zero();
            for (int k = 0; k < 3; ++k) J += u.row(mesh_.triangles(t, k)).transpose() * N.col(k).transpose();
            const Vec2 turn = area * nearest_rotation(J);
            for (int k = 0; k < 3; ++k) {
                right(mesh_.triangles(t, k), 0) += turn[0] * N(0, k) - turn[1] * N(1, k);
                right(mesh_.triangles(t, k), 1) += turn[1] * N(0, k) + turn[0] * N(1, k);
            }
        }
        Points2 result = Points2::Zero(u.rows(), 2);
        result.bottomRows(u.rows() - 1) = solver_.solve_columns(right.bottomRows(u.rows() - 1));
        return result.rowwise() - result.colwise().mean();
    }

  private:
    static SparsePattern pattern(const TriangleMesh& mesh) {
        Couplings couplings;
        std::vector<int> members;
        for (int t = 0; t < mesh.triangle_count(); ++t) {
            members.clear();
            for (int k = 0; k < 3; ++k)
                if (mesh.triangles(t, k) > 0) members.push_back(mesh.triangles(t, k) - 1);
            couplings.add_element(members);
        }
        return SparsePattern(mesh.vertex_count() - 1, couplings);
    }

    const TriangleMesh& mesh_;
    SparsePattern pattern_;
    SymmetricSolver solver_;
    std::vector<Rest> rest_;
    bool usable_ = false;
};

}  // namespace

Flattening flatten_arap(const Tile& tile, const Points2& start, const ArapOptions& options) {
    if (options.max_iterations < 0 || !(options.tolerance > 0))
        throw InputError("as-rigid-as-possible flattening: max_iterations is " +
                         std::to_string(options.max_iterations) + " and tolerance " +
                         format_shortest(options.tolerance) + ", expected at least 0 and a positive number");
    if (start.rows() != tile.mesh.vertex_count())
        throw InputError("tile " + tile.name + ": the start has " + std::to_string(start.rows()) +
                         " vertices, expected the tile's " + std::to_string(tile.mesh.vertex_count()));
    Flattening flat;
    const ForceBalance balance(tile.mesh);
    flat.positions = start.rowwise() - start.colwise().mean();
    flat.summary.factorizations = 1;
    if (!balance.usable()) {
        flat.summary.reason = "the cotangent system is singular";
        return flat;
    }
    const double size = std::sqrt(surface_area(tile.mesh));
    double moved = size;
    while (flat.summary.iterations < options.max_iterations && moved > options.tolerance * size) {
        const Points2 next = balance.step(flat.positions);
        moved = (next - flat.positions).rowwise().norm().maxCoeff();
        flat.positions = next;
        ++flat.summary.iterations;
    }
    if (moved <= options.tolerance * size)
        finish(tile, flat, Termination::converged, "no vertex moves any more");
    else
        finish(tile, flat, Termination::iteration_limit, "vertices still move");
    return flat;
}

Flattening flatten_arap(const Tile& tile, const ArapOptions& options) {
    const Flattening start = flatten_lscm(tile);
    if (!start.summary.usable()) return start;
    Flattening flat = flatten_arap(tile, start.positions, options);
    flat.summary.factorizations += start.summary.factorizations;
    return flat;
}

}  // namespace ripstop
