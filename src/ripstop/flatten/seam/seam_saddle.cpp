#include "ripstop/flatten/seam/seam_saddle.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace ripstop {
namespace {

using Vector = Eigen::VectorXd;

constexpr int most_saddles = 5;
constexpr int gradient_iterations = 40;
constexpr double least_fall = 1e-10;  ///< relative to the cloth's stiffness: a curvature closer to zero is rounding
constexpr double first_step = 0.03;   ///< relative to the tile's size, for the vertex that moves most
constexpr int most_halvings = 12;
constexpr int most_mendings = 4;
constexpr double mended = 1e-9;  ///< relative to the lengths: the remaining Newton correction does not raise the energy
                                 ///< again

/// A displacement without symmetry, computed from the vertex positions on the cloth and not from their numbers.
Vector uneven(const SeamProblem& problem, const Vector& u) {
    const Eigen::Map<const Points2> positions(u.data(), u.size() / 2, 2);
    const Eigen::RowVector2d middle = 0.5 * (positions.colwise().minCoeff() + positions.colwise().maxCoeff());
    Points2 v(positions.rows(), 2);
    for (Eigen::Index i = 0; i < v.rows(); ++i) {
        const Eigen::RowVector2d p = (positions.row(i) - middle) / problem.size();
        v.row(i) << std::sin(2 * p.x() + p.y() + 0.5), std::cos(p.x() - 3 * p.y() + 0.3);
    }
    return Eigen::Map<const Vector>(v.data(), v.size());
}

/// The energy's second derivative along directions that keep the edge lengths, and its preconditioner.
class Curvatures {
  public:
    Curvatures(const SeamProblem& problem, const SeamStep& system, const SeamSolution& at)
        : problem_(problem),
          system_(system),
          no_edge_(Vector::Zero(problem.edge_count())),
          no_row_(Vector::Zero(problem.dense_count())) {
        Vector gradient;
        problem.assemble(at.u, at.lambda, at.mu, 0, Curvature::exact, gradient, hessian_);
    }

    Vector times(const Vector& d) const { return product(problem_.pattern(), hessian_, d) / problem_.stiffness(); }
    /// The displacement that a force causes with edges held.
    Vector moved(const Vector& force) const {
        return -system_.correction(problem_.stiffness() * force, no_edge_, no_row_).d;
    }

  private:
    const SeamProblem& problem_;
    const SeamStep& system_;
    Vector no_edge_, no_row_, hessian_;
};

/// A unit direction of negative curvature that keeps the edge lengths: least curvature by a locally optimal gradient
/// iteration, preconditioned with the present factorisation [K01].
std::optional<Vector> falling_direction(const SeamProblem& problem, const SeamStep& system, const SeamSolution& at) {
    const Curvatures curvatures(problem, system, at);
    Eigen::MatrixXd basis(problem.unknowns(), 1);
    basis.col(0) = curvatures.moved(uneven(problem, at.u));
    Vector d = basis.col(0).normalized();
    double curvature = std::numeric_limits<double>::infinity();
    for (int i = 0; i < gradient_iterations; ++i) {
        if (!d.allFinite() || !(d.norm() > 0.5)) return std::nullopt;
        const Vector image = curvatures.times(d);
        const double here = d.dot(image);
        if (here < -least_fall && std::abs(here - curvature) < 0.01 * std::abs(here)) return d;
        curvature = here;
        // Rayleigh-Ritz over d, the preconditioned gradient and the previous direction
        basis.conservativeResize(Eigen::NoChange, std::min<Eigen::Index>(i + 2, 3));
        if (basis.cols() == 3) basis.col(2) = basis.col(0);
        basis.col(0) = d;
        basis.col(1) = curvatures.moved(image - here * d);
        const Eigen::HouseholderQR<Eigen::MatrixXd> qr(basis);
        const Eigen::MatrixXd q = qr.householderQ() * Eigen::MatrixXd::Identity(basis.rows(), basis.cols());
        Eigen::MatrixXd images(q.rows(), q.cols());
        for (Eigen::Index k = 0; k < q.cols(); ++k) images.col(k) = curvatures.times(q.col(k));
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> ritz(q.transpose() * images);
        d = (q * ritz.eigenvectors().col(0)).normalized();
    }
    return curvature < -least_fall ? std::optional(d) : std::nullopt;
}

/// Corrects the positions so that edges, grain and area satisfy their constraints; empty if that flips triangles.
std::optional<Vector> mend(const SeamProblem& problem, const SeamStep& system, Vector u) {
    const Vector no_force = Vector::Zero(problem.unknowns());
    for (int i = 0; i < most_mendings; ++i) {
        const Vector lengths = problem.edge_residual(u), dense = problem.dense_residual(u);
        if (lengths.cwiseQuotient(problem.length_scales()).lpNorm<Eigen::Infinity>() < mended &&
            dense.lpNorm<Eigen::Infinity>() < mended * problem.size())
            return u;
        const Vector step = system.correction(no_force, lengths, dense).d;
        if (problem.longest_step(u, step) < 0.99) return std::nullopt;
        u += step;
    }
    return std::nullopt;
}

/// Leaves the saddle: the longest of several steps that lowers the energy with edges held.
std::optional<Vector> step_down(const SeamProblem& problem, const SeamStep& system, const SeamSolution& at,
                                const Vector& direction) {
    double length = first_step * problem.size() / direction.lpNorm<Eigen::Infinity>();
    for (int halving = 0; halving < most_halvings; ++halving, length *= 0.5) {
        if (problem.longest_step(at.u, length * direction) < 0.99) continue;
        std::optional<Vector> u = mend(problem, system, at.u + length * direction);
        if (u && problem.energy(*u) < at.energy) return u;
    }
    return std::nullopt;
}

}  // namespace

SeamSolution leave_saddles(const SeamProblem& problem, SeamNewton& newton, const SeamSolution& at,
                           const SeamNewtonOptions& options) {
    SeamSolution rest = at;
    for (int i = 0; i < most_saddles; ++i) {
        if (rest.summary.termination != Termination::converged || rest.strict_minimum) break;
        const SeamStep* const system = newton.system_at(rest);
        ++rest.summary.factorizations;
        if (!system) break;
        const std::optional<Vector> direction = falling_direction(problem, *system, rest);
        if (!direction) break;
        const std::optional<Vector> below = step_down(problem, *system, rest, *direction);
        if (!below) break;
        SeamSolution next = rest;
        next.u = *below;
        next = newton.minimize(next, options);
        next.summary.iterations += rest.summary.iterations;
        next.summary.factorizations += rest.summary.factorizations;
        if (next.summary.termination != Termination::converged) {
            rest.summary.iterations = next.summary.iterations;
            rest.summary.factorizations = next.summary.factorizations;
            break;
        }
        rest = std::move(next);
    }
    return rest;
}

}  // namespace ripstop
