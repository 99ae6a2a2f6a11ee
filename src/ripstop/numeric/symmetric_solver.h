#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>

#include "ripstop/numeric/sparse_pattern.h"

namespace ripstop {

/// The signs of a symmetric matrix's eigenvalues, counted.
struct Inertia {
    int positive = 0;
    int negative = 0;
    int zero = 0;  ///< pivots that are nothing but rounding

    bool operator==(const Inertia&) const = default;
};

/// How a system is factorised.
enum class SolverKind {
    automatic,   ///< supernodal for the large ones, where the build has it
    simplicial,  ///< L D Lᵀ, column by column (Eigen)
    supernodal,  ///< L Lᵀ in dense blocks (CHOLMOD, BLAS on one thread); simplicial in a build without it
};

/// Solves A x = b for many matrices A of one sparse symmetric pattern: P A Pᵀ = L D Lᵀ, D diagonal, P a fill-reducing
/// ordering (`elimination_order`), computed once.
///
/// There is no pivoting. Simplicial: A must be positive definite, or quasi-definite: [H Jᵀ; J -δ] with H positive
/// definite on its own and δ > 0, for which any order is stable as long as δ and H are not tiny beside J; constraint
/// rows with a zero diagonal are refused or inaccurate. Supernodal: A must be positive definite, and asking whether it
/// is costs at most the factorisation. Callers that need to know no more than that ask
///
///     solver.factorize(values) && solver.inertia().negative == 0
///
/// which holds for both kinds. Deterministic: the same values give the same bytes (supernodal: on one kind of
/// processor, for which the BLAS picks its code). One solver is used by one thread at a time.
class SymmetricSolver {
  public:
    explicit SymmetricSolver(const SparsePattern& pattern, SolverKind kind = SolverKind::automatic);
    ~SymmetricSolver();
    SymmetricSolver(SymmetricSolver&&) noexcept;
    SymmetricSolver& operator=(SymmetricSolver&&) noexcept;

    /// Factorises the matrix whose lower triangle is `values` (`SparsePattern::entry_count`). False where a pivot is
    /// zero or not finite, supernodal also where one is negative: nothing may be solved then.
    [[nodiscard]] bool factorize(const Eigen::VectorXd& values);

    /// Of the matrix last factorised; all zero where numbers were not finite or memory ran out. A pivot counts as zero
    /// where it is below what the sum it came from can lose to rounding, whatever the scale of its row. Supernodal
    /// stops at the first pivot that is not positive: one negative then stands for at least one eigenvalue that is
    /// negative or zero, and what comes after it is not counted.
    Inertia inertia() const;

    /// x for one right-hand side, and for one in each column. Require that `factorize` said true.
    Eigen::VectorXd solve(const Eigen::VectorXd& right) const;
    Eigen::MatrixXd solve_columns(const Eigen::MatrixXd& right) const;

    SolverKind kind() const;      ///< simplicial or supernodal
    int factorizations() const;   ///< all attempts so far
    long factor_entries() const;  ///< of L below the diagonal, once factorised

  private:
    struct Factor;
    std::unique_ptr<Factor> factor_;
};

/// The libraries behind this floor with their licences, for `ripstop --version`.
std::string numeric_libraries();

}  // namespace ripstop
