#include "ripstop/base/index.h"
#include "ripstop/numeric/symmetric_factor.h"

#ifdef RIPSTOP_CHOLMOD

#include <cholmod.h>
#include <dlfcn.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace ripstop {
namespace {

template <class Function>
Function* loaded(const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
}

/// Limits OpenBLAS to one thread for the whole process: tiles are solved in parallel already, and sums must not
/// depend on the number of threads. The BLAS is chosen at load time, so its function is looked up at run time.
void keep_blas_to_one_thread() {
    static const bool done = [] {
        if (auto* const set = loaded<void(int)>("openblas_set_num_threads")) set(1);
        return true;
    }();
    static_cast<void>(done);
}

/// While it lives, OpenMP starts no threads for the thread that made it. CHOLMOD would start four for every large
/// block, and has no option against it; waking them takes longer than their work.
class WithoutOpenMp {
  public:
    WithoutOpenMp() {
        static auto* const get = loaded<int()>("omp_get_max_active_levels");
        if (!set() || !get) return;
        before_ = get();
        set()(0);
    }
    ~WithoutOpenMp() {
        if (before_ >= 0) set()(before_);
    }
    WithoutOpenMp(const WithoutOpenMp&) = delete;
    WithoutOpenMp& operator=(const WithoutOpenMp&) = delete;

