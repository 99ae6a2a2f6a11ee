#include "ripstop/flatten/spring/energy_release.h"

#include <algorithm>
#include <cmath>

#include "ripstop/base/error.h"
#include "ripstop/base/index.h"
#include "ripstop/flatten/tools/finish.h"
#include "ripstop/flatten/tools/laying.h"
#include "ripstop/geometry/triangle.h"

namespace ripstop {
namespace {

constexpr double stiffness = 0.5;  ///< C: only determines the unit of time

void require_valid(const EnergyReleaseOptions& options) {
    if (!(options.accuracy > 0) || !(options.energy_tolerance > 0) || options.max_steps < 0 ||
        options.max_steps_laying < 0 || !(options.step > 0 && options.step < 1.4) ||
        !(options.penalty_below >= 0 && options.penalty_below <= 1))
        throw InputError(
            "energy release options: accuracy > 0, energy_tolerance > 0, steps >= 0, step in (0, 1.4), "
            "penalty_below in [0, 1]");
}

enum class Ending { accurate, at_rest, step_limit };

/// The triangles laid so far, with their springs.
class LaidSystem {
  public:
    LaidSystem(const TriangleMesh& mesh, const Adjacency& adjacency, const EnergyReleaseOptions& options);

    void lay(const LayingStep& step);
    Ending release(int max_steps);

    Points2 positions;
    int steps = 0;

  private:
    struct Spring {
        int a, b;
        double rest;
    };
    void add_spring(int a, int b) {
        springs_.push_back({a, b, (mesh_.positions.row(a) - mesh_.positions.row(b)).norm()});
    }
    bool is_laid(int vertex) const { return laid_[at(vertex)]; }
    bool accurate() const;
    double forces(Points2& force) const;
    void push_open();

