#include "ripstop/flatten/spring/mccartney.h"

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <limits>

#include "ripstop/base/error.h"
#include "ripstop/base/index.h"
#include "ripstop/energy/deformation.h"
#include "ripstop/flatten/tools/finish.h"
#include "ripstop/flatten/tools/grain.h"
#include "ripstop/flatten/tools/laying.h"
#include "ripstop/geometry/triangle.h"

namespace ripstop {
namespace {

void require_valid(const McCartneyOptions& options) {
    if (!(options.last_move > 0) || !(options.first_move >= options.last_move) || !std::isfinite(options.first_move) ||
        options.max_sweeps < 0)
        throw InputError("McCartney's flattening: expected 0 < last_move <= first_move and max_sweeps >= 0");
}

/// Moves single vertices by trial.
class Trials {
  public:
    Trials(const TriangleMesh& mesh, const Adjacency& adjacency, const Fabric& fabric);

    void lay(const LayingStep& step);
    /// Iterates down to the smallest move. Returns false if the sweeps run out.
    bool settle(bool woven, const McCartneyOptions& options);

    Points2 positions;
    int sweeps = 0;

  private:
    struct Edge {
        int other;
        double drawn;
    };
    bool try_moves(int vertex, double move, bool woven);
    double spring_energy(int vertex) const;
    double weave_energy(int vertex) const;
    bool turns_over(int vertex, const Eigen::RowVector2d& to) const;
    bool is_laid(int vertex) const { return laid_[at(vertex)]; }

