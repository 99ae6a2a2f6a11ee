#include <Eigen/SparseCholesky>
#include <cmath>

#include "ripstop/numeric/symmetric_factor.h"

namespace ripstop {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// Computes x = L⁻ᵀ D⁻¹ L⁻¹ x for several columns at once, so that each entry of L is read once. The sums of a column
/// do not depend on the other columns.
template <int count>
void solve_columns(const SparseMatrix& L, const Eigen::VectorXd& pivots, Eigen::Ref<Eigen::MatrixXd> x) {
    Eigen::Matrix<double, Eigen::Dynamic, count, count == 1 ? Eigen::ColMajor : Eigen::RowMajor> y = x;
    const int* const start = L.outerIndexPtr();
    const int* const row = L.innerIndexPtr();
    const double* const value = L.valuePtr();
    for (int c = 0; c < L.cols(); ++c) {
        const Eigen::Matrix<double, 1, count> known = y.row(c);
        for (int k = start[c]; k < start[c + 1]; ++k) y.row(row[k]) -= value[k] * known;
    }
    for (int c = static_cast<int>(L.cols()) - 1; c >= 0; --c) {
        Eigen::Matrix<double, 1, count> sum = y.row(c) / pivots[c];
        for (int k = start[c]; k < start[c + 1]; ++k) sum -= value[k] * y.row(row[k]);
        y.row(c) = sum;
    }
    x = y;
}

class SimplicialFactor : public SymmetricFactor {
  public:
    explicit SimplicialFactor(const OrderedTriangle& upper) {
        const auto size = static_cast<int>(upper.column_start.size()) - 1;
        const Eigen::VectorXd zeros = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(upper.rows.size()));
        ordered_ = Eigen::Map<const SparseMatrix>(size, size, zeros.size(), upper.column_start.data(),
                                                  upper.rows.data(), zeros.data());
        ldlt_.analyzePattern(ordered_);
    }

    double* values() override { return ordered_.valuePtr(); }

    bool factorize() override {
        ldlt_.factorize(ordered_);
        usable_ = ldlt_.info() == Eigen::Success;
        if (usable_) pivots_ = ldlt_.vectorD();
        usable_ = usable_ && pivots_.allFinite();
        return usable_;
    }

    Inertia inertia() const override {
        Inertia count;
        if (!usable_) return count;
        Eigen::VectorXd scale = ordered_.diagonal().cwiseAbs();
        for (int c = 0; c < lower().outerSize(); ++c)
            for (SparseMatrix::InnerIterator it(lower(), c); it; ++it)
                scale[it.row()] += it.value() * it.value() * std::abs(pivots_[c]);
        for (Eigen::Index k = 0; k < pivots_.size(); ++k) {
            if (std::abs(pivots_[k]) <= pivot_rounding * scale[k])
                ++count.zero;
            else
                ++(pivots_[k] > 0 ? count.positive : count.negative);
        }
        return count;
    }

    void solve_in_place(Eigen::Ref<Eigen::MatrixXd> x) const override {
        Eigen::Index column = 0;
        for (; column + 2 <= x.cols(); column += 2) solve_columns<2>(lower(), pivots_, x.middleCols(column, 2));
        if (column < x.cols()) solve_columns<1>(lower(), pivots_, x.middleCols(column, 1));
    }

    long entries() const override { return lower().nonZeros(); }

  private:
    const SparseMatrix& lower() const { return ldlt_.matrixL().nestedExpression(); }

    // With natural ordering and the upper triangle, SimplicialLDLT reads the matrix without a copy.
    Eigen::SimplicialLDLT<SparseMatrix, Eigen::Upper, Eigen::NaturalOrdering<int>> ldlt_;
    SparseMatrix ordered_;
    Eigen::VectorXd pivots_;
    bool usable_ = false;
};

}  // namespace

std::unique_ptr<SymmetricFactor> make_simplicial_factor(const OrderedTriangle& upper) {
    return std::make_unique<SimplicialFactor>(upper);
}

}  // namespace ripstop
