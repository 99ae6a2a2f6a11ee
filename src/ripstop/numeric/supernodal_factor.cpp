#include "ripstop/numeric/symmetric_factor.h"

#ifdef RIPSTOP_CHOLMOD

#include <cholmod.h>
#include <dlfcn.h>

#include <algorithm>
#include <utility>

namespace ripstop {
namespace {

template <class Function>
Function* loaded(const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
}

/// One thread in OpenBLAS, for the whole process: tiles are solved in parallel already, and sums must not depend on how
/// many threads there are. The BLAS is chosen when the program is loaded, so it is asked for then.
void keep_blas_to_one_thread() {
    static const bool done = [] {
        if (auto* const set = loaded<void(int)>("openblas_set_num_threads")) set(1);
        return true;
    }();
    static_cast<void>(done);
}

/// While it lives, OpenMP starts no threads for the thread it was made on. CHOLMOD would, four for every large block, and
/// nothing else keeps it from that; waking them costs more than they do.
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
        entries_ = static_cast<long>(common_.lnz) - static_cast<long>(matrix_.nrow);
    }

    ~SupernodalFactor() override {
        for (cholmod_dense* work : {solution_, work_y_, work_e_}) cholmod_free_dense(&work, &common_);
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
        // a_kk = sum_i l_ki^2, the pivot l_kk^2 among them: the sizes of all terms add up to 2 a_kk
        const Eigen::VectorXd pivot = pivots();
        for (Eigen::Index k = 0; k < pivot.size(); ++k) {
            const double diagonal = values_[lower_.column_start[static_cast<std::size_t>(k)]];
            ++(pivot[k] <= pivot_rounding * 2 * diagonal ? count.zero : count.positive);
        }
        return count;
    }

    void solve_in_place(Eigen::Ref<Eigen::MatrixXd> x) const override {
        cholmod_dense right{};
        right.nrow = static_cast<std::size_t>(x.rows());
        right.ncol = static_cast<std::size_t>(x.cols());
        right.d = static_cast<std::size_t>(x.outerStride());
        right.nzmax = right.d * right.ncol;
        right.x = x.data();
        right.xtype = CHOLMOD_REAL;
        right.dtype = CHOLMOD_DOUBLE;
        cholmod_solve2(CHOLMOD_A, factor_, &right, nullptr, &solution_, nullptr, &work_y_, &work_e_, &common_);
        x = Eigen::Map<const Eigen::MatrixXd>(static_cast<const double*>(solution_->x), x.rows(), x.cols());
    }

    long entries() const override { return entries_; }

  private:
    enum class State { failed, indefinite, usable };

    /// The squares of L's diagonal.
    Eigen::VectorXd pivots() const {
        const auto* const super = static_cast<const int*>(factor_->super);
        const auto* const rows_start = static_cast<const int*>(factor_->pi);
        const auto* const values_start = static_cast<const int*>(factor_->px);
        const auto* const values = static_cast<const double*>(factor_->x);
        Eigen::VectorXd result(static_cast<Eigen::Index>(factor_->n));
        for (std::size_t s = 0; s < factor_->nsuper; ++s) {
            const int height = rows_start[s + 1] - rows_start[s];
            for (int k = super[s]; k < super[s + 1]; ++k) {
                const double l = values[values_start[s] + (k - super[s]) * (height + 1)];
                result[k] = l * l;
            }
        }
        return result;
    }

    OrderedTriangle lower_;
    Eigen::VectorXd values_;
    mutable cholmod_common common_{};
    cholmod_sparse matrix_{};
    cholmod_factor* factor_ = nullptr;
    mutable cholmod_dense* solution_ = nullptr;
    mutable cholmod_dense* work_y_ = nullptr;
    mutable cholmod_dense* work_e_ = nullptr;
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