  private:
    static void (*set())(int) {
        static auto* const function = loaded<void(int)>("omp_set_max_active_levels");
        return function;
    }
    int before_ = -1;
};

class SupernodalFactor : public SymmetricFactor {
  public:
    explicit SupernodalFactor(OrderedTriangle lower)
        : lower_(std::move(lower)), values_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(lower_.rows.size()))) {
        keep_blas_to_one_thread();
        cholmod_start(&common_);
        common_.print = 0;
        common_.nmethods = 1;
        common_.method[0].ordering = CHOLMOD_NATURAL;
        common_.postorder = false;
        common_.supernodal = CHOLMOD_SUPERNODAL;
        common_.quick_return_if_not_posdef = true;
        matrix_.nrow = matrix_.ncol = lower_.column_start.size() - 1;
        matrix_.nzmax = lower_.rows.size();
        matrix_.p = lower_.column_start.data();
        matrix_.i = lower_.rows.data();
        matrix_.x = values_.data();
        matrix_.stype = -1;
        matrix_.itype = CHOLMOD_INT;
        matrix_.xtype = CHOLMOD_REAL;
        matrix_.dtype = CHOLMOD_DOUBLE;
        matrix_.sorted = matrix_.packed = true;
        factor_ = cholmod_analyze(&matrix_, &common_);
        for (int s = 0; factor_ && s < block_count(); ++s) highest_ = std::max(highest_, block_rows(s));
        entries_ = static_cast<long>(common_.lnz) - static_cast<long>(matrix_.nrow);
    }

    ~SupernodalFactor() override {
        cholmod_free_factor(&factor_, &common_);
        cholmod_finish(&common_);
    }
    SupernodalFactor(const SupernodalFactor&) = delete;
    SupernodalFactor& operator=(const SupernodalFactor&) = delete;

    double* values() override { return values_.data(); }

    bool factorize() override {
        state_ = State::failed;
        if (!factor_ || !values_.allFinite()) return false;
        const WithoutOpenMp alone;
        if (!cholmod_factorize(&matrix_, factor_, &common_)) return false;
        if (factor_->minor < factor_->n)
            state_ = State::indefinite;
        else if (pivots().allFinite())
            state_ = State::usable;
        return state_ == State::usable;
    }

    Inertia inertia() const override {
        Inertia count;
        if (state_ == State::failed) return count;
        if (state_ == State::indefinite) return {static_cast<int>(factor_->minor), 1, 0};
        // a_kk = sum_i l_ki^2, and the pivot l_kk^2 is one of the terms: the magnitudes of all terms sum to 2 a_kk
        const Eigen::VectorXd pivot = pivots();
        for (Eigen::Index k = 0; k < pivot.size(); ++k) {
            const double diagonal = values_[lower_.column_start[at(k)]];
            ++(pivot[k] <= pivot_rounding * 2 * diagonal ? count.zero : count.positive);
        }
        return count;
    }

    void solve_in_place(Eigen::Ref<Eigen::MatrixXd> x) const override {
        Eigen::Index column = 0;
        for (; column + 2 <= x.cols(); column += 2) solve_columns<2>(x.middleCols(column, 2));
        if (column < x.cols()) solve_columns<1>(x.middleCols(column, 1));
    }

    long entries() const override { return entries_; }

  private:
    enum class State { failed, indefinite, usable };

    /// Columns `first` … `first + width - 1` of L as a dense block: its triangle on top, then the rows `below`.
    struct Block {
        int first, width, height;
        const double* values;  ///< column-major, columns `height` apart
        const int* below;      ///< height - width

        const double* column(int j) const { return values + static_cast<std::ptrdiff_t>(j) * height; }
        const double* under(int j) const { return column(j) + width; }
    };

    int block_count() const { return static_cast<int>(factor_->nsuper); }

    int block_rows(int s) const {
        const auto* const start = static_cast<const int*>(factor_->pi);
        return start[s + 1] - start[s];
    }

    Block block_at(int s) const {
        const auto* const super = static_cast<const int*>(factor_->super);
        const int width = super[s + 1] - super[s];
        return {super[s], width, block_rows(s),
                static_cast<const double*>(factor_->x) + static_cast<const int*>(factor_->px)[s],
                static_cast<const int*>(factor_->s) + static_cast<const int*>(factor_->pi)[s] + width};
    }

    template <int count>
    using Columns = Eigen::Matrix<double, Eigen::Dynamic, count, count == 1 ? Eigen::ColMajor : Eigen::RowMajor>;

    /// Solves L Lᵀ x = x for several columns at once. L takes longer to fetch than to use, so it is read once for all
    /// of them. CHOLMOD's own solve calls the BLAS for every block, however small.
    template <int count>
    void solve_columns(Eigen::Ref<Eigen::MatrixXd> x) const {
        Columns<count> y = x;
        Columns<count> below(highest_, count);
        for (int s = 0; s < block_count(); ++s) solve_block<count>(block_at(s), y, below);
        for (int s = block_count() - 1; s >= 0; --s) solve_block_transposed<count>(block_at(s), y, below);
        x = y;
    }

    template <int count>
    using Row = Eigen::Matrix<double, 1, count>;

    /// Solves for the unknowns of the block and subtracts their contribution from those below.
    template <int count>
    static void solve_block(const Block& block, Columns<count>& y, Columns<count>& sum) {
        const int below = block.height - block.width;
        sum.topRows(below).setZero();
        for (int j = 0; j < block.width; ++j) {
            const double* const column = block.column(j);
            const Row<count> known = y.row(block.first + j) /= column[j];
            for (int i = j + 1; i < block.width; ++i) y.row(block.first + i) -= column[i] * known;
        }
        int j = 0;
        for (; j + 4 <= block.width; j += 4) {
            const double *const a = block.under(j), *const b = block.under(j + 1), *const c = block.under(j + 2),
                                *const d = block.under(j + 3);
            const Eigen::Matrix<double, 4, count> k = y.template middleRows<4>(block.first + j);
            for (int i = 0; i < below; ++i)
                sum.row(i) += (a[i] * k.row(0) + b[i] * k.row(1)) + (c[i] * k.row(2) + d[i] * k.row(3));
        }
        for (; j < block.width; ++j) {
            const double* const a = block.under(j);
            const Row<count> k = y.row(block.first + j);
            for (int i = 0; i < below; ++i) sum.row(i) += a[i] * k;
        }
        for (int i = 0; i < below; ++i) y.row(block.below[i]) -= sum.row(i);
    }

    template <int count>
    static void solve_block_transposed(const Block& block, Columns<count>& y, Columns<count>& known) {
        const int below = block.height - block.width;
        for (int i = 0; i < below; ++i) known.row(i) = y.row(block.below[i]);
        int j = 0;
        for (; j + 4 <= block.width; j += 4) {
            const double *const a = block.under(j), *const b = block.under(j + 1), *const c = block.under(j + 2),
                                *const d = block.under(j + 3);
            Row<count> sa = Row<count>::Zero(), sb = sa, sc = sa, sd = sa;
            for (int i = 0; i < below; ++i) {
                const Row<count> k = known.row(i);
                sa += a[i] * k;
                sb += b[i] * k;
                sc += c[i] * k;
                sd += d[i] * k;
            }
            y.row(block.first + j) -= sa;
            y.row(block.first + j + 1) -= sb;
            y.row(block.first + j + 2) -= sc;
            y.row(block.first + j + 3) -= sd;
        }
        for (; j < block.width; ++j) {
            const double* const a = block.under(j);
            Row<count> sum = Row<count>::Zero();
            for (int i = 0; i < below; ++i) sum += a[i] * known.row(i);
            y.row(block.first + j) -= sum;
        }
        for (j = block.width - 1; j >= 0; --j) {
            const double* const column = block.column(j);
            Row<count> value = y.row(block.first + j);
            for (int i = j + 1; i < block.width; ++i) value -= column[i] * y.row(block.first + i);
            y.row(block.first + j) = value / column[j];
        }
    }

    /// The squared diagonal of L.
    Eigen::VectorXd pivots() const {
        Eigen::VectorXd result(static_cast<Eigen::Index>(factor_->n));
        for (int s = 0; s < block_count(); ++s) {
            const Block block = block_at(s);
            for (int j = 0; j < block.width; ++j) {
                const double l = block.column(j)[j];
                result[block.first + j] = l * l;
            }
        }
        return result;
    }

    OrderedTriangle lower_;
    Eigen::VectorXd values_;
    cholmod_common common_{};
    cholmod_sparse matrix_{};
    cholmod_factor* factor_ = nullptr;
    int highest_ = 0;  // rows of the highest block
    long entries_ = 0;
    State state_ = State::failed;
};

}  // namespace

std::unique_ptr<SymmetricFactor> make_supernodal_factor(OrderedTriangle lower) {
    return std::make_unique<SupernodalFactor>(std::move(lower));
}

}  // namespace ripstop

#else

namespace ripstop {

std::unique_ptr<SymmetricFactor> make_supernodal_factor(OrderedTriangle) {
    return nullptr;
}

}  // namespace ripstop

#endif
