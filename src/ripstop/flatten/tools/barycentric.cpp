#include "ripstop/flatten/tools/barycentric.h"

#include <algorithm>
#include <array>

#include "ripstop/base/index.h"
#include "ripstop/numeric/symmetric_solver.h"

namespace ripstop {

bool place_inside(const Adjacency& adjacency, const std::vector<int>& boundary, const Eigen::VectorXd& weights,
                  Points2& positions) {
    std::vector<int> unknown(static_cast<std::size_t>(adjacency.vertex_count()), 0);
    for (const int v : boundary) unknown[at(v)] = -1;
    int size = 0;
    for (int& u : unknown)
        if (u == 0) u = size++;
    if (size == 0) return true;
    Couplings couplings;
    std::vector<std::array<int, 3>> inner;  // the unknowns of an edge (-1 at the boundary) and its number
    for (std::size_t e = 0; e < adjacency.edges().size(); ++e) {
        const int h = adjacency.edges()[e];
        const int a = unknown[at(adjacency.from(h))];
        const int b = unknown[at(adjacency.to(h))];
        if (a < 0 && b < 0) continue;
        if (a < 0 || b < 0)
            couplings.add_element(std::array{std::max(a, b)});
        else
            couplings.add_element(std::array{a, b});
        inner.push_back({a, b, static_cast<int>(e)});
    }
    const SparsePattern pattern(size, couplings);
    Eigen::VectorXd values = Eigen::VectorXd::Zero(pattern.entry_count());
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(size, 2);
    for (std::size_t g = 0; g < inner.size(); ++g) {
        const auto [a, b, e] = inner[g];
        const auto slots = pattern.slots(static_cast<int>(g));
        const int h = adjacency.edges()[at(e)];
        for (const int slot : slots) values[slot] += weights[e];
        if (a >= 0 && b >= 0)
            values[slots[1]] -= 2 * weights[e];
        else
            right.row(std::max(a, b)) += weights[e] * positions.row(a < 0 ? adjacency.from(h) : adjacency.to(h));
    }
    SymmetricSolver solver(pattern);
    const bool solved = solver.factorize(values);
    if (!solved) return false;
    const Eigen::MatrixXd x = solver.solve_columns(right);
    for (std::size_t v = 0; v < unknown.size(); ++v)
        if (unknown[v] >= 0) positions.row(static_cast<Eigen::Index>(v)) = x.row(unknown[v]);
    return true;
}

}  // namespace ripstop
