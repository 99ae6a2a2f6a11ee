/// Prints the cost of one large tile as Markdown. Seam-exact flattening is compared with its lower bound, one
/// symbolic and one numeric factorisation of the same elastic matrix, with our conformal and as-rigid-as-possible
/// maps, and with CGAL's.
///
///     ripstop-bench-solve [TRIANGLES | NAME]...     default: 3000 10000 100000 and every row
///
/// Each row runs in its own process, so that its peak memory is its own. Seconds are processor time, and the best
/// of several runs if one is short, so they hold on a busy machine.
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <charconv>
#include <cmath>
#include <functional>
#include <numbers>

#include "ripstop/design/natural/gores.h"
#include "ripstop/flatten/map/arap.h"
#include "ripstop/flatten/map/boundary_first.h"
#include "ripstop/flatten/map/lscm.h"
#include "ripstop/flatten/seam/seam_exact.h"
#include "ripstop/flatten/seam/seam_problem.h"
#include "ripstop/io/json/fabric_json.h"
#include "ripstop/numeric/symmetric_solver.h"
#include "ripstop/tile/make_tile.h"
#include "support/shapes.h"
#ifdef RIPSTOP_CGAL
#include "cgal_parameterization.h"
#endif

namespace ripstop {
namespace {

/// The panel at the equator of the 24 x 15 natural design.
Tile panel(int triangles) {
    const EnvelopeDesign design;
    const NaturalShape shape = design_shape(design);
    const double height = shape.length / design.panels;
    const double width = 2 * std::numbers::pi * shape.max_radius / design.gores;
    const int rows = static_cast<int>(std::lround(std::sqrt(triangles / 2 * height / width)));
    const int columns = triangles / (2 * rows);
    double equator = 0;
    while (shape.point_at(equator).theta > 0) equator += 0.01;
    const auto point = [&](double u, double v) {
        return design_point(design, shape.point_at(equator + (v - 0.5) * height), 0, 2 * u - 1);
    };
    return make_tile("panel", testing::grid(columns, rows, point), {.warp = Vec3::UnitZ()});
}

Tile octant(int triangles) {
    return make_tile("octant", testing::octant(static_cast<int>(std::lround(std::sqrt(triangles)))),
                     {.warp = Vec3(-1, 1, 0)});
}

struct Cost {
    double seconds = 0;
    int iterations = 0;
    int factorizations = 0;
    bool good = false;
    double peak = 0;  ///< [MiB]
};

double processor_seconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

/// Repeats `work` for a second, at least once. Returns the best time and the result of the last run.
template <class Work>
Cost best(const Work& work) {
    Cost cost;
    const double begin = processor_seconds();
    for (int run = 0; run < 50 && (run == 0 || processor_seconds() - begin < 1); ++run) {
        const double start = processor_seconds();
        Cost said = work();
        said.seconds = processor_seconds() - start;
        if (run > 0) said.seconds = std::min(said.seconds, cost.seconds);
        cost = said;
    }
    return cost;
}

Cost said(const Flattening& flat) {
    return {0, flat.summary.iterations, flat.summary.factorizations,
            flat.summary.termination == Termination::converged};
}

const Fabric& cloth() {
    static const Fabric fabric = fabric_named("isotropic");
    return fabric;
}

/// Analyses and factorises the elastic matrix with which seam-exact flattening begins.
Cost floor_of(const Tile& tile, SolverKind kind) {
    const SeamProblem problem(tile, cloth(), {.bending = SeamExactOptions{}.bending});
    const Flattening start = flatten_arap(tile, {.max_iterations = 3});
    const Eigen::VectorXd u = Eigen::Map<const Eigen::VectorXd>(start.positions.data(), problem.unknowns());
    Eigen::VectorXd gradient, values;
    problem.assemble(u, Eigen::VectorXd::Zero(problem.edge_count()), Eigen::VectorXd::Zero(1), 0,
                     Curvature::semidefinite, gradient, values);
    for (const int i : {2 * problem.held_vertex(), 2 * problem.held_vertex() + 1, problem.held_turn(u)})
        values[problem.pattern().diagonal_slot(i)] += problem.stiffness();
    return best([&] {
        SymmetricSolver solver(problem.pattern(), kind);
        return Cost{0, 0, 1, solver.factorize(values)};
    });
}

struct Row {
    const char* name;
    std::function<Cost(const Tile&)> run;
};

std::vector<Row> rows() {
    std::vector<Row> result = {
        {"floor", [](const Tile& tile) { return floor_of(tile, SolverKind::automatic); }},
        {"floor-simplicial", [](const Tile& tile) { return floor_of(tile, SolverKind::simplicial); }},
        {"floor-supernodal", [](const Tile& tile) { return floor_of(tile, SolverKind::supernodal); }},
        {"seam-exact", [](const Tile& tile) { return best([&] { return said(flatten_seam_exact(tile, cloth())); }); }},
        {"bff", [](const Tile& tile) { return best([&] { return said(flatten_boundary_first(tile)); }); }},
        {"lscm", [](const Tile& tile) { return best([&] { return said(flatten_lscm(tile)); }); }},
        {"arap", [](const Tile& tile) { return best([&] { return said(flatten_arap(tile)); }); }},
    };
#ifdef RIPSTOP_CGAL
    result.push_back({"cgal-lscm", [](const Tile& tile) {
                          CgalParameterization cgal(tile.mesh);
                          return best([&] { return Cost{0, 0, 0, cgal.lscm()}; });
                      }});
    result.push_back({"cgal-arap", [](const Tile& tile) {
                          CgalParameterization cgal(tile.mesh);
                          return best([&] { return Cost{0, 0, 0, cgal.arap()}; });
                      }});
#endif
    return result;
}

/// The cost of a row on a tile, measured in a child process.
Cost measured(const Row& row, const std::function<Tile()>& tile) {
    int channel[2];
    if (pipe(channel) != 0) return {};
    const pid_t child = fork();
    if (child == 0) {
        Cost cost = row.run(tile());
        rusage usage{};
        getrusage(RUSAGE_SELF, &usage);
        cost.peak = static_cast<double>(usage.ru_maxrss) / 1024;
        _exit(write(channel[1], &cost, sizeof cost) == sizeof cost ? 0 : 1);
    }
    close(channel[1]);
    Cost cost;
    if (read(channel[0], &cost, sizeof cost) != sizeof cost) cost = {};
    close(channel[0]);
    waitpid(child, nullptr, 0);
    return cost;
}

void print_table(const char* shape, const std::function<Tile()>& tile, const std::vector<std::string>& wanted) {
    std::vector<std::pair<Row, Cost>> costs;
    const int triangles = tile().mesh.triangle_count();
    for (const Row& row : rows())
        if (wanted.empty() || std::find(wanted.begin(), wanted.end(), row.name) != wanted.end())
            costs.emplace_back(row, measured(row, tile));
    const auto ratio = [&](const char* to, double seconds) {
        for (const auto& [row, cost] : costs)
            if (row.name == std::string(to) && cost.seconds > 0) return fmt::format("{:.2f}", seconds / cost.seconds);
        return std::string("-");
    };
    for (const auto& [row, cost] : costs)
        fmt::print("| {}, {} | {} | {:.4f} | {} | {} | {} | {} | {:.0f} | {} |\n", shape, triangles, row.name,
                   cost.seconds, ratio("floor", cost.seconds), ratio("cgal-arap", cost.seconds), cost.iterations,
                   cost.factorizations, cost.peak, cost.good ? "yes" : "no");
    std::fflush(stdout);
}

}  // namespace
}  // namespace ripstop

int main(int argc, char** argv) {
    using namespace ripstop;
    std::vector<int> sizes;
    std::vector<std::string> names;
    for (const std::string& argument : std::vector<std::string>(argv + 1, argv + argc)) {
        int size = 0;
        const auto [end, error] = std::from_chars(argument.data(), argument.data() + argument.size(), size);
        if (error == std::errc() && end == argument.data() + argument.size() && size >= 100)
            sizes.push_back(size);
        else
            names.push_back(argument);
    }
    if (sizes.empty()) sizes = {3000, 10'000, 100'000};
    fmt::print(
        "| tile, triangles | what | seconds | of the floor | of CGAL's ARAP | iterations | factorisations | peak "
        "MiB | good |\n|---|---|---|---|---|---|---|---|---|\n");
    for (const int size : sizes) {
        print_table(
            "panel", [size] { return panel(size); }, names);
        print_table(
            "octant", [size] { return octant(size); }, names);
    }
}
