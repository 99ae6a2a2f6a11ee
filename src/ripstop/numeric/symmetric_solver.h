#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>

#include "ripstop/numeric/sparse_pattern.h"

namespace ripstop {

/// The inertia of a symmetric matrix: its numbers of negative, zero and positive eigenvalues.
struct Inertia {
    int positive = 0;
    int negative = 0;
    int zero = 0;  ///< pivots that are rounding error only

    bool operator==(const Inertia&) const = default;
};

/// The kind of factorisation.
enum class SolverKind {
    automatic,   ///< supernodal for large systems, if the build has it
    simplicial,  ///< L D Lᵀ, column by column (Eigen)
    supernodal,  ///< L Lᵀ in dense blocks (CHOLMOD, BLAS on one thread); simplicial if the build lacks it
};

/// Solves A x = b for many matrices A with the same sparse symmetric pattern: P A Pᵀ = L D Lᵀ with D diagonal and P a
/// fill-reducing ordering (`elimination_order`) that is computed once.
///
/// It does not pivot. Simplicial: A must be positive definite or quasi-definite. [H Jᵀ; J -δ] with H positive
/// definite and δ > 0 is quasi-definite, and any order is stable as long as δ and H are not tiny beside J; constraint
/// rows with a zero diagonal are refused or inaccurate. Supernodal: A must be positive definite, and a failed test
/// costs at most one factorisation. To test definiteness only, ask
///
///     solver.factorize(values) && solver.inertia().negative == 0
///
/// which works for both kinds. Deterministic: the same values give the same bytes (supernodal: on one processor type,
/// for which the BLAS picks its code). Not thread-safe: use one solver per thread.
class SymmetricSolver {
  public:
    explicit SymmetricSolver(const SparsePattern& pattern, SolverKind kind = SolverKind::automatic);
    ~SymmetricSolver();
    SymmetricSolver(SymmetricSolver&&) noexcept;
    SymmetricSolver& operator=(SymmetricSolver&&) noexcept;

    /// Factorises the matrix whose lower triangle is `values` (`SparsePattern::entry_count`). Returns false if a
    /// pivot is zero or not finite, supernodal also if one is negative; do not solve then.
    [[nodiscard]] bool factorize(const Eigen::VectorXd& values);

    /// The inertia of the matrix last factorised; all zero if numbers were not finite or memory ran out. A pivot
    /// counts as zero if it is below the possible rounding error of its sum, whatever the scale of its row.
    /// Supernodal stops at the first pivot that is not positive: one negative then stands for at least one eigenvalue
    /// that is negative or zero, and the rest is not counted.
    Inertia inertia() const;

    /// Solves for one right-hand side, or for one in each column. Requires that `factorize` returned true.
    Eigen::VectorXd solve(const Eigen::VectorXd& right) const;
    Eigen::MatrixXd solve_columns(const Eigen::MatrixXd& right) const;

    SolverKind kind() const;      ///< simplicial or supernodal
    int factorizations() const;   ///< attempts so far, failed ones included
    long factor_entries() const;  ///< entries of L below the diagonal, once factorised

  private:
    struct Factor;
    std::unique_ptr<Factor> factor_;
};

/// The libraries that `numeric` uses, with their licences, for `ripstop --version`.
std::string numeric_libraries();

}  // namespace ripstop
