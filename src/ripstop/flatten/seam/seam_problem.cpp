#include "ripstop/flatten/seam/seam_problem.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "ripstop/energy/boundary_bending.h"
#include "ripstop/flatten/tools/step_filter.h"
#include "ripstop/geometry/triangle.h"
#include "ripstop/mesh/boundary.h"
#include "ripstop/tile/targets.h"

namespace ripstop {
namespace {

/// The largest bending stiffness that acts on a vertex of the cut line, in E. On edges of a thousandth of the tile,
/// bending would be some thousand times stiffer than the cloth, and on the edges of a blunt tip stiffer than the
/// length constraints. Folds of such short edges are not visible.
constexpr double stiffest_bend = 1e4;

std::array<int, 6> unknowns_of(int a, int b, int c) {
    return {2 * a, 2 * a + 1, 2 * b, 2 * b + 1, 2 * c, 2 * c + 1};
}

/// Adds a full symmetric block to the slots of an element.
template <class Block>
void add_block(const SparsePattern& pattern, int group, const Block& block, Eigen::VectorXd& values) {
    const auto slots = pattern.slots(group);
    std::size_t k = 0;
    for (int a = 0; a < block.rows(); ++a)
        for (int b = 0; b <= a; ++b) values[slots[k++]] += block(a, b);
}

/// The gradient of the warp's mean transverse component: the warp lies along +x if this row times u is zero.
Eigen::VectorXd make_grain_row(const Tile& tile) {
    const Eigen::Matrix2Xd warp = warp_in_triangles(tile);
    Eigen::VectorXd row = Eigen::VectorXd::Zero(2 * tile.mesh.vertex_count());
    const double total = surface_area(tile.mesh);
    for (int t = 0; t < tile.mesh.triangle_count(); ++t) {
        const Mat22 rest = lay_flat(tile.mesh.corner(t, 0), tile.mesh.corner(t, 1), tile.mesh.corner(t, 2));
        const Vec2 share = 0.5 * rest.determinant() / total * (rest.inverse() * warp.col(t));
        row[2 * tile.mesh.triangles(t, 1) + 1] += share.x();
        row[2 * tile.mesh.triangles(t, 2) + 1] += share.y();
        row[2 * tile.mesh.triangles(t, 0) + 1] -= share.x() + share.y();
    }
    return row;
}

}  // namespace

SeamProblem::SeamProblem(const Tile& tile, const Fabric& fabric, const Options& options)
    : vertex_count_(tile.mesh.vertex_count()),
      triangles_(tile.mesh.triangles),
      boundary_(tile.boundary),
      lengths_(target_lengths(tile)),
      grain_row_(make_grain_row(tile)),
      membrane_(fabric),
      stiffness_(0.5 * (fabric.c11() + fabric.c22())),
      keep_area_(options.keep_area) {
    for (const Mat22& target : target_triangles(tile)) {
        metrics_.push_back(triangle_metric(target));
        area_ += 0.5 * target.determinant();
    }
    size_ = std::sqrt(area_);
    if (options.bending > 0) {
        const double stiffness = options.bending * stiffness_ * area_ * size_;
        std::vector<bool> corner(static_cast<std::size_t>(vertex_count_), false);
        if (tile.chains.size() > 1)
            for (const Chain& chain : tile.chains) corner[static_cast<std::size_t>(chain.vertices.front())] = true;
        const Eigen::VectorXd reference = surface_turning(tile.mesh, boundary_);
        for (int i = 0; i < edge_count(); ++i) {
            if (corner[static_cast<std::size_t>(boundary_at(i))]) continue;
            const double before = lengths_[(i + edge_count() - 1) % edge_count()];
            bends_.push_back({i, reference[i], 0.5 * (before + lengths_[i]), limited(stiffness, i)});
        }
    }
    Couplings couplings;
    for (int t = 0; t < triangle_count(); ++t)
        couplings.add_element(unknowns_of(triangles_(t, 0), triangles_(t, 1), triangles_(t, 2)));
    first_bend_group_ = couplings.count();
    for (const Bend& bend : bends_)
        couplings.add_element(unknowns_of(boundary_at(bend.index + edge_count() - 1), boundary_at(bend.index),
                                          boundary_at(bend.index + 1)));
    first_edge_group_ = couplings.count();
    for (int i = 0; i < edge_count(); ++i) {
        const int a = boundary_at(i), b = boundary_at(i + 1);
        couplings.add_element(std::array<int, 4>{2 * a, 2 * a + 1, 2 * b, 2 * b + 1});
    }
    pattern_ = std::make_unique<SparsePattern>(unknowns(), couplings);
    const Vec3 centre = centroid(tile.mesh);
    (tile.mesh.positions.rowwise() - centre.transpose()).rowwise().squaredNorm().minCoeff(&held_vertex_);
}

void SeamProblem::set_bending(const Eigen::VectorXd& bending, const Eigen::VectorXd& reference) {
    for (Bend& bend : bends_) {
        bend.stiffness = limited(bending[bend.index] * stiffness_ * area_ * size_, bend.index);
        bend.reference = reference[bend.index];
    }
}

double SeamProblem::limited(double stiffness, int i) const {
    const double before = lengths_[(i + edge_count() - 1) % edge_count()], shortest = std::min(before, lengths_[i]);
    return std::min(stiffness, stiffest_bend * stiffness_ * 0.5 * (before + lengths_[i]) * shortest * shortest);
}

void SeamProblem::add_membrane(const Eigen::VectorXd& u, Curvature curvature, double& energy, Eigen::VectorXd& gradient,
                               Eigen::VectorXd* values) const {
    for (int t = 0; t < triangle_count(); ++t) {
        const auto corners = unknowns_of(triangles_(t, 0), triangles_(t, 1), triangles_(t, 2));
        Mat22 flat;
        flat.col(0) = at(u, triangles_(t, 1)) - at(u, triangles_(t, 0));
        flat.col(1) = at(u, triangles_(t, 2)) - at(u, triangles_(t, 0));
        const MembraneElement element = membrane_.element(metrics_[static_cast<std::size_t>(t)], flat, curvature);
        energy += element.energy;
        for (int k = 0; k < 6; ++k) gradient[corners[static_cast<std::size_t>(k)]] += element.gradient[k];
        if (values) add_block(*pattern_, t, element.hessian, *values);
    }
}

void SeamProblem::add_bending(const Eigen::VectorXd& u, Curvature curvature, double& energy, Eigen::VectorXd& gradient,
                              Eigen::VectorXd* values) const {
    for (std::size_t i = 0; i < bends_.size(); ++i) {
        const Bend& bend = bends_[i];
        const int p = boundary_at(bend.index + edge_count() - 1), v = boundary_at(bend.index);
        const int n = boundary_at(bend.index + 1);
        const auto corners = unknowns_of(p, v, n);
        const BendingElement element = boundary_bending(at(u, p), at(u, v), at(u, n), bend.reference, bend.stiffness,
                                                        bend.length, curvature == Curvature::semidefinite);
        energy += element.energy;
        for (int k = 0; k < 6; ++k) gradient[corners[static_cast<std::size_t>(k)]] += element.gradient[k];
        if (values) add_block(*pattern_, first_bend_group_ + static_cast<int>(i), element.hessian, *values);
    }
}

void SeamProblem::add_edges(const Eigen::VectorXd& u, const Eigen::VectorXd& lambda, double rho, Curvature curvature,
                            Eigen::VectorXd& values) const {
    for (int i = 0; i < edge_count(); ++i) {
        const Vec2 slope = (at(u, boundary_at(i + 1)) - at(u, boundary_at(i))) / lengths_[i];
        // a compressed edge adds negative curvature across itself; the semidefinite form drops it
        const double tension = curvature == Curvature::semidefinite ? std::max(0.0, lambda[i]) : lambda[i];
        const Mat22 block = rho * slope * slope.transpose() + tension / lengths_[i] * Mat22::Identity();
        Eigen::Matrix4d whole;
        whole << block, -block, -block, block;
        add_block(*pattern_, first_edge_group_ + i, whole, values);
    }
}

double SeamProblem::energy(const Eigen::VectorXd& u) const {
    double sum = 0;
    for (int t = 0; t < triangle_count(); ++t) {
        Mat22 flat;
        flat.col(0) = at(u, triangles_(t, 1)) - at(u, triangles_(t, 0));
        flat.col(1) = at(u, triangles_(t, 2)) - at(u, triangles_(t, 0));
        sum += membrane_.energy(metrics_[static_cast<std::size_t>(t)], flat);
        if (!(sum < std::numeric_limits<double>::infinity())) return std::numeric_limits<double>::infinity();
    }
    for (const Bend& bend : bends_) {
        const double excess = turning_at(u, bend.index) - bend.reference;
        sum += 0.5 * bend.stiffness / bend.length * excess * excess;
    }
    return sum;
}

double SeamProblem::assemble(const Eigen::VectorXd& u, const Eigen::VectorXd& lambda, const Eigen::VectorXd& mu,
                             double rho, Curvature curvature, Eigen::VectorXd& gradient,
                             Eigen::VectorXd& values) const {
    gradient.setZero(unknowns());
    values.setZero(pattern_->entry_count());
    double energy = 0;
    add_membrane(u, curvature, energy, gradient, &values);
    add_bending(u, curvature, energy, gradient, &values);
    add_edges(u, lambda, rho, curvature, values);
    if (keep_area_ && curvature == Curvature::exact) {
        // the Hessian of the shoelace area couples x of one end of an edge with y of the other
        const double weight = 0.5 * mu[1] / size_;
        for (int i = 0; i < edge_count(); ++i) {
            Eigen::Matrix4d whole = Eigen::Matrix4d::Zero();
            whole(0, 3) = whole(3, 0) = weight;
            whole(1, 2) = whole(2, 1) = -weight;
            add_block(*pattern_, first_edge_group_ + i, whole, values);
        }
    }
    return energy;
}

Eigen::VectorXd SeamProblem::gradient(const Eigen::VectorXd& u) const {
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(unknowns());
    double energy = 0;
    add_membrane(u, Curvature::exact, energy, gradient, nullptr);
    add_bending(u, Curvature::exact, energy, gradient, nullptr);
    return gradient;
}

double SeamProblem::turning_at(const Eigen::VectorXd& u, int i) const {
    return turning(at(u, boundary_at(i + edge_count() - 1)), at(u, boundary_at(i)), at(u, boundary_at(i + 1)));
}

Eigen::VectorXd SeamProblem::flat_turning(const Eigen::VectorXd& u) const {
    return Eigen::VectorXd::NullaryExpr(edge_count(),
                                        [&](Eigen::Index i) { return turning_at(u, static_cast<int>(i)); });
}

Eigen::VectorXd SeamProblem::flat_lengths(const Eigen::VectorXd& u) const {
    return Eigen::VectorXd::NullaryExpr(edge_count(), [&](Eigen::Index i) {
        return (at(u, boundary_at(static_cast<int>(i) + 1)) - at(u, boundary_at(static_cast<int>(i)))).norm();
    });
}

Eigen::VectorXd SeamProblem::edge_residual(const Eigen::VectorXd& u) const {
    const Eigen::ArrayXd flat = flat_lengths(u), wanted = lengths_;
    return (flat - wanted) * (flat + wanted) / (2 * wanted);
}

Eigen::VectorXd SeamProblem::dense_residual(const Eigen::VectorXd& u) const {
    Eigen::VectorXd residual(dense_count());
    residual[0] = grain_row_.dot(u);
    if (keep_area_) {
        double area = 0;
        const Vec2 origin = at(u, boundary_at(0));
        for (int i = 0; i < edge_count(); ++i)
            area += 0.5 * cross(at(u, boundary_at(i)) - origin, at(u, boundary_at(i + 1)) - origin);
        residual[1] = (area - area_) / size_;
    }
    return residual;
}

Eigen::MatrixXd SeamProblem::dense_rows(const Eigen::VectorXd& u) const {
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(unknowns(), dense_count());
    rows.col(0) = grain_row_;
    if (keep_area_)
        for (int i = 0; i < edge_count(); ++i) {
            const Vec2 across = at(u, boundary_at(i + 1)) - at(u, boundary_at(i + edge_count() - 1));
            rows(2 * boundary_at(i), 1) = 0.5 * across.y() / size_;
            rows(2 * boundary_at(i) + 1, 1) = -0.5 * across.x() / size_;
        }
    return rows;
}

Eigen::VectorXd SeamProblem::edge_product(const Eigen::VectorXd& u, const Eigen::VectorXd& d) const {
    Eigen::VectorXd result(edge_count());
    for (int i = 0; i < edge_count(); ++i) {
        const int a = boundary_at(i), b = boundary_at(i + 1);
        result[i] = (at(u, b) - at(u, a)).dot(at(d, b) - at(d, a)) / lengths_[i];
    }
    return result;
}

Eigen::VectorXd SeamProblem::edge_transposed(const Eigen::VectorXd& u, const Eigen::VectorXd& lambda) const {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(unknowns());
    for (int i = 0; i < edge_count(); ++i) {
        const int a = boundary_at(i), b = boundary_at(i + 1);
        const Vec2 force = lambda[i] / lengths_[i] * (at(u, b) - at(u, a));
        result.segment<2>(2 * b) += force;
        result.segment<2>(2 * a) -= force;
    }
    return result;
}

double SeamProblem::longest_step(const Eigen::VectorXd& u, const Eigen::VectorXd& d) const {
    return ripstop::longest_step(triangles_, u, d);
}

int SeamProblem::held_turn(const Eigen::VectorXd& u) const {
    int farthest = boundary_.front();
    for (const int v : boundary_)
        if ((at(u, v) - at(u, held_vertex_)).squaredNorm() > (at(u, farthest) - at(u, held_vertex_)).squaredNorm())
            farthest = v;
    const Vec2 arm = at(u, farthest) - at(u, held_vertex_);
    return 2 * farthest + (std::abs(arm.x()) > std::abs(arm.y()) ? 1 : 0);
}

}  // namespace ripstop
