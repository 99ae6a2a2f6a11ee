#include "ripstop/remesh/mesh_state.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "ripstop/base/index.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"
#include "ripstop/geometry/angle.h"
#include "ripstop/geometry/triangle.h"
#include "ripstop/model/tile/corner_turn.h"

namespace ripstop {
namespace {

constexpr double sliver_angle = 5 * degree;
constexpr double many_slivers = 0.1;
constexpr double many_locked = 0.25;
constexpr double interior_limit = 4.7 * degree;
constexpr double turn_wanted = 5 * degree;
constexpr double most = 4000;  // triangles
constexpr int too_many_corners = 50000;
constexpr double far_below = 0.25;  // relative to the needed edge
constexpr double coarse_share = 1.1;
constexpr int most_corners = 6;  // corners that a tile cut along mesh edges may still have
constexpr double least_edges_a_chain = 3.5;

void measure_boundary(const Tile& tile, MeshState& state) {
    for (const Chain& chain : tile.chains) {
        const int count = chain.edge_count();
        const auto edge = [&](int e) {
            return Vec3(tile.mesh.positions.row(chain.vertices[static_cast<std::size_t>(e) + 1]) -
                        tile.mesh.positions.row(chain.vertices[at(e)]));
        };
        double sum = 0, length = 0;
        std::vector<double> turns(static_cast<std::size_t>(count) + 1, 0);
        for (int e = 1; e < count; ++e) {
            const double turn = angle_between(edge(e - 1), edge(e));
            if (turn > corner_turn) continue;
            turns[at(e)] = turn;
            state.turn_max = std::max(state.turn_max, turn);
        }
        for (int e = 0; e < count; ++e) {
            const std::size_t i = static_cast<std::size_t>(e);
            const double at_start = e > 0 ? turns[i] : turns[i + 1], at_end = e + 1 < count ? turns[i + 1] : turns[i];
            const double own = edge(e).norm(), turn = (at_start + at_end) / 2;
            sum += own * turn * turn;
            length += own;
        }
        state.boundary_turn = std::max(state.boundary_turn, std::sqrt(sum / length));
    }
}

void measure_interior(const TriangleMesh& mesh, const Adjacency& adjacency, MeshState& state) {
    double squares = 0, weights = 0, turning = 0, lengths = 0;
    for (const int h : adjacency.edges()) {
        const double length = (mesh.positions.row(adjacency.to(h)) - mesh.positions.row(adjacency.from(h))).norm();
        lengths += length;
        if (adjacency.is_boundary(h)) continue;
        const Vec3 a = area_vector(mesh, Adjacency::triangle(h)),
                   b = area_vector(mesh, Adjacency::triangle(adjacency.twin(h)));
        const double turn = angle_between(a, b);
        if (turn > corner_turn) continue;
        const double weight = a.norm() + b.norm();
        squares += weight * turn * turn;
        weights += weight;
        turning += turn * length;
        state.turn_max = std::max(state.turn_max, turn);
    }
    state.mean_edge = lengths / static_cast<double>(adjacency.edges().size());
    state.interior_turn = weights > 0 ? std::sqrt(squares / weights) : 0;
    state.curvature = turning / state.area;
}

void measure_shapes(const Tile& tile, const Adjacency& adjacency, MeshState& state) {
    const TriangleMesh& mesh = tile.mesh;
    std::vector<bool> outer(static_cast<std::size_t>(mesh.vertex_count()), false);
    for (const int v : tile.boundary) outer[at(v)] = true;
    const auto is_ear = [&](int t) {
        int sides = 0;
        for (int k = 0; k < 3; ++k) sides += adjacency.is_boundary(3 * t + k) ? 1 : 0;
        return sides >= 2;
    };
    int slivers = 0, locked = 0;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        double least = 10;
        for (int k = 0; k < 3; ++k)
            least =
                std::min(least, angle_at(mesh.corner(t, k), mesh.corner(t, (k + 1) % 3), mesh.corner(t, (k + 2) % 3)));
        slivers += least < sliver_angle ? 1 : 0;
    }
    for (const int h : adjacency.edges())
        if (!adjacency.is_boundary(h) && outer[at(adjacency.from(h))] && outer[at(adjacency.to(h))] &&
            !is_ear(Adjacency::triangle(h)) && !is_ear(Adjacency::triangle(adjacency.twin(h))))
            ++locked;
    state.sliver_share = slivers / static_cast<double>(mesh.triangle_count());
    state.locked_share = locked / static_cast<double>(tile.boundary.size());
}

}  // namespace

double edge_of(double area, double triangles) {
    return std::sqrt(area / triangles * 4 / std::sqrt(3.0));
}

bool MeshState::is_flat() const {
    return curvature * std::sqrt(area) < 0.01;
}

bool MeshState::is_jagged() const {
    return chains > most_corners && boundary_edges < least_edges_a_chain * chains;
}

bool MeshState::has_coarse_boundary(double length_tolerance) const {
    return boundary_turn * boundary_turn / 24 > length_tolerance / 2;
}

std::vector<std::array<int, 2>> find_creases(const TriangleMesh& mesh, const Adjacency& adjacency) {
    std::vector<std::array<int, 2>> edges;
    for (const int h : adjacency.edges())
        if (!adjacency.is_boundary(h) &&
            angle_between(area_vector(mesh, Adjacency::triangle(h)),
                          area_vector(mesh, Adjacency::triangle(adjacency.twin(h)))) > corner_turn)
            edges.push_back({adjacency.from(h), adjacency.to(h)});
    return edges;
}

MeshState measure_mesh(const Tile& tile) {
    const Adjacency adjacency(tile.mesh.triangles, tile.mesh.vertex_count());
    MeshState state;
    state.triangles = tile.mesh.triangle_count();
    state.area = surface_area(tile.mesh);
    state.chains = static_cast<int>(tile.chains.size());
    state.boundary_edges = static_cast<int>(tile.boundary.size());
    measure_boundary(tile, state);
    measure_interior(tile.mesh, adjacency, state);
    measure_shapes(tile, adjacency, state);
    return state;
}

double needed_edge(const MeshState& state, double fewest) {
    const double longest = edge_of(state.area, fewest), shortest = edge_of(state.area, most);
    return state.curvature * longest < turn_wanted ? longest : std::max(shortest, turn_wanted / state.curvature);
}

std::string MeshFault::text() const {
    switch (kind) {
        case too_fine:
            return format_fixed(value, 0) + " triangles are more than necessary";
        case turns:
            return "edges turn by up to " + format_fixed(value / degree, 0) + " degrees";
        case slivers:
            return format_fixed(value / percent, 0) + " % of the triangles are slivers";
        case locked:
            return "interior edges join two boundary vertices";
    }
    return {};
}

std::optional<MeshFault> find_fault(const MeshState& state, double length_tolerance, double fewest) {
    const double needed = needed_edge(state, fewest);
    if (state.triangles > too_many_corners && state.mean_edge < far_below * needed)
        return MeshFault{MeshFault::too_fine, static_cast<double>(state.triangles)};
    if (state.is_flat()) return {};
    const bool coarse_boundary = state.triangles < most && state.has_coarse_boundary(length_tolerance);
    const bool coarse_interior = state.mean_edge > coarse_share * needed && state.interior_turn > interior_limit;
    if (coarse_boundary || coarse_interior) return MeshFault{MeshFault::turns, state.turn_max};
    if (state.sliver_share > many_slivers) return MeshFault{MeshFault::slivers, state.sliver_share};
    if (state.locked_share > many_locked) return MeshFault{MeshFault::locked, state.locked_share};
    return {};
}

}  // namespace ripstop