    const TriangleMesh& mesh_;
    const Fabric& fabric_;
    double mean_edge_ = 0;
    std::vector<TriangleMetric> metrics_;
    std::vector<std::vector<Edge>> edges_;
    std::vector<std::vector<int>> triangles_;  // half-edges that leave each vertex
    std::vector<bool> laid_;
    bool began_ = false;
};

Trials::Trials(const TriangleMesh& mesh, const Adjacency& adjacency, const Fabric& fabric)
    : positions(Points2::Zero(mesh.vertex_count(), 2)),
      mesh_(mesh),
      fabric_(fabric),
      edges_(static_cast<std::size_t>(mesh.vertex_count())),
      laid_(static_cast<std::size_t>(mesh.vertex_count()), false) {
    for (const int h : adjacency.edges()) {
        const int a = adjacency.from(h), b = adjacency.to(h);
        const double drawn = (mesh.positions.row(a) - mesh.positions.row(b)).norm();
        edges_[at(a)].push_back({b, drawn});
        edges_[at(b)].push_back({a, drawn});
        mean_edge_ += drawn / static_cast<double>(adjacency.edges().size());
    }
    for (int v = 0; v < mesh.vertex_count(); ++v) triangles_.push_back(adjacency.outgoing(v));
    for (int t = 0; t < mesh.triangle_count(); ++t)
        metrics_.push_back(triangle_metric(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)));
}

/// The energy of the springs between a vertex and the neighbours that are already laid.
double Trials::spring_energy(int vertex) const {
    double sum = 0;
    for (const Edge& edge : edges_[at(vertex)]) {
        if (!is_laid(edge.other)) continue;
        const double excess = (positions.row(vertex) - positions.row(edge.other)).norm() - edge.drawn;
        sum += 0.5 * excess * excess / edge.drawn;
    }
    return sum;
}

double Trials::weave_energy(int vertex) const {
    double sum = 0;
    for (const int h : triangles_[at(vertex)]) {
        const Mat22 flat = flat_edges(mesh_.triangles, positions, h / 3);
        if (!(flat.determinant() > 0)) return std::numeric_limits<double>::infinity();
        const ThreadStrain strain = thread_strain(metrics_[at(h / 3)], flat);
        sum +=
            0.25 * flat.determinant() *
            (fabric_.warp_stiffness * strain.warp * strain.warp + fabric_.weft_stiffness * strain.weft * strain.weft +
             fabric_.shear_stiffness * strain.shear * strain.shear);
    }
    return sum;
}

bool Trials::turns_over(int vertex, const Eigen::RowVector2d& to) const {
    for (const int h : triangles_[at(vertex)]) {
        const int b = mesh_.triangles(h / 3, (h % 3 + 1) % 3), c = mesh_.triangles(h / 3, (h % 3 + 2) % 3);
        if (!is_laid(b) || !is_laid(c)) continue;
        const double before = signed_area(positions.row(vertex), positions.row(b), positions.row(c));
        const double after = signed_area(to, positions.row(b), positions.row(c));
        if (after <= 0 && after <= before) return true;
    }
    return false;
}

bool Trials::try_moves(int vertex, double move, bool woven) {
    const auto energy = [&] { return woven ? weave_energy(vertex) : spring_energy(vertex); };
    const Eigen::RowVector2d old = positions.row(vertex);
    Eigen::RowVector2d best = old;
    const double before = energy();
    double least = before * (1 - 1e-9);  // an improvement beyond rounding
    for (const auto& [x, y] : {std::array{move, 0.0}, {-move, 0.0}, {0.0, move}, {0.0, -move}}) {
        const Eigen::RowVector2d to = old + Eigen::RowVector2d(x, y);
        if (turns_over(vertex, to)) continue;
        positions.row(vertex) = to;
        const double now = energy();
        positions.row(vertex) = old;
        if (!(now < least)) continue;
        least = now;
        best = to;
    }
    positions.row(vertex) = best;
    return best != old;
}

void Trials::lay(const LayingStep& step) {
    const int t = step.triangle;
    const int v = mesh_.triangles(t, step.corner);
    if (!began_) {
        lay_first(mesh_, t, positions);
        for (int k = 0; k < 3; ++k) laid_[at(mesh_.triangles(t, k))] = true;
        began_ = true;
        return;
    }
    const Eigen::RowVector2d candidate = laid_on(mesh_, positions, t, step.corner).transpose();
    if (!is_laid(v)) {
        positions.row(v) = candidate;
        laid_[at(v)] = true;
        return;
    }
    positions.row(v) = 0.5 * (positions.row(v) + candidate);
    for (const double move : {0.1, 0.03, 0.01, 0.003})
        for (int k = 0; k < 3; ++k) try_moves(mesh_.triangles(t, k), move * mean_edge_, false);
}

bool Trials::settle(bool woven, const McCartneyOptions& options) {
    const int begun = sweeps;
    for (double move = options.first_move; move >= options.last_move; move *= 0.5) {
        std::vector<bool> open(laid_.size(), true);  // vertices worth a trial: they or a neighbour have moved
        bool moved = true;
        while (moved) {
            if (sweeps - begun == options.max_sweeps) return false;
            ++sweeps;
            moved = false;
            for (int v = 0; v < mesh_.vertex_count(); ++v) {
                if (!open[at(v)]) continue;
                open[at(v)] = try_moves(v, move * mean_edge_, woven);
                if (!open[at(v)]) continue;
                moved = true;
                for (const Edge& edge : edges_[at(v)]) open[at(edge.other)] = true;
            }
        }
    }
    return true;
}

}  // namespace

Flattening flatten_mccartney(const Tile& tile, const Fabric& fabric, const McCartneyOptions& options) {
    require_valid(options);
    const Adjacency adjacency(tile.mesh.triangles, tile.mesh.vertex_count());
    Trials trials(tile.mesh, adjacency, fabric);
    for (const LayingStep& step : laying_order(adjacency, middle_triangle(tile.mesh))) trials.lay(step);
    bool at_rest = trials.settle(false, options);
    if (options.woven && trials.positions.allFinite()) {
        align_with_grain(tile, trials.positions);
        at_rest = trials.settle(true, options);
    }
    Flattening flat;
    flat.positions = std::move(trials.positions);
    flat.summary.iterations = trials.sweeps;
    if (at_rest)
        finish(tile, flat, Termination::converged, "no trial move lowers the energy");
    else
        finish(tile, flat, Termination::iteration_limit, "trial moves still lowered the energy");
    return flat;
}

}  // namespace ripstop
