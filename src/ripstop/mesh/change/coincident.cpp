#include "ripstop/mesh/change/coincident.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "ripstop/base/index.h"

namespace ripstop {
namespace {

constexpr int none = -1;

/// The mesh with vertex v renumbered as `number[v]`. If several vertices get the same number, the first gives its
/// position. Requires that these first vertices are numbered in increasing order.
TriangleMesh renumbered(const TriangleMesh& mesh, const std::vector<int>& number, int count) {
    TriangleMesh result{Points3(count, 3), mesh.triangles};
    for (int v = mesh.vertex_count() - 1; v >= 0; --v)
        if (const int to = number[at(v)]; to != none) result.positions.row(to) = mesh.positions.row(v);
    for (int& v : result.triangles.reshaped<Eigen::RowMajor>()) v = number[at(v)];
    return result;
}

}  // namespace

std::vector<int> first_in_place(const Points3& points) {
    std::vector<int> order(static_cast<std::size_t>(points.rows()));
    std::iota(order.begin(), order.end(), 0);
    const auto row = [&points](int v) { return points.data() + 3 * v; };
    std::sort(order.begin(), order.end(), [&row](int a, int b) {
        for (int k = 0; k < 3; ++k)
            if (row(a)[k] != row(b)[k]) return row(a)[k] < row(b)[k];
        return a < b;
    });
    std::vector<int> first(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && std::equal(row(order[i]), row(order[i]) + 3, row(order[i - 1]));
        first[at(order[i])] = same ? first[at(order[i - 1])] : order[i];
    }
    return first;
}

TriangleMesh join_coincident(const TriangleMesh& mesh) {
    const std::vector<int> first = first_in_place(mesh.positions);
    std::vector<int> number(first.size());
    int count = 0;
    for (std::size_t v = 0; v < first.size(); ++v) {
        const auto kept = static_cast<std::size_t>(first[v]);
        number[v] = kept == v ? count++ : number[kept];
    }
    return renumbered(mesh, number, count);
}

TriangleMesh drop_unused(const TriangleMesh& mesh) {
    std::vector<int> number(static_cast<std::size_t>(mesh.vertex_count()), none);
    for (const int v : mesh.triangles.reshaped<Eigen::RowMajor>()) number[at(v)] = 0;
    int count = 0;
    for (int& to : number)
        if (to != none) to = count++;
    return renumbered(mesh, number, count);
}

}  // namespace ripstop