    const TriangleMesh& mesh_;
    const Adjacency& adjacency_;
    const EnergyReleaseOptions& options_;
    Eigen::VectorXd drawn_area_;
    Eigen::VectorXd inverse_mass_;
    double time_step_ = 0;
    std::vector<bool> laid_;
    std::vector<bool> triangle_laid_;
    std::vector<int> triangles_;
    std::vector<int> vertices_;
    std::vector<Spring> springs_;
    Points2 velocity_, force_;
};

LaidSystem::LaidSystem(const TriangleMesh& mesh, const Adjacency& adjacency, const EnergyReleaseOptions& options)
    : positions(Points2::Zero(mesh.vertex_count(), 2)),
      mesh_(mesh),
      adjacency_(adjacency),
      options_(options),
      drawn_area_(triangle_areas(mesh)),
      laid_(static_cast<std::size_t>(mesh.vertex_count()), false),
      triangle_laid_(static_cast<std::size_t>(mesh.triangle_count()), false),
      velocity_(Points2::Zero(mesh.vertex_count(), 2)),
      force_(Points2::Zero(mesh.vertex_count(), 2)) {
    Eigen::VectorXd mass = Eigen::VectorXd::Zero(mesh.vertex_count());
    Eigen::VectorXd valence = Eigen::VectorXd::Zero(mesh.vertex_count());
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k) mass[mesh.triangles(t, k)] += drawn_area_[t];
    for (const int h : adjacency.edges()) {
        valence[adjacency.from(h)] += 1;
        valence[adjacency.to(h)] += 1;
    }
    mass /= mass.minCoeff();
    inverse_mass_ = mass.cwiseInverse();
    time_step_ = options.step / std::sqrt(2 * stiffness * valence.cwiseProduct(inverse_mass_).maxCoeff());
}

void LaidSystem::lay(const LayingStep& step) {
    const int t = step.triangle;
    if (triangles_.empty()) {
        lay_first(mesh_, t, positions);
    } else {
        const int v = mesh_.triangles(t, step.corner);
        const Vec2 candidate = laid_on(mesh_, positions, t, step.corner);
        if (is_laid(v))
            positions.row(v) = 0.5 * (positions.row(v) + candidate.transpose());
        else
            positions.row(v) = candidate.transpose();
    }
    for (int k = 0; k < 3; ++k) {
        const int twin = adjacency_.twin(3 * t + k);
        if (twin < 0 || !triangle_laid_[at(twin / 3)])
            add_spring(mesh_.triangles(t, k), mesh_.triangles(t, (k + 1) % 3));
        const int v = mesh_.triangles(t, k);
        if (!is_laid(v)) vertices_.push_back(v);
        laid_[at(v)] = true;
    }
    triangles_.push_back(t);
    triangle_laid_[at(t)] = true;
}

/// Whether E_S and E_C of the laid triangles are within the tolerance.
bool LaidSystem::accurate() const {
    double area = 0, missing_area = 0, length = 0, missing_length = 0;
    for (const int t : triangles_) {
        const double drawn = drawn_area_[t];
        area += drawn;
        missing_area +=
            std::abs(drawn - signed_area(positions.row(mesh_.triangles(t, 0)), positions.row(mesh_.triangles(t, 1)),
                                         positions.row(mesh_.triangles(t, 2))));
    }
    for (const Spring& spring : springs_) {
        length += spring.rest;
        missing_length += std::abs(spring.rest - (positions.row(spring.a) - positions.row(spring.b)).norm());
    }
    return missing_area <= options_.accuracy * area && missing_length <= options_.accuracy * length;
}

double LaidSystem::forces(Points2& force) const {
    for (const int v : vertices_) force.row(v).setZero();
    double energy = 0;
    for (const Spring& spring : springs_) {
        const Eigen::RowVector2d ray = positions.row(spring.b) - positions.row(spring.a);
        const double length = ray.norm();
        const double excess = length - spring.rest;
        energy += 0.5 * stiffness * excess * excess;
        if (length == 0) continue;
        force.row(spring.a) += stiffness * excess / length * ray;
        force.row(spring.b) -= stiffness * excess / length * ray;
    }
    return energy;
}

/// Moves corners of low or flipped triangles away from the opposite edge.
void LaidSystem::push_open() {
    for (const int t : triangles_) {
        const double area = signed_area(positions.row(mesh_.triangles(t, 0)), positions.row(mesh_.triangles(t, 1)),
                                        positions.row(mesh_.triangles(t, 2)));
        const double least = options_.penalty_below * drawn_area_[t];
        if (area >= least) continue;
        for (int k = 0; k < 3; ++k) {
            const Eigen::RowVector2d a = positions.row(mesh_.triangles(t, (k + 1) % 3));
            const Eigen::RowVector2d edge = positions.row(mesh_.triangles(t, (k + 2) % 3)) - a;
            // scaled with the edge's drawn length, so that a short edge does not send its corner far away
            const double drawn = (mesh_.corner(t, (k + 1) % 3) - mesh_.corner(t, (k + 2) % 3)).norm();
            if (edge.norm() == 0) continue;
            const Eigen::RowVector2d up = Eigen::RowVector2d(-edge.y(), edge.x()).normalized();
            positions.row(mesh_.triangles(t, k)) += 2 * (least - area) / (3 * std::max(drawn, edge.norm())) * up;
        }
    }
}

Ending LaidSystem::release(int max_steps) {
    if (accurate()) return Ending::accurate;
    for (const int v : vertices_) velocity_.row(v).setZero();
    double energy = forces(force_);
    double swing_start = energy;
    double longest = 0;
    for (const Spring& spring : springs_) longest = std::max(longest, spring.rest);
    for (int step = 0; step < max_steps; ++step) {
        ++steps;
        for (const int v : vertices_) {
            const Eigen::RowVector2d a = inverse_mass_[v] * force_.row(v);
            velocity_.row(v) += time_step_ * a;
            const Eigen::RowVector2d move = time_step_ * velocity_.row(v) + 0.5 * time_step_ * time_step_ * a;
            positions.row(v) += move * std::min(1.0, longest / std::max(move.norm(), 1e-300));
        }
        push_open();
        const double before = energy;
        energy = forces(force_);
        if (energy > before) {  // end of a swing
            if (swing_start - energy <= options_.energy_tolerance * swing_start) return Ending::at_rest;
            swing_start = energy;
            for (const int v : vertices_) velocity_.row(v).setZero();
        }
        if (accurate()) return Ending::accurate;
    }
    return Ending::step_limit;
}

}  // namespace

Flattening flatten_energy_release(const Tile& tile, const EnergyReleaseOptions& options) {
    require_valid(options);
    const Adjacency adjacency(tile.mesh.triangles, tile.mesh.vertex_count());
    LaidSystem system(tile.mesh, adjacency, options);
    constexpr std::size_t always = 200;
    std::size_t count = 0, due = 0;
    for (const LayingStep& step : laying_order(adjacency, middle_triangle(tile.mesh))) {
        system.lay(step);
        if (++count < due) continue;
        system.release(options.max_steps_laying);
        due = count + std::max<std::size_t>(1, count / always);
    }
    const int laying = system.steps;
    const Ending ending = system.release(options.max_steps);
    Flattening flat;
    flat.positions = std::move(system.positions);
    flat.summary.iterations = system.steps;
    const std::string spent =
        std::to_string(laying) + " steps while laying, " + std::to_string(system.steps - laying) + " of the whole tile";
    if (ending == Ending::step_limit)
        finish(tile, flat, Termination::iteration_limit, "the energy was still falling: " + spent);
    else
        finish(tile, flat, Termination::converged,
               (ending == Ending::accurate ? "area and edges within the accuracy: " : "energy at rest: ") + spent);
    return flat;
}

}  // namespace ripstop
