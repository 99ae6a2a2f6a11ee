#include "ripstop/tile/targets.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "ripstop/base/index.h"
#include "ripstop/geometry/triangle.h"
#include "ripstop/mesh/adjacency.h"
#include "ripstop/mesh/boundary.h"
#include "ripstop/tile/cloth_warp.h"

namespace ripstop {
namespace {

/// (I + 2 E)^(-1/2): maps the drawn triangle to the cloth that has the strain E (E11, E22, 2 E12) when it is
/// stretched to it.
Mat22 unstretched(const Vec3& strain) {
    Mat22 C;
    C << 1 + 2 * strain[0], strain[2], strain[2], 1 + 2 * strain[1];
    return Eigen::SelfAdjointEigenSolver<Mat22>(C).operatorInverseSqrt();
}

Tile without_strain(Tile tile) {
    tile.compensation.strain.resize(0, 3);
    return tile;
}

}  // namespace

Eigen::Matrix2Xd warp_in_triangles(const Tile& tile) {
    const Points3& field = tile.grain.field;
    return lay_on_cloth(tile.mesh, field.rows() > 0 ? field : Points3(tile.grain.direction.transpose())).along;
}

std::vector<Mat22> target_triangles(const Tile& tile) {
    std::vector<Mat22> targets(static_cast<std::size_t>(tile.mesh.triangle_count()));
    for (int t = 0; t < tile.mesh.triangle_count(); ++t)
        targets[at(t)] = lay_flat(tile.mesh.corner(t, 0), tile.mesh.corner(t, 1), tile.mesh.corner(t, 2));
    const Compensation& given = tile.compensation;
    const bool is_strained = given.strain.rows() > 0;
    if (given.warp == 0 && given.weft == 0 && !is_strained) return targets;
    const Eigen::Matrix2Xd warp = warp_in_triangles(tile);
    for (int t = 0; t < tile.mesh.triangle_count(); ++t) {
        const Vec2 along = warp.col(t), across(-along.y(), along.x());
        Mat22 target = targets[at(t)];
        if (is_strained) {
            Mat22 axes;
            axes << along, across;
            target = axes * unstretched(given.strain.row(t)) * axes.transpose() * target;
        }
        const Mat22 longer =
            Mat22::Identity() + given.warp * along * along.transpose() + given.weft * across * across.transpose();
        targets[at(t)] = longer * target;
    }
    return targets;
}

Eigen::VectorXd drawn_lengths(const Tile& tile) {
    if (tile.curve_lengths.size() > 0) return tile.curve_lengths;
    return edge_lengths(tile.mesh.positions, closed(tile.boundary));
}

Eigen::VectorXd target_lengths(const Tile& tile) {
    Eigen::VectorXd lengths = drawn_lengths(tile);
    if (!tile.compensation.any()) return lengths;
    // If the edges have their own compensation, the triangles contribute only warp and weft.
    const bool is_told = tile.compensation.edges.size() > 0;
    const Eigen::VectorXd chords = edge_lengths(tile.mesh.positions, closed(tile.boundary));
    const std::vector<Mat22> targets = target_triangles(is_told ? without_strain(tile) : tile);
    const Adjacency adjacency(tile.mesh.triangles, tile.mesh.vertex_count());
    Eigen::VectorXd leaving(tile.mesh.vertex_count());  // target length of the boundary edge that starts at each vertex
    for (int h = 0; h < adjacency.half_edge_count(); ++h) {
        if (!adjacency.is_boundary(h)) continue;
        const Mat22& target = targets[static_cast<std::size_t>(Adjacency::triangle(h))];
        leaving[adjacency.from(h)] = triangle_edge(target, h % 3).norm();
    }
    Eigen::Index edge = 0;
    std::vector<double> extra(tile.chains.size(), 0);
    std::copy_n(tile.compensation.chains.begin(), std::min(extra.size(), tile.compensation.chains.size()),
                extra.begin());
    std::vector<Eigen::Index> place(static_cast<std::size_t>(tile.mesh.vertex_count()));
    for (const int v : tile.boundary) place[static_cast<std::size_t>(v)] = edge++;
    for (std::size_t c = 0; c < tile.chains.size(); ++c)
        for (int i = 0; i < tile.chains[c].edge_count(); ++i) {
            const int v = tile.chains[c].vertices[static_cast<std::size_t>(i)];
            const Eigen::Index at = place[static_cast<std::size_t>(v)];
            lengths[at] *= leaving[v] / chords[at] * (1 + extra[c]) * (is_told ? tile.compensation.edges[at] : 1);
        }
    return lengths;
}

}  // namespace ripstop
