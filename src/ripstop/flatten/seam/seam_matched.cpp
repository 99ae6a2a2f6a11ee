#include "ripstop/flatten/seam/seam_matched.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "ripstop/base/error.h"
#include "ripstop/base/index.h"
#include "ripstop/base/parallel.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"
#include "ripstop/flatten/seam/seam_exact.h"
#include "ripstop/flatten/seam/seam_tile.h"
#include "ripstop/flatten/tools/grain.h"
#include "ripstop/numeric/box_quadratic.h"

namespace ripstop {
namespace {

using Vector = Eigen::VectorXd;

constexpr double force_tolerance = 1e-7;  // across a seam, relative to E times the mean boundary edge
constexpr double first_shift = 1e-6;      // in mean diagonal entries of the Hessian
constexpr int max_shifts = 8;
constexpr int max_halvings = 12;
constexpr double energy_noise = 1e-12;

/// The tiles that are flattened together and the stretches of their seams.
class MatchedEnvelope {
  public:
    MatchedEnvelope(const Envelope& envelope, const Fabric& fabric, const SeamMatchedOptions& options)
        : envelope_(envelope),
          fabric_(fabric),
          options_(options),
          stretch_(find_seam_stretch(envelope)),
          tiles_(envelope.tiles.size()),
          h_(Vector::Zero(stretch_.count)),
          lower_(Vector::Constant(stretch_.count, -options.slack)),
          upper_(Vector::Constant(stretch_.count, options.slack)) {}

    std::vector<Flattening> flatten();

  private:
    const TileStretch& stretch_of(int t) const { return stretch_.tiles[at(t)]; }
    std::unique_ptr<SeamTile>& tile(int t) { return tiles_[at(t)]; }
    void for_each_tile(const std::function<void(int, SeamTile&)>& task);
    void loosen();
    void begin();
    void match();
    void find_pattern();
    void linearize();
    double energy();
    Vector gradient();
    double imbalance(int t) const;
    bool balanced(const Vector& g);
    bool advance();
    std::optional<Vector> newton_change(const Vector& g);
    Flattening finish(int t);
    std::string note(int t) const;

