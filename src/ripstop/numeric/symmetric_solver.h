#pragma once

#include <Eigen/Core>
#include <memory>

#include "ripstop/numeric/sparse_pattern.h"

namespace ripstop {

/// The signs of a symmetric matrix's eigenvalues, counted.
struct Inertia {
    int positive = 0;
    int negative = 0;
    int zero = 0;  ///< pivots that are nothing but rounding

    bool operator==(const Inertia&) const = default;
};

/// Solves A x = b for many matrices A of one sparse symmetric pattern: P A Pᵀ = L D Lᵀ, D diagonal, P the approximate
/// minimum degree ordering, computed once.
///
/// There is no pivoting, so A must be positive definite, or quasi-definite: [H Jᵀ; J -δ] with H positive definite on its
/// own and δ > 0, for which any order is stable as long as δ and H are not tiny beside J. Constraint rows with a zero
/// diagonal are refused or inaccurate.
///
/// Analysis costs about as much as a factorisation. Deterministic: the same values give the same bytes.
class SymmetricSolver {
  public:
    explicit SymmetricSolver(const SparsePattern& pattern);
    ~SymmetricSolver();
    SymmetricSolver(SymmetricSolver&&) noexcept;
    SymmetricSolver& operator=(SymmetricSolver&&) noexcept;

    /// Factorises the matrix whose lower triangle is `values` (`SparsePattern::entry_count`). False where a pivot is zero
    /// or not finite: nothing may be solved then.
    [[nodiscard]] bool factorize(const Eigen::VectorXd& values);

    /// Of the matrix last factorised; all zero where that failed. A pivot counts as zero where it is below what the sum it
    /// came from can lose to rounding, whatever the scale of its row.
    Inertia inertia() const;

    /// x for one right-hand side, and for one in each column. Require that `factorize` said true.
    Eigen::VectorXd solve(const Eigen::VectorXd& right) const;
    Eigen::MatrixXd solve_columns(const Eigen::MatrixXd& right) const;

    int factorizations() const;   ///< all attempts so far
    long factor_entries() const;  ///< of L below the diagonal

  private:
    struct Factor;
    std::unique_ptr<Factor> factor_;
};

}  // namespace ripstop
