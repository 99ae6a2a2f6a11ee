#include "ripstop/flatten/seam/seam_tile.h"

#include <limits>
#include <utility>

#include "ripstop/flatten/map/boundary_first.h"
#include "ripstop/mesh/boundary.h"

namespace ripstop {
namespace {

using Vector = Eigen::VectorXd;

constexpr double surface_bending = 1e-5;  // while the edges are free, in A^1.5 E: as in seam-exact flattening
constexpr int attempt_iterations = 20;    // from a start that is correct to second order
constexpr double loose_force = 1e-6;      // tight, because the cut line bends about the free shape

}  // namespace

SeamTile::SeamTile(const Tile& tile, const Fabric& fabric, const TileStretch& stretch, double bending)
    : tile_(tile), stretch_(stretch), problem_(tile, fabric, {.bending = surface_bending}), newton_(problem_) {
    target_ = problem_.lengths();
    force_scale_ = problem_.stiffness() * target_.mean();
    loose_ = counted(
        newton_.minimize(seam_start(tile, SeamStart::arap), {.hold_edges = false, .force_tolerance = loose_force}));
    free_stretch_ = problem_.flat_lengths(loose_.u).cwiseQuotient(target_).array() - 1;
    stiffen_seams(bending);
}

/// Lets the seams bend about their free shape; edges that keep their length bend as in seam-exact flattening.
void SeamTile::stiffen_seams(double bending) {
    const Eigen::Index count = target_.size();
    Vector stiffness = Vector::Constant(count, surface_bending);
    Vector reference = surface_turning(tile_.mesh, tile_.boundary);
    const Vector free_turning = problem_.flat_turning(loose_.u);
    const Vector sewn = stretch_.reach.rowwise().sum();
    for (Eigen::Index i = 0; i < count; ++i) {
        if (sewn[i] == 0 || sewn[(i + count - 1) % count] == 0) continue;
        stiffness[i] = bending;
        reference[i] = free_turning[i];
    }
    problem_.set_bending(stiffness, reference);
}

SeamSolution SeamTile::counted(SeamSolution solution) {
    factorizations_ += solution.summary.factorizations;
    return solution;
}

bool SeamTile::hold(const Vector& h) {
    lengths_ = target_ + stretch_.reach * h;
    problem_.set_lengths(lengths_);
    held_ = counted(hold_lengths(problem_, newton_, loose_.u));
    const auto rests = [](const SeamSolution& at) { return at.summary.termination == Termination::converged; };
    if (rests(held_) && held_.strict_minimum) return true;
    // if the lengths are closer to the drawn ones than to the free ones, this start is better
    const Flattening drawn = flatten_boundary_first(tile_);
    if (drawn.summary.usable()) {
        SeamSolution other =
            counted(newton_.minimize(Eigen::Map<const Vector>(drawn.positions.data(), drawn.positions.size())));
        if (rests(other) && other.strict_minimum) held_ = std::move(other);
    }
    return rests(held_);
}

Vector SeamTile::gradient() const {
    return -stretch_.reach.transpose() * held_.lambda;
}

Eigen::MatrixXd SeamTile::linearize() {
    problem_.set_lengths(lengths_);
    system_ = newton_.system_at(held_);
    ++factorizations_;
    exact_ = system_ && system_->exact();
    // No factorisation (not seen on any tile so far): edges as stiff as the cloth still give a descent direction.
    Eigen::MatrixXd stiffness =
        system_ ? system_->edge_stiffness()
                : Eigen::MatrixXd(problem_.stiffness() * Eigen::MatrixXd::Identity(lengths_.size(), lengths_.size()));
    stiffness.diagonal() -= held_.lambda.cwiseQuotient(lengths_);
    return stretch_.reach.transpose() * stiffness * stretch_.reach;
}

void SeamTile::aim(const Vector& change) {
    length_change_ = stretch_.reach * change;
    course_ = {Vector::Zero(problem_.unknowns()), Vector::Zero(problem_.edge_count()),
               Vector::Zero(problem_.dense_count())};
    if (!system_) return;
    course_ = system_->correction(course_.d, -length_change_, course_.mu);
    course_.lambda += held_.lambda.cwiseQuotient(lengths_).cwiseProduct(length_change_);
}

double SeamTile::attempt(double share) {
    problem_.set_lengths(lengths_ + share * length_change_);
    tried_ = held_;
    tried_.u += share * course_.d;
    tried_.lambda += share * course_.lambda;
    tried_.mu += share * course_.mu;
    tried_ = counted(newton_.minimize(tried_, {.go_on = system_ != nullptr, .max_iterations = attempt_iterations}));
    return tried_.summary.termination == Termination::converged ? tried_.energy
                                                                : std::numeric_limits<double>::infinity();
}

void SeamTile::accept() {
    held_ = tried_;
    lengths_ = problem_.lengths();
}

}  // namespace ripstop
