#include "support/membranes.h"

#include <cmath>
#include <numbers>

#include "ripstop/energy/deformation.h"
#include "ripstop/geometry/triangle.h"

namespace ripstop::testing {
namespace {

constexpr double small = 1e-9;  // [m]

/// Symmetric about the planes x = 0, y = 0 and, if asked for, z = 0.
Freedom by_planes(const Vec3& at, bool and_floor) {
    const int x = at.x() < small ? 0 : 1, y = at.y() < small ? 0 : 2, z = and_floor && at.z() < small ? 0 : 4;
    return static_cast<Freedom>(x | y | z);
}

/// Lifts the flat mesh: z = height (1 - share), where share is each node's relative distance to the edge.
Points3 domed(const Points3& flat, double height, const std::function<double(const Vec3&)>& share) {
    Points3 nodes = flat;
    for (Eigen::Index n = 0; n < nodes.rows(); ++n) {
        const double t = share(nodes.row(n));
        nodes(n, 2) = height * (1 - t * t);
    }
    return nodes;
}

}  // namespace

Fabric isotropic(double stiffness, double poisson) {
    Fabric fabric;
    fabric.warp_stiffness = fabric.weft_stiffness = stiffness;
    fabric.poisson = poisson;
    fabric.shear_stiffness = stiffness / (2 * (1 + poisson));
    fabric.mass = 0;
    return fabric;
}

Fabric balloon_nylon() {
    Fabric fabric;
    fabric.warp_stiffness = 60e3;
    fabric.weft_stiffness = 50e3;
    fabric.poisson = 0.2;
    fabric.shear_stiffness = 1500;
    fabric.mass = 0;
    return fabric;
}

SewnEnvelope skin(const TriangleMesh& mesh, const Fabric& fabric, const Points2& cut) {
    SewnEnvelope sewn;
    sewn.nodes = mesh.positions;
    sewn.freedom.assign(static_cast<std::size_t>(mesh.vertex_count()), Freedom::everywhere);
    sewn.first_vertex = {0};
    for (int v = 0; v < mesh.vertex_count(); ++v) sewn.places.push_back({{{v, 1, 0}}});
    sewn.triangles = mesh.triangles;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        sewn.flat.push_back(cut.rows() > 0 ? flat_edges(mesh.triangles, cut, t)
                                           : lay_flat(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)));
    const auto count = static_cast<std::size_t>(mesh.triangle_count());
    sewn.tile.assign(count, 0);
    sewn.fabric.assign(count, 0);
    sewn.holds_gas.assign(count, 1);
    sewn.fabrics = {fabric};
    return sewn;
}

void hold(SewnEnvelope& sewn, const std::function<Freedom(const Vec3&)>& freedom) {
    for (Eigen::Index n = 0; n < sewn.nodes.rows(); ++n)
        sewn.freedom[static_cast<std::size_t>(n)] = freedom(sewn.nodes.row(n));
}

TriangleMesh quarter_disk(int n) {
    TriangleMesh mesh;
    mesh.positions = Points3::Zero((n + 1) * (n + 2) / 2, 3);
    const auto id = [](int i, int j) { return i * (i + 1) / 2 + j; };
    for (int i = 1; i <= n; ++i)
        for (int j = 0; j <= i; ++j) {
            const double angle = std::numbers::pi / 2 * j / i, r = static_cast<double>(i) / n;
            mesh.positions.row(id(i, j)) << (j == i ? 0 : r * std::cos(angle)), (j == 0 ? 0 : r * std::sin(angle)), 0;
        }
    mesh.triangles.resize(n * n, 3);
    int t = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j <= i; ++j) {
            mesh.triangles.row(t++) << id(i, j), id(i + 1, j), id(i + 1, j + 1);
            if (j < i) mesh.triangles.row(t++) << id(i, j), id(i + 1, j + 1), id(i, j + 1);
        }
    return mesh;
}

Vec3 AtRest::strain(int triangle) const {
    const auto at = [&](int k) { return Vec3(found.nodes.row(sewn.triangles(triangle, k))); };
    return green_voigt(RelaxedMembrane(sewn.flat[static_cast<std::size_t>(triangle)]).deformation(at(0), at(1), at(2)));
}

Vec3 AtRest::stress(int triangle) const {
    return TensionField(sewn.fabrics[0]).at(strain(triangle)).stress;
}

AtRest at_rest(SewnEnvelope sewn, const Points3& start, const GasPressure& gas, std::vector<double> residuals,
               double tolerance) {
    AtRest result{std::move(sewn), {}};
    Balance balance(result.sewn, gas, 0);
    EquilibriumOptions options;
    options.residuals = std::move(residuals);
    options.tolerance = tolerance;
    options.iterations = 1000;
    result.found = find_equilibrium(balance, start, options);
    result.volume = balance.volume(result.found.nodes);
    return result;
}

double sphere_stretch(int n) {
    SewnEnvelope sewn = skin(octant(n), isotropic(1e4, 0.3));
    hold(sewn, [](const Vec3& at) { return by_planes(at, true); });
    const AtRest rest = at_rest(sewn, sewn.nodes, {200, 0, 0}, {0});
    return rest.found.nodes.rowwise().norm().mean();
}

