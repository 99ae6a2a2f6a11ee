#include "ripstop/numeric/symmetric_solver.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace ripstop {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

}  // namespace

struct SymmetricSolver::Factor {
    // In natural order and with the upper triangle, SimplicialLDLT reads the matrix where it lies. Permuting it is then
    // one gather here, instead of a search and a copy at each factorisation.
    Eigen::SimplicialLDLT<SparseMatrix, Eigen::Upper, Eigen::NaturalOrdering<int>> ldlt;
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
    SparseMatrix ordered;
    std::vector<int> slot_of_entry;  // ordered's entry -> place in the caller's values
    int attempts = 0;
    bool usable = false;
};

SymmetricSolver::SymmetricSolver(const SparsePattern& pattern) : factor_(std::make_unique<Factor>()) {
    const int size = pattern.size();
    const Eigen::VectorXd numbers = Eigen::VectorXd::LinSpaced(pattern.entry_count(), 0, pattern.entry_count() - 1);
    const Eigen::Map<const SparseMatrix> lower(size, size, pattern.entry_count(), pattern.column_start().data(),
                                               pattern.rows().data(), numbers.data());
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> inverse;
    Eigen::AMDOrdering<int>()(lower.selfadjointView<Eigen::Lower>(), inverse);
    factor_->order = inverse.inverse();

    factor_->ordered.resize(size, size);
    factor_->ordered.selfadjointView<Eigen::Upper>() = lower.selfadjointView<Eigen::Lower>().twistedBy(factor_->order);
    factor_->slot_of_entry.resize(static_cast<std::size_t>(pattern.entry_count()));
    for (std::size_t k = 0; k < factor_->slot_of_entry.size(); ++k)
        factor_->slot_of_entry[k] = static_cast<int>(factor_->ordered.valuePtr()[k]);
    factor_->ldlt.analyzePattern(factor_->ordered);
}

SymmetricSolver::~SymmetricSolver() = default;
SymmetricSolver::SymmetricSolver(SymmetricSolver&&) noexcept = default;
SymmetricSolver& SymmetricSolver::operator=(SymmetricSolver&&) noexcept = default;

bool SymmetricSolver::factorize(const Eigen::VectorXd& values) {
    assert(values.size() == static_cast<Eigen::Index>(factor_->slot_of_entry.size()));
    double* const ordered = factor_->ordered.valuePtr();
    for (std::size_t k = 0; k < factor_->slot_of_entry.size(); ++k) ordered[k] = values[factor_->slot_of_entry[k]];
    ++factor_->attempts;
    factor_->ldlt.factorize(factor_->ordered);
    factor_->usable = factor_->ldlt.info() == Eigen::Success && factor_->ldlt.vectorD().allFinite();
    return factor_->usable;
}

Inertia SymmetricSolver::inertia() const {
    Inertia count;
    if (!factor_->usable) return count;
    const Eigen::VectorXd pivots = factor_->ldlt.vectorD();
    // d_k = a_kk - sum_i l_ki^2 d_i: the sizes of the terms tell how much of d_k can be rounding.
    Eigen::VectorXd scale = factor_->ordered.diagonal().cwiseAbs();
    const SparseMatrix& lower = factor_->ldlt.matrixL().nestedExpression();
    for (int c = 0; c < lower.outerSize(); ++c)
        for (SparseMatrix::InnerIterator it(lower, c); it; ++it)
            scale[it.row()] += it.value() * it.value() * std::abs(pivots[c]);
    constexpr double rounding = 64 * std::numeric_limits<double>::epsilon();
    for (Eigen::Index k = 0; k < pivots.size(); ++k) {
        if (std::abs(pivots[k]) <= rounding * scale[k])
            ++count.zero;
        else
            ++(pivots[k] > 0 ? count.positive : count.negative);
    }
    return count;
}

Eigen::VectorXd SymmetricSolver::solve(const Eigen::VectorXd& right) const {
    assert(factor_->usable);
    const Eigen::VectorXd ordered = factor_->order * right;
    return factor_->order.inverse() * factor_->ldlt.solve(ordered).eval();
}

Eigen::MatrixXd SymmetricSolver::solve_columns(const Eigen::MatrixXd& right) const {
    assert(factor_->usable);
    const Eigen::MatrixXd ordered = factor_->order * right;
    return factor_->order.inverse() * factor_->ldlt.solve(ordered).eval();
}

int SymmetricSolver::factorizations() const {
    return factor_->attempts;
}

long SymmetricSolver::factor_entries() const {
    return factor_->ldlt.matrixL().nestedExpression().nonZeros();
}

}  // namespace ripstop
