#pragma once

#include <memory>
#include <vector>

#include "ripstop/energy/woven_membrane.h"
#include "ripstop/model/tile/tile.h"
#include "ripstop/numeric/sparse_pattern.h"

namespace ripstop {

/// The equations of seam-exact flattening: the energy of the cloth and its constraints as functions of the flat
/// positions u (2 #V, x and y of each vertex in turn, the memory layout of Points2).
///
///     energy(u)      = sum_t A_t W_t + sum_b bending_b          [J]
///     length_i(u)    = (|u_b - u_a|^2 - l_i^2) / (2 l_i) = 0    [m], one per boundary edge, in boundary order
///     grain(u)       = sum_t A_t (D_t w_t)_y / A = 0            the mean warp lies along +x
///     area(u)        = sum_b cross(u_b, u_b+1) / 2 - A = 0      if the total area is kept, divided by sqrt(A) [m]
///
/// A length couples two vertices that share a triangle, so adding rho times its square to the Hessian causes no fill.
class SeamProblem {
  public:
    struct Options {
        double bending = 0;      ///< stiffness of the cut line, in A^1.5 E (E the mean stiffness)
        bool keep_area = false;  ///< the total area as an additional equality
    };

    /// The target shapes of triangles and edges include the tile's compensation (`target_triangles`,
    /// `target_lengths`).
    SeamProblem(const Tile& tile, const Fabric& fabric, const Options& options);

    int unknowns() const { return 2 * vertex_count_; }
    int edge_count() const { return static_cast<int>(lengths_.size()); }
    int dense_count() const { return keep_area_ ? 2 : 1; }  ///< grain, then area
    const SparsePattern& pattern() const { return *pattern_; }
    const Eigen::VectorXd& lengths() const { return lengths_; }
    void set_lengths(const Eigen::VectorXd& lengths) { lengths_ = lengths; }
    /// The scale of an edge's error [m]: its length, but at least 3e-5 of the outline, because positions are rounded.
    Eigen::VectorXd length_scales() const { return lengths_.cwiseMax(3e-5 * lengths_.sum()); }
    /// Sets stiffness, in A^1.5 E, and rest turning of each boundary vertex that is not a corner. Requires that
    /// bending was positive before.
    void set_bending(const Eigen::VectorXd& bending, const Eigen::VectorXd& reference);

    double energy(const Eigen::VectorXd& u) const;  ///< +infinity if a triangle is flipped

    /// Computes the gradient of the energy and the Hessian of energy + sum lambda_i length_i + mu · dense + rho/2 sum
    /// length_i'^2 for a Newton step. The Hessian goes to `values`, the pattern's lower triangle. Returns the energy.
    double assemble(const Eigen::VectorXd& u, const Eigen::VectorXd& lambda, const Eigen::VectorXd& mu, double rho,
                    Curvature curvature, Eigen::VectorXd& gradient, Eigen::VectorXd& values) const;
    Eigen::VectorXd gradient(const Eigen::VectorXd& u) const;

    Eigen::VectorXd flat_lengths(const Eigen::VectorXd& u) const;    ///< lengths of the boundary edges at u [m]
    Eigen::VectorXd flat_turning(const Eigen::VectorXd& u) const;    ///< turning at the boundary vertices [rad]
    Eigen::VectorXd edge_residual(const Eigen::VectorXd& u) const;   ///< length_i [m]
    Eigen::VectorXd dense_residual(const Eigen::VectorXd& u) const;  ///< grain, area
    Eigen::MatrixXd dense_rows(const Eigen::VectorXd& u) const;  ///< 2 #V x dense_count: gradients of grain and area

    /// The products J d and Jᵀ lambda for the edge lengths at u.
    Eigen::VectorXd edge_product(const Eigen::VectorXd& u, const Eigen::VectorXd& d) const;
    Eigen::VectorXd edge_transposed(const Eigen::VectorXd& u, const Eigen::VectorXd& lambda) const;

    /// The longest step in (0, 1] along d that stops 10 % short of the first degenerate triangle.
    double longest_step(const Eigen::VectorXd& u, const Eigen::VectorXd& d) const;

    /// Gauge choices: a vertex to fix, and an unknown whose fixing prevents rotation about it.
    int held_vertex() const { return held_vertex_; }
    int held_turn(const Eigen::VectorXd& u) const;

    double stiffness() const { return stiffness_; }  ///< E, the mean of c11 and c22 [N/m]
    double size() const { return size_; }            ///< square root of the area [m]
    int triangle_count() const { return static_cast<int>(triangles_.rows()); }

  private:
    void add_membrane(const Eigen::VectorXd& u, Curvature curvature, double& energy, Eigen::VectorXd& gradient,
                      Eigen::VectorXd* values) const;
    void add_bending(const Eigen::VectorXd& u, Curvature curvature, double& energy, Eigen::VectorXd& gradient,
                     Eigen::VectorXd* values) const;
    void add_edges(const Eigen::VectorXd& u, const Eigen::VectorXd& lambda, double rho, Curvature curvature,
                   Eigen::VectorXd& values) const;
    Vec2 at(const Eigen::VectorXd& u, int vertex) const { return u.segment<2>(2 * vertex); }
    double turning_at(const Eigen::VectorXd& u, int i) const;
    double limited(double stiffness, int i) const;
    int boundary_at(int i) const { return boundary_[static_cast<std::size_t>(i % edge_count())]; }

    int vertex_count_;
    Triangles triangles_;
    std::vector<TriangleMetric> metrics_;
    std::vector<int> boundary_;
    Eigen::VectorXd lengths_;
    Eigen::VectorXd grain_row_;
    WovenMembrane membrane_;
    double stiffness_, size_ = 0, area_ = 0;
    bool keep_area_;
    struct Bend {
        int index;                 ///< index in the boundary
        double reference;          ///< rest turning [rad]
        double length, stiffness;  ///< length of the cut line that belongs to the vertex, and its bending stiffness [m,
                                   ///< J m]
    };
    std::vector<Bend> bends_;
    int first_bend_group_ = 0, first_edge_group_ = 0;
    std::unique_ptr<SparsePattern> pattern_;
    int held_vertex_ = 0;
};

}  // namespace ripstop
