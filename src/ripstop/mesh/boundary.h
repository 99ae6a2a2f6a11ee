#pragma once

#include <vector>

#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// The edge lengths of a chain or loop [m], on the surface and on the cloth.
Eigen::VectorXd edge_lengths(const Points3& positions, const std::vector<int>& vertices);
Eigen::VectorXd edge_lengths(const Points2& positions, const std::vector<int>& vertices);

/// The loop with its first vertex repeated at the end.
std::vector<int> closed(std::vector<int> loop);

/// The geodesic turning angle at each boundary vertex: pi minus the sum of the triangle angles there [rad]. Positive
/// turns left.
Eigen::VectorXd surface_turning(const TriangleMesh& mesh, const std::vector<int>& boundary);

}  // namespace ripstop