Cylinder cylinder_under_gas(int n) {
    const double turn = std::numbers::pi / 2;
    const auto point = [&](double u, double v) {
        return Vec3(u == 1 ? 0 : std::cos(turn * u), 0.1 * (1 - v), u == 0 ? 0 : std::sin(turn * u));
    };
    const TriangleMesh mesh = grid(n, 2, point);
    const double chord = 2 * std::sin(turn / (2 * n));
    Points2 cut(mesh.vertex_count(), 2);
    for (int v = 0; v < mesh.vertex_count(); ++v) cut.row(v) << chord * (v % (n + 1)), -mesh.positions(v, 1);
    SewnEnvelope sewn = skin(mesh, balloon_nylon(), cut);
    hold(sewn,
         [](const Vec3& at) { return static_cast<Freedom>((at.x() < small ? 0 : 1) | (at.z() < small ? 0 : 4)); });
    const AtRest rest = at_rest(sewn, sewn.nodes, {1200, 0, 0}, {0});
    Cylinder result;
    for (int t = 0; t < mesh.triangle_count(); ++t) result.hoop += rest.stress(t)[0] / mesh.triangle_count();
    const Points3& x = rest.found.nodes;
    result.stretch = (x.col(0).array().square() + x.col(2).array().square()).sqrt().mean();
    return result;
}

Disk clamped_disk(double poisson, int n) {
    constexpr double stiffness = 1e4, pressure = 1e-5 * stiffness;
    const TriangleMesh mesh = quarter_disk(n);
    SewnEnvelope sewn = skin(mesh, isotropic(stiffness, poisson), mesh.positions.leftCols<2>());
    hold(sewn, [](const Vec3& at) { return at.norm() > 1 - small ? Freedom::nowhere : by_planes(at, false); });
    const double unit = std::cbrt(pressure / stiffness);
    const Points3 start = domed(mesh.positions, 0.6 * unit, [](const Vec3& at) { return at.norm(); });
    const AtRest rest = at_rest(sewn, start, {pressure, 0, 0}, {0});
    const double tension = std::cbrt(stiffness * pressure * pressure);
    // For triangles on the x axis, where the radial direction is the warp.
    return {rest.found.nodes(0, 2) / unit, rest.stress(0).head<2>().mean() / tension,
            rest.stress((n - 1) * (n - 1))[0] / tension};
}

Mylar mylar_balloon(int n, double residual) {
    const TriangleMesh mesh = quarter_disk(n);
    SewnEnvelope sewn = skin(mesh, isotropic(1e3, 0.3), mesh.positions.leftCols<2>());
    hold(sewn, [](const Vec3& at) {
        const int floor = at.norm() > 1 - small ? 0 : 4;
        return static_cast<Freedom>((at.x() < small ? 0 : 1) | (at.y() < small ? 0 : 2) | floor);
    });
    Points3 start = mesh.positions;
    for (Eigen::Index v = 0; v < start.rows(); ++v) {
        const double r2 = start.row(v).squaredNorm();
        start(v, 2) = 0.45 * std::sqrt(std::max(0.0, 1 - r2));
        start.row(v).head<2>() *= 1 - 0.22 * r2;
    }
    std::vector<double> residuals = {1e-2, 1e-4};
    if (residual < 1e-4) residuals.push_back(residual);
    const AtRest rest = at_rest(sewn, start, {1, 0, 0}, residuals, 1e-4);
    return {rest.found.nodes.bottomRows(n + 1).rowwise().norm().mean(), rest.found.nodes(0, 2), 8 * rest.volume};
}

Airbag square_airbag(int n, double residual) {
    const double half = 0.6 / std::numbers::sqrt2;
    const TriangleMesh mesh = grid(
        n, n, [&](double u, double v) { return Vec3(half * u, half * v, 0); }, true);
    SewnEnvelope sewn = skin(mesh, isotropic(588e6 * 0.0006, 0.4), mesh.positions.leftCols<2>());
    const auto to_edge = [&](const Vec3& at) { return std::max(at.x(), at.y()) / half; };
    hold(sewn, [&](const Vec3& at) {
        const int floor = to_edge(at) > 1 - small ? 0 : 4;
        return static_cast<Freedom>((at.x() < small ? 0 : 1) | (at.y() < small ? 0 : 2) | floor);
    });
    const Points3 start = domed(mesh.positions, 0.15, to_edge);
    const AtRest rest = at_rest(sewn, start, {5000, 0, 0}, {1e-1, 1e-2, 1e-3, residual});
    const Vec3 corner = rest.found.nodes.row(mesh.vertex_count() - 1);
    const double side = 2 * half;
    return {rest.found.nodes(0, 2), 0.6 - corner.head<2>().norm(), 8 * rest.volume / (side * side * side),
            0.5 * (rest.stress(0) + rest.stress(1)).head<2>().mean()};
}

}  // namespace ripstop::testing
