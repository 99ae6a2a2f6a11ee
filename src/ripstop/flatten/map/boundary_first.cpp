#include "ripstop/flatten/map/boundary_first.h"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "ripstop/base/index.h"
#include "ripstop/flatten/tools/finish.h"
#include "ripstop/geometry/triangle.h"
#include "ripstop/mesh/boundary.h"
#include "ripstop/numeric/symmetric_solver.h"
#include "ripstop/tile/targets.h"

namespace ripstop {
namespace {

/// The cotangent matrix of a tile, partitioned into interior and boundary.
class CotangentSystem {
  public:
    explicit CotangentSystem(const Tile& tile)
        : mesh_(tile.mesh), unknown_(number_inside(tile)), pattern_(inside_, couplings()), solver_(pattern_) {
        Eigen::VectorXd values = Eigen::VectorXd::Zero(pattern_.entry_count());
        for (int t = 0; t < mesh_.triangle_count(); ++t) {
            elements_.push_back(cotangent_matrix(lay_flat(mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2))));
            std::size_t entry = 0;
            const auto slots = pattern_.slots(t);
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j <= i; ++j)
                    if (unknown(t, i) >= 0 && unknown(t, j) >= 0) values[slots[entry++]] += elements_.back()(i, j);
        }
        usable_ = inside_ == 0 || solver_.factorize(values);
    }

    bool usable() const { return usable_; }

    /// The product A x, for each column of x (one value per vertex).
    Eigen::MatrixXd product(const Eigen::MatrixXd& x) const {
        Eigen::MatrixXd result = Eigen::MatrixXd::Zero(x.rows(), x.cols());
        for (int t = 0; t < mesh_.triangle_count(); ++t)
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j)
                    result.row(mesh_.triangles(t, i)) += elements_[at(t)](i, j) * x.row(mesh_.triangles(t, j));
        return result;
    }

    /// Solves A x = right for the interior vertices; boundary values stay as they are.
    void solve_inside(const Eigen::MatrixXd& right, Eigen::MatrixXd& x) const {
        if (inside_ == 0) return;
        for (Eigen::Index v = 0; v < x.rows(); ++v)
            if (unknown_[at(v)] >= 0) x.row(v).setZero();
        const Eigen::MatrixXd known = product(x);
        Eigen::MatrixXd missing(inside_, x.cols());
        for (Eigen::Index v = 0; v < x.rows(); ++v)
            if (const int u = unknown_[at(v)]; u >= 0) missing.row(u) = right.row(v) - known.row(v);
        const Eigen::MatrixXd found = solver_.solve_columns(missing);
        for (Eigen::Index v = 0; v < x.rows(); ++v)
            if (const int u = unknown_[at(v)]; u >= 0) x.row(v) = found.row(u);
    }

  private:
    int unknown(int t, int corner) const { return unknown_[at(mesh_.triangles(t, corner))]; }

    std::vector<int> number_inside(const Tile& tile) {
        std::vector<int> unknown(static_cast<std::size_t>(tile.mesh.vertex_count()), 0);
        for (const int v : tile.boundary) unknown[at(v)] = -1;
        for (int& u : unknown)
            if (u == 0) u = inside_++;
        return unknown;
    }

    Couplings couplings() const {
        Couplings couplings;
        std::vector<int> members;
        for (int t = 0; t < mesh_.triangle_count(); ++t) {
            members.clear();
            for (int k = 0; k < 3; ++k)
                if (unknown(t, k) >= 0) members.push_back(unknown(t, k));
            couplings.add_element(members);
        }
        return couplings;
    }

    const TriangleMesh& mesh_;
    int inside_ = 0;
    std::vector<int> unknown_;  ///< -1 on the boundary
    SparsePattern pattern_;
    SymmetricSolver solver_;
    std::vector<Eigen::Matrix3d> elements_;
    bool usable_ = false;
};

/// The angle defect of each interior vertex, 2 pi minus the sum of its angles; zero on the boundary.
Eigen::VectorXd angle_defects(const Tile& tile) {
    const TriangleMesh& mesh = tile.mesh;
    Eigen::VectorXd defect = Eigen::VectorXd::Constant(mesh.vertex_count(), 2 * std::numbers::pi);
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k)
            defect[mesh.triangles(t, k)] -=
                angle_at(mesh.corner(t, k), mesh.corner(t, (k + 1) % 3), mesh.corner(t, (k + 2) % 3));
    for (const int v : tile.boundary) defect[v] = 0;
    return defect;
}

/// A closed line with these turning angles and edge lengths as close as possible to `lengths`: it minimizes the sum
/// of (l' - l)^2 / l.
Points2 closed_line(const Eigen::VectorXd& lengths, const Eigen::VectorXd& turning) {
    const Eigen::Index count = lengths.size();
    Eigen::Matrix2Xd direction(2, count);
    double angle = 0;
    for (Eigen::Index i = 0; i < count; ++i) {
        if (i > 0) angle += turning[i];
        direction.col(i) << std::cos(angle), std::sin(angle);
    }
    const Mat22 spread = direction * lengths.asDiagonal() * direction.transpose();
    const Vec2 gap = direction * lengths;
    const Eigen::VectorXd mended =
        lengths - lengths.asDiagonal() * (direction.transpose() * spread.ldlt().solve(gap)).eval();
    Points2 line = Points2::Zero(count, 2);
    for (Eigen::Index i = 0; i + 1 < count; ++i)
        line.row(i + 1) = line.row(i) + mended[i] * direction.col(i).transpose();
    return line;
}

}  // namespace

Flattening flatten_boundary_first(const Tile& tile) {
    Flattening flat;
    flat.positions = Points2::Zero(tile.mesh.vertex_count(), 2);
    flat.summary.factorizations = 1;
    flat.summary.iterations = 1;
    const CotangentSystem system(tile);
    if (!system.usable()) {
        flat.summary.reason = "the cotangent system is singular";
        return flat;
    }
    Eigen::MatrixXd scale = Eigen::MatrixXd::Zero(tile.mesh.vertex_count(), 1);
    system.solve_inside(-angle_defects(tile), scale);
    const Eigen::MatrixXd flow = system.product(scale);
    Eigen::VectorXd turning = surface_turning(tile.mesh, tile.boundary);
    for (Eigen::Index i = 0; i < turning.size(); ++i) turning[i] += flow(tile.boundary[at(i)], 0);

    const Points2 line = closed_line(target_lengths(tile), turning);
    Eigen::MatrixXd positions = Eigen::MatrixXd::Zero(tile.mesh.vertex_count(), 2);
    positions(tile.boundary, Eigen::all) = line;
    system.solve_inside(Eigen::MatrixXd::Zero(positions.rows(), 2), positions);
    flat.positions = positions;
    finish(tile, flat, Termination::converged, "two linear systems solved");
    return flat;
}

}  // namespace ripstop
