#pragma once

#include <Eigen/Core>
#include <memory>

#include "ripstop/numeric/elimination_order.h"
#include "ripstop/numeric/symmetric_solver.h"

namespace ripstop {

/// The factorisation interface behind `SymmetricSolver`. The unknowns are already in elimination order.
class SymmetricFactor {
  public:
    virtual ~SymmetricFactor() = default;
    virtual double* values() = 0;  ///< values of the triangle it was made with; fill them in before `factorize`
    virtual bool factorize() = 0;
    virtual Inertia inertia() const = 0;
    virtual void solve_in_place(Eigen::Ref<Eigen::MatrixXd> x) const = 0;
    virtual long entries() const = 0;
};

/// A pivot a_kk - sum_i l_ki^2 d_i below this share of the magnitude of its terms is rounding error only.
inline constexpr double pivot_rounding = 64 * 2.220446049250313e-16;

/// L D Lᵀ, column by column (Eigen), from the upper triangle.
std::unique_ptr<SymmetricFactor> make_simplicial_factor(const OrderedTriangle& upper);

/// L Lᵀ in dense blocks (CHOLMOD), from the lower triangle; null in a build without it.
std::unique_ptr<SymmetricFactor> make_supernodal_factor(OrderedTriangle lower);

}  // namespace ripstop
