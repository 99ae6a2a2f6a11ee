#include "ripstop/numeric/symmetric_solver.h"

#include <cassert>
#include <utility>

#include "ripstop/numeric/elimination_order.h"
#include "ripstop/numeric/symmetric_factor.h"

namespace ripstop {
namespace {

/// Number of entries in the lower triangle from which dense blocks pay off: docs/decisions/0002-cholmod.md.
constexpr int supernodal_from = 75'000;

bool wants_supernodal(const SparsePattern& pattern, SolverKind kind) {
    return kind == SolverKind::supernodal ||
           (kind == SolverKind::automatic && pattern.entry_count() >= supernodal_from);
}

}  // namespace

struct SymmetricSolver::Factor {
    std::vector<int> order;  // order[k] is the unknown eliminated k-th
    std::vector<int> slots;  // entry of the ordered triangle -> place in the caller's values
    std::unique_ptr<SymmetricFactor> factor;
    SolverKind kind = SolverKind::simplicial;
    int attempts = 0;
    bool usable = false;

    Eigen::MatrixXd solve(Eigen::MatrixXd right) const {
        assert(usable);
        Eigen::MatrixXd x = right(order, Eigen::all);
        factor->solve_in_place(x);
        right(order, Eigen::all) = x;
        return right;
    }
};

SymmetricSolver::SymmetricSolver(const SparsePattern& pattern, SolverKind kind) : factor_(std::make_unique<Factor>()) {
    factor_->order = elimination_order(pattern);
    if (wants_supernodal(pattern, kind)) {
        OrderedTriangle lower = renumbered(pattern, factor_->order, Triangle::lower);
        factor_->slots = std::move(lower.slots);
        factor_->factor = make_supernodal_factor(std::move(lower));
        factor_->kind = SolverKind::supernodal;
    }
    if (!factor_->factor) {
        OrderedTriangle upper = renumbered(pattern, factor_->order, Triangle::upper);
        factor_->slots = std::move(upper.slots);
        factor_->factor = make_simplicial_factor(upper);
        factor_->kind = SolverKind::simplicial;
    }
}

SymmetricSolver::~SymmetricSolver() = default;
SymmetricSolver::SymmetricSolver(SymmetricSolver&&) noexcept = default;
SymmetricSolver& SymmetricSolver::operator=(SymmetricSolver&&) noexcept = default;

bool SymmetricSolver::factorize(const Eigen::VectorXd& values) {
    assert(values.size() == static_cast<Eigen::Index>(factor_->slots.size()));
    double* const ordered = factor_->factor->values();
    for (std::size_t k = 0; k < factor_->slots.size(); ++k) ordered[k] = values[factor_->slots[k]];
    ++factor_->attempts;
    factor_->usable = factor_->factor->factorize();
    return factor_->usable;
}

Inertia SymmetricSolver::inertia() const {
    return factor_->factor->inertia();
}

Eigen::VectorXd SymmetricSolver::solve(const Eigen::VectorXd& right) const {
    return factor_->solve(right);
}

Eigen::MatrixXd SymmetricSolver::solve_columns(const Eigen::MatrixXd& right) const {
    return factor_->solve(right);
}

SolverKind SymmetricSolver::kind() const {
    return factor_->kind;
}

int SymmetricSolver::factorizations() const {
    return factor_->attempts;
}

long SymmetricSolver::factor_entries() const {
    return factor_->factor->entries();
}

std::string numeric_libraries() {
    const std::string eigen =
        "Eigen " + std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) + " (MPL-2)";
#ifdef RIPSTOP_CHOLMOD
    return eigen + ", CHOLMOD supernodal (GPL-2+)";
#else
    return eigen;
#endif
}

}  // namespace ripstop
