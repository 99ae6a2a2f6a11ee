#include "ripstop/mesh/boundary.h"

#include <algorithm>
#include <numbers>

#include "ripstop/base/index.h"
#include "ripstop/geometry/triangle.h"

namespace ripstop {
namespace {

template <class Points>
Eigen::VectorXd lengths(const Points& positions, const std::vector<int>& vertices) {
    Eigen::VectorXd result(std::max<Eigen::Index>(0, static_cast<Eigen::Index>(vertices.size()) - 1));
    for (Eigen::Index i = 0; i < result.size(); ++i)
        result[i] = (positions.row(vertices[static_cast<std::size_t>(i) + 1]) - positions.row(vertices[at(i)])).norm();
    return result;
}

}  // namespace

std::vector<int> closed(std::vector<int> loop) {
    if (!loop.empty()) loop.push_back(loop.front());
    return loop;
}

Eigen::VectorXd edge_lengths(const Points3& positions, const std::vector<int>& vertices) {
    return lengths(positions, vertices);
}
Eigen::VectorXd edge_lengths(const Points2& positions, const std::vector<int>& vertices) {
    return lengths(positions, vertices);
}

Eigen::VectorXd surface_turning(const TriangleMesh& mesh, const std::vector<int>& boundary) {
    Eigen::VectorXd angle = Eigen::VectorXd::Zero(mesh.vertex_count());
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k)
            angle[mesh.triangles(t, k)] +=
                angle_at(mesh.corner(t, k), mesh.corner(t, (k + 1) % 3), mesh.corner(t, (k + 2) % 3));
    Eigen::VectorXd turning(static_cast<Eigen::Index>(boundary.size()));
    for (Eigen::Index i = 0; i < turning.size(); ++i) turning[i] = std::numbers::pi - angle[boundary[at(i)]];
    return turning;
}

}  // namespace ripstop
