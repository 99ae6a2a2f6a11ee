#include "ripstop/flatten/map/dirichlet.h"

#include <array>
#include <cmath>
#include <limits>

#include "ripstop/base/error.h"
#include "ripstop/base/index.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/energy/symmetric_dirichlet.h"
#include "ripstop/flatten/map/tutte.h"
#include "ripstop/flatten/tools/finish.h"
#include "ripstop/flatten/tools/step_filter.h"
#include "ripstop/geometry/triangle.h"
#include "ripstop/numeric/symmetric_solver.h"

namespace ripstop {
namespace {

using Vector = Eigen::VectorXd;

class DirichletProblem {
  public:
    explicit DirichletProblem(const TriangleMesh& mesh)
        : mesh_(mesh), pattern_(2 * mesh.vertex_count(), couplings(mesh)), solver_(pattern_) {
        for (int t = 0; t < mesh.triangle_count(); ++t)
            rest_.push_back(lay_flat(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)));
    }

    double energy(const Vector& u) const {
        double sum = 0;
        for (int t = 0; t < mesh_.triangle_count() && std::isfinite(sum); ++t)
            sum += symmetric_dirichlet_energy(rest_[at(t)], flat(u, t));
        return sum;
    }

    /// Energy and gradient at u, and the Newton step from there. Returns false if the Hessian is not positive
    /// definite.
    bool newton_step(const Vector& u, Curvature curvature, double& energy, Vector& gradient, Vector& step);

    int factorizations() const { return solver_.factorizations(); }

  private:
    static Couplings couplings(const TriangleMesh& mesh) {
        Couplings couplings;
        for (int t = 0; t < mesh.triangle_count(); ++t) couplings.add_element(unknowns(mesh, t));
        return couplings;
    }
    static std::array<int, 6> unknowns(const TriangleMesh& mesh, int t) {
        const int a = 2 * mesh.triangles(t, 0), b = 2 * mesh.triangles(t, 1), c = 2 * mesh.triangles(t, 2);
        return {a, a + 1, b, b + 1, c, c + 1};
    }
    Mat22 flat(const Vector& u, int t) const {
        Mat22 edges;
        for (int k = 0; k < 2; ++k)
            edges.col(k) = u.segment<2>(2 * mesh_.triangles(t, k + 1)) - u.segment<2>(2 * mesh_.triangles(t, 0));
        return edges;
    }
    void hold_still(const Vector& u, Vector& values) const;

    const TriangleMesh& mesh_;
    std::vector<Mat22> rest_;
    SparsePattern pattern_;
    SymmetricSolver solver_;
};

/// Fixes three unknowns, which only removes translation and rotation: the energy does not depend on them.
void DirichletProblem::hold_still(const Vector& u, Vector& values) const {
    double sum = 0;
    for (int i = 0; i < pattern_.size(); ++i) sum += values[pattern_.diagonal_slot(i)];
    int farthest = 0;
    for (int v = 1; v < mesh_.vertex_count(); ++v)
        if ((u.segment<2>(2 * v) - u.head<2>()).norm() > (u.segment<2>(2 * farthest) - u.head<2>()).norm())
            farthest = v;
    const Vec2 arm = u.segment<2>(2 * farthest) - u.head<2>();
    for (const int i : {0, 1, 2 * farthest + (std::abs(arm.x()) > std::abs(arm.y()) ? 1 : 0)})
        values[pattern_.diagonal_slot(i)] += sum / pattern_.size();
}

bool DirichletProblem::newton_step(const Vector& u, Curvature curvature, double& energy, Vector& gradient,
                                   Vector& step) {
    Vector values = Vector::Zero(pattern_.entry_count());
    gradient.setZero(u.size());
    energy = 0;
    for (int t = 0; t < mesh_.triangle_count(); ++t) {
        const MembraneElement element = symmetric_dirichlet(rest_[at(t)], flat(u, t), curvature);
        const auto slots = pattern_.slots(t);
        const auto corners = unknowns(mesh_, t);
        energy += element.energy;
        std::size_t entry = 0;
        for (int i = 0; i < 6; ++i) {
            gradient[corners[at(i)]] += element.gradient[i];
            for (int j = 0; j <= i; ++j) values[slots[entry++]] += element.hessian(i, j);
        }
    }
    hold_still(u, values);
    if (!solver_.factorize(values) || solver_.inertia().negative > 0) return false;
    step = -solver_.solve(gradient);
    return step.allFinite();
}

}  // namespace

Flattening flatten_dirichlet(const Tile& tile, const DirichletOptions& options) {
    if (options.max_iterations < 0 || !(options.tolerance > 0))
        throw InputError("symmetric Dirichlet flattening: max_iterations is " + std::to_string(options.max_iterations) +
                         " and tolerance " + format_shortest(options.tolerance) +
                         ", expected at least 0 and a positive number");
    Flattening flat = flatten_tutte(tile);
    if (!flat.summary.usable()) return flat;
    const int spent = flat.summary.factorizations;
    DirichletProblem problem(tile.mesh);
    Vector u = flat.positions.reshaped<Eigen::RowMajor>();
    const double scale = surface_area(tile.mesh);
    flat.summary.iterations = 0;
    Termination termination = Termination::iteration_limit;
    std::string reason = "vertices still move";
    if (!std::isfinite(problem.energy(u))) {
        finish(tile, flat, Termination::stagnated, "Tutte's embedding, because rounding flipped triangles in it");
        return flat;
    }
    Vector gradient, step;
    bool whole = false;  // once a full step succeeds, clamping would only slow convergence
    for (double energy = 0; flat.summary.iterations < options.max_iterations; ++flat.summary.iterations) {
        if (!(whole && problem.newton_step(u, Curvature::exact, energy, gradient, step)) &&
            !problem.newton_step(u, Curvature::semidefinite, energy, gradient, step)) {
            termination = Termination::stagnated;
            reason = "the Newton system is singular";
            break;
        }
        if (step.lpNorm<Eigen::Infinity>() <= options.tolerance * std::sqrt(scale)) {
            u += step * std::min(1.0, longest_step(tile.mesh.triangles, u, step));
            termination = Termination::converged;
            reason = "no vertex moves any more";
            break;
        }
        double length = std::min(1.0, longest_step(tile.mesh.triangles, u, step));
        const double slope = gradient.dot(step);
        const double noise = 1e-14 * (energy + 1e-8 * scale);
        int halvings = 0;
        while (!(problem.energy(u + length * step) <= energy + 1e-4 * length * slope + noise) && ++halvings < 40)
            length *= 0.5;
        if (halvings == 40) {
            termination = Termination::stagnated;
            reason = "no step lowers the energy at working precision";
            break;
        }
        u += length * step;
        whole = length == 1;
    }
    flat.positions = u.reshaped<Eigen::RowMajor>(tile.mesh.vertex_count(), 2);
    flat.summary.factorizations = spent + problem.factorizations();
    finish(tile, flat, termination, reason);
    return flat;
}

}  // namespace ripstop
