#include "ripstop/energy/spring_network.h"

#include <algorithm>
#include <cmath>

#include "ripstop/geometry/triangle.h"
#include "ripstop/mesh/adjacency.h"
#include "ripstop/tile/targets.h"

namespace ripstop {
namespace {

constexpr double guarded_share = 0.3;  ///< fraction of its area below which a triangle is pushed open

/// The unit direction of half-edge k of triangle t in the frame of `warp_in_triangles`.
Vec2 edge_direction(const Tile& tile, int t, int k) {
    const Mat22 flat = lay_flat(tile.mesh.corner(t, 0), tile.mesh.corner(t, 1), tile.mesh.corner(t, 2));
    return triangle_edge(flat, k).normalized();
}

/// cos^2 of the angle between an edge and the warp; one half if the warp is normal to the triangle.
double warp_share(const Vec2& edge, const Vec2& warp) {
    if (warp.isZero()) return 0.5;
    const double cosine = edge.dot(warp);
    return cosine * cosine;
}

double add_guards(const SpringNetwork& network, const Points2& positions, Points2& forces) {
    double sum = 0;
    const double* x = positions.data();
    double* f = forces.data();
    for (Eigen::Index t = 0; t < network.triangles.rows(); ++t) {
        const int a = 2 * network.triangles(t, 0), b = 2 * network.triangles(t, 1), c = 2 * network.triangles(t, 2);
        const double bx = x[b] - x[a], by = x[b + 1] - x[a + 1];
        const double cx = x[c] - x[a], cy = x[c + 1] - x[a + 1];
        const double missing = guarded_share - 0.5 * (bx * cy - by * cx) / network.rest_area[t];
        if (missing <= 0) continue;
        sum += 0.5 * network.guard_stiffness[t] * missing * missing;
        const double push = 0.5 * network.guard_stiffness[t] * missing / network.rest_area[t];
        const double fbx = push * cy, fby = -push * cx, fcx = -push * by, fcy = push * bx;
        f[b] += fbx;
        f[b + 1] += fby;
        f[c] += fcx;
        f[c + 1] += fcy;
        f[a] -= fbx + fcx;
        f[a + 1] -= fby + fcy;
    }
    return sum;
}

/// Twice the sum of the spring stiffnesses at each particle (#V): an upper bound on its squared frequency times its
/// mass.
Eigen::VectorXd stiffness_at_particles(const SpringNetwork& network) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(network.mass.size());
    for (const Spring& spring : network.springs) {
        sum[spring.a] += 2 * spring.stiffness;
        sum[spring.b] += 2 * spring.stiffness;
    }
    return sum;
}

void slow_down_the_fastest(SpringNetwork& network) {
    const Eigen::VectorXd stiffness = stiffness_at_particles(network);
    Eigen::VectorXd squared_frequency = stiffness.cwiseQuotient(network.mass);
    const auto middle = squared_frequency.begin() + squared_frequency.size() / 2;
    std::nth_element(squared_frequency.begin(), middle, squared_frequency.end());
    network.mass = network.mass.cwiseMax(stiffness / *middle);
}

}  // namespace

SpringNetwork make_spring_network(const Tile& tile, const Fabric& fabric) {
    const TriangleMesh& mesh = tile.mesh;
    const Adjacency adjacency(mesh.triangles, mesh.vertex_count());
    const Eigen::Matrix2Xd warp = warp_in_triangles(tile);
    SpringNetwork network;
    network.triangles = mesh.triangles;
    network.rest_area = triangle_areas(mesh);
    // Ten times the energy of cloth stretched to twice its length: enough to hold a triangle open, but not so stiff
    // that it reduces the time step.
    network.guard_stiffness = 10 * std::max(fabric.warp_stiffness, fabric.weft_stiffness) * network.rest_area;
    network.mass = Eigen::VectorXd::Zero(mesh.vertex_count());
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k) network.mass[mesh.triangles(t, k)] += fabric.mass * network.rest_area[t] / 3;
    for (const int edge : adjacency.edges()) {
        Spring spring{adjacency.from(edge), adjacency.to(edge), 0, 0};
        spring.rest = (mesh.positions.row(spring.b) - mesh.positions.row(spring.a)).norm();
        for (const int h : {edge, adjacency.twin(edge)}) {
            if (h < 0) continue;
            const int t = Adjacency::triangle(h);
            const double share = warp_share(edge_direction(tile, t, h % 3), warp.col(t));
            spring.stiffness += network.rest_area[t] *
                                (fabric.warp_stiffness * share + fabric.weft_stiffness * (1 - share)) /
                                (spring.rest * spring.rest);
        }
        network.springs.push_back(spring);
    }
    slow_down_the_fastest(network);
    return network;
}

double energy_and_forces(const SpringNetwork& network, const Points2& positions, const Points2& velocities, double tau,
                         Points2& forces) {
    forces.setZero(positions.rows(), 2);
    const double* x = positions.data();
    const double* v = velocities.data();
    double* f = forces.data();
    double sum = 0;
    for (const Spring& spring : network.springs) {
        const int a = 2 * spring.a, b = 2 * spring.b;
        const double dx = x[b] - x[a], dy = x[b + 1] - x[a + 1];
        const double length = std::sqrt(dx * dx + dy * dy);
        const double excess = length - spring.rest;
        sum += 0.5 * spring.stiffness * excess * excess;
        if (length == 0) continue;
        const double closing = ((v[b] - v[a]) * dx + (v[b + 1] - v[a + 1]) * dy) / length;
        const double pull = spring.stiffness * (excess + tau * closing) / length;
        f[a] += pull * dx;
        f[a + 1] += pull * dy;
        f[b] -= pull * dx;
        f[b + 1] -= pull * dy;
    }
    return sum + add_guards(network, positions, forces);
}

double energy(const SpringNetwork& network, const Points2& positions) {
    Points2 forces;
    return energy_and_forces(network, positions, Points2::Zero(positions.rows(), 2), 0, forces);
}

double frequency_bound(const SpringNetwork& network) {
    return std::sqrt(stiffness_at_particles(network).cwiseQuotient(network.mass).maxCoeff());
}

Eigen::Matrix3d implied_elasticity(const SpringNetwork& network, const Tile& tile) {
    const Adjacency adjacency(tile.mesh.triangles, tile.mesh.vertex_count());
    const Eigen::Matrix2Xd warp = warp_in_triangles(tile);
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (std::size_t s = 0; s < network.springs.size(); ++s) {
        const Spring& spring = network.springs[s];
        const int edge = adjacency.edges()[s];
        const int t = Adjacency::triangle(edge);
        if (warp.col(t).isZero()) continue;
        const Vec2 direction = edge_direction(tile, t, edge % 3);
        const double cosine = direction.dot(warp.col(t));
        const double sine = cross(warp.col(t), direction);
        const Vec3 m(cosine * cosine, sine * sine, cosine * sine);
        sum += spring.stiffness * spring.rest * spring.rest * m * m.transpose();
    }
    return sum / network.rest_area.sum();
}

}  // namespace ripstop