    const Envelope& envelope_;
    const Fabric& fabric_;
    const SeamMatchedOptions& options_;
    SeamStretch stretch_;
    std::vector<std::unique_ptr<SeamTile>> tiles_;  ///< null for a tile that is flattened alone
    Vector h_, lower_, upper_;
    Vector lengths_;  ///< lengths of the intervals, summed over their sides [m]
    std::optional<SparsePattern> pattern_;
    std::optional<SymmetricSolver> solver_;
    std::vector<int> group_;  ///< group of each tile in the pattern
    Vector values_;
    bool exact_ = false;
    SolveSummary summary_;
    Vector imbalance_;  ///< unbalanced force of each interval [N]
};

void MatchedEnvelope::for_each_tile(const std::function<void(int, SeamTile&)>& task) {
    parallel_for(static_cast<int>(tiles_.size()), options_.threads, [&](int t) {
        if (tile(t)) task(t, *tile(t));
    });
}

/// Flattens every tile with free edges. The initial stretch of an interval is the mean of what its sides prefer.
void MatchedEnvelope::loosen() {
    parallel_for(static_cast<int>(tiles_.size()), options_.threads, [&](int t) {
        const Tile& from = envelope_.tiles[at(t)];
        if (!stretch_of(t).intervals.empty())
            tile(t) = std::make_unique<SeamTile>(from, from.fabric_or(fabric_), stretch_of(t), options_.bending);
    });
    lengths_ = Vector::Zero(stretch_.count);
    for (int t = 0; t < static_cast<int>(tiles_.size()); ++t) {
        if (!tile(t)) continue;
        const TileStretch& own = stretch_of(t);
        lengths_(own.intervals) += own.reach.colwise().sum().transpose();
        h_(own.intervals) += own.reach.transpose() * tile(t)->free_stretch();
    }
    h_ = h_.cwiseQuotient(lengths_).cwiseMax(lower_).cwiseMin(upper_);
}

/// Holds every tile at those stretches. A tile that cannot be held is flattened alone, as drawn, and its seams keep
/// their drawn lengths.
void MatchedEnvelope::begin() {
    std::vector<char> asked(tiles_.size(), 1), failed(tiles_.size());
    while (std::any_of(asked.begin(), asked.end(), [](char yes) { return yes; })) {
        for_each_tile([&](int t, SeamTile& one) {
            const auto i = static_cast<std::size_t>(t);
            failed[i] = asked[i] && !one.hold(h_(stretch_of(t).intervals));
        });
        Vector changed = Vector::Zero(h_.size());
        for (int t = 0; t < static_cast<int>(tiles_.size()); ++t) {
            if (!tile(t) || !failed[at(t)]) continue;
            tile(t).reset();
            for (const int i : stretch_of(t).intervals) {
                changed[i] = 1;
                h_[i] = lower_[i] = upper_[i] = 0;
            }
        }
        for (int t = 0; t < static_cast<int>(tiles_.size()); ++t)
            asked[at(t)] = tile(t) && (changed(stretch_of(t).intervals).array() > 0).any() ? 1 : 0;
    }
}

void MatchedEnvelope::find_pattern() {
    Couplings couplings;
    for (std::size_t t = 0; t < tiles_.size(); ++t)
        group_.push_back(tiles_[t] ? couplings.add_element(stretch_.tiles[t].intervals) : -1);
    pattern_.emplace(stretch_.count, couplings);
    solver_.emplace(*pattern_);
}

void MatchedEnvelope::linearize() {
    std::vector<Eigen::MatrixXd> hessians(tiles_.size());
    for_each_tile([&](int t, SeamTile& one) { hessians[at(t)] = one.linearize(); });
    values_ = Vector::Zero(pattern_->entry_count());
    exact_ = true;
    for (std::size_t t = 0; t < tiles_.size(); ++t) {
        if (!tiles_[t]) continue;
        exact_ = exact_ && tiles_[t]->exact();
        const auto slots = pattern_->slots(group_[t]);
        std::size_t k = 0;
        for (int a = 0; a < hessians[t].rows(); ++a)
            for (int b = 0; b <= a; ++b) values_[slots[k++]] += hessians[t](a, b);
    }
    // fixed seams, between tiles that are flattened alone
    for (int i = 0; i < pattern_->size(); ++i)
        if (lower_[i] == upper_[i]) values_[pattern_->diagonal_slot(i)] += 1;
}

double MatchedEnvelope::energy() {
    double sum = 0;
    for (const auto& one : tiles_)
        if (one) sum += one->energy();
    return sum;
}

Vector MatchedEnvelope::gradient() {
    Vector g = Vector::Zero(stretch_.count);
    for (std::size_t t = 0; t < tiles_.size(); ++t)
        if (tiles_[t]) g(stretch_.tiles[t].intervals) += tiles_[t]->gradient();
    return g;
}

/// The largest unbalanced force across the seams of a tile.
double MatchedEnvelope::imbalance(int t) const {
    return imbalance_(stretch_of(t).intervals).maxCoeff() / tiles_[at(t)]->force_scale();
}

bool MatchedEnvelope::balanced(const Vector& g) {
    imbalance_ = 2 * free_gradient(g, h_, lower_, upper_).cwiseAbs().cwiseQuotient(lengths_);
    for (int t = 0; t < static_cast<int>(tiles_.size()); ++t)
        if (tile(t) && !(imbalance(t) <= force_tolerance)) return false;
    return true;
}

/// The change of h that minimises the quadratic model in the box; adds a multiple of the identity if necessary.
std::optional<Vector> MatchedEnvelope::newton_change(const Vector& g) {
    double mean = 0, shift = 0;
    for (int i = 0; i < pattern_->size(); ++i) mean += std::abs(values_[pattern_->diagonal_slot(i)]) / pattern_->size();
    for (int attempt = 0; attempt <= max_shifts; ++attempt) {
        Vector shifted = values_;
        for (int i = 0; i < pattern_->size(); ++i) shifted[pattern_->diagonal_slot(i)] += shift * mean;
        std::optional<Vector> change = minimize_in_box(*pattern_, *solver_, shifted, g, lower_ - h_, upper_ - h_);
        if (change) return change;
        exact_ = false;
        shift = shift == 0 ? first_shift : 10 * shift;
    }
    return std::nullopt;
}

/// One iteration. Returns false if no step lowers the energy.
bool MatchedEnvelope::advance() {
    linearize();
    const Vector g = gradient();
    const std::optional<Vector> change = newton_change(g);
    if (!change) return false;
    for_each_tile([&](int t, SeamTile& one) { one.aim((*change)(stretch_of(t).intervals)); });
    const double before = energy(), slope = g.dot(*change);
    double share = 1;
    for (int halving = 0; halving < max_halvings; ++halving, share *= 0.5) {
        Vector energies = Vector::Zero(static_cast<Eigen::Index>(tiles_.size()));
        for_each_tile([&](int t, SeamTile& one) { energies[t] = one.attempt(share); });
        if (!(energies.sum() <= before + 1e-4 * share * slope + energy_noise * before)) continue;
        for_each_tile([](int, SeamTile& one) { one.accept(); });
        h_ += share * *change;
        return true;
    }
    return false;
}

void MatchedEnvelope::match() {
    find_pattern();
    summary_ = {Termination::iteration_limit, 0, 0, "the tensions on the two sides of the seams are not yet equal"};
    while (true) {
        if (balanced(gradient())) {
            summary_.termination = Termination::converged;
            summary_.reason = "the tensions on the two sides of every seam are equal";
            if (summary_.iterations == 0) {
                linearize();
                newton_change(gradient());
            }
            return;
        }
        if (summary_.iterations == options_.max_iterations) return;
        ++summary_.iterations;
        if (options_.progress)
            options_.progress(1 - std::exp2(-0.5 * summary_.iterations),
                              "round " + std::to_string(summary_.iterations) + " over the seams");
        if (!advance()) {
            summary_.termination = Termination::stagnated;
            summary_.reason = "no change of the seams lowers the energy further";
            balanced(gradient());
            return;
        }
    }
}

std::string MatchedEnvelope::note(int t) const {
    const Vector own = h_(stretch_of(t).intervals);
    return "its seams are cut " + format_fixed(own.minCoeff() / percent, 3) + " to " +
           format_fixed(own.maxCoeff() / percent, 3) + " % longer than drawn, as its neighbours' are";
}

Flattening MatchedEnvelope::finish(int t) {
    const Tile& of = envelope_.tiles[at(t)];
    if (!tile(t)) {
        Flattening alone = flatten_seam_exact(of, of.fabric_or(fabric_));
        alone.note = stretch_of(t).intervals.empty()
                         ? "has no seam with a neighbour: flattened with its edges as drawn"
                         : "could not be held at the lengths its neighbours need: flattened with its seams as drawn";
        return alone;
    }
    const SeamSolution& held = tile(t)->solution();
    Flattening result;
    result.positions = Eigen::Map<const Points2>(held.u.data(), held.u.size() / 2, 2);
    result.summary = summary_;
    result.summary.factorizations = tile(t)->factorizations();
    result.certificate = {std::max(held.force_residual, imbalance(t)), held.length_residual,
                          held.strict_minimum && exact_};
    result.seam_tension = held.lambda;
    result.edges_on_curve = true;
    result.note = note(t);
    align_with_grain(of, result.positions);
    return result;
}

std::vector<Flattening> MatchedEnvelope::flatten() {
    loosen();
    begin();
    if (std::any_of(tiles_.begin(), tiles_.end(), [](const auto& one) { return one != nullptr; })) match();
    std::vector<Flattening> results(tiles_.size());
    parallel_for(static_cast<int>(tiles_.size()), options_.threads, [&](int t) { results[at(t)] = finish(t); });
    return results;
}

}  // namespace

std::vector<Flattening> flatten_seam_matched(const Envelope& envelope, const Fabric& fabric,
                                             const SeamMatchedOptions& options) {
    if (!(options.slack > 0) || !(options.bending > 0) || options.max_iterations <= 0)
        throw InputError("seam-matched options: slack > 0, bending > 0, max_iterations > 0");
    return MatchedEnvelope(envelope, fabric, options).flatten();
}

}  // namespace ripstop
