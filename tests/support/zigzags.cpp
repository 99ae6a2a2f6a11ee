#include "support/zigzags.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

namespace ripstop::testing {
namespace {

constexpr double sphere = 10;  // [m]

}  // namespace

std::vector<TriangleMesh> cut_along_mesh(const Lattice& lattice, const std::function<int(const Vec2&)>& part_of,
                                         const std::function<Vec3(const Vec2&)>& into_space) {
    std::mt19937 random(lattice.seed);
    const auto uniform = [&] { return 2 * (static_cast<double>(random()) / 4294967295.0) - 1; };
    const double e = lattice.edge, turn = 3 * uniform();
    const Vec2 middle(e * uniform(), e * uniform());
    const int count = static_cast<int>(1.5 * lattice.half / e) + 3;
    std::map<std::pair<int, int>, int> number;
    std::vector<Vec2> plane;
    for (int j = -count; j <= count; ++j)
        for (int i = -2 * count; i <= 2 * count; ++i) {
            const double x = (i + 0.5 * j) * e + middle.x() + lattice.jumble * e * uniform();
            const double y = j * e * std::sqrt(0.75) + middle.y() + lattice.jumble * e * uniform();
            const Vec2 point(x * std::cos(turn) - y * std::sin(turn), x * std::sin(turn) + y * std::cos(turn));
            if (point.norm() > 1.6 * lattice.half) continue;
            number[{i, j}] = static_cast<int>(plane.size());
            plane.push_back(point);
        }
    std::vector<std::vector<std::array<int, 3>>> parts;
    const auto add = [&](std::pair<int, int> p, std::pair<int, int> q, std::pair<int, int> r) {
        const auto a = number.find(p), b = number.find(q), c = number.find(r);
        if (a == number.end() || b == number.end() || c == number.end()) return;
        const std::array<int, 3> corner{a->second, b->second, c->second};
        const int part =
            part_of((plane[static_cast<std::size_t>(corner[0])] + plane[static_cast<std::size_t>(corner[1])] +
                     plane[static_cast<std::size_t>(corner[2])]) /
                    3);
        if (part < 0) return;
        parts.resize(std::max(parts.size(), static_cast<std::size_t>(part) + 1));
        parts[static_cast<std::size_t>(part)].push_back(corner);
    };
    for (int j = -count; j <= count; ++j)
        for (int i = -2 * count; i <= 2 * count; ++i) {
            add({i, j}, {i + 1, j}, {i, j + 1});
            add({i, j}, {i, j + 1}, {i - 1, j + 1});
        }
    std::vector<TriangleMesh> meshes;
    for (const auto& part : parts) {
        std::map<int, int> used;
        TriangleMesh mesh;
        mesh.triangles.resize(static_cast<Eigen::Index>(part.size()), 3);
        for (std::size_t t = 0; t < part.size(); ++t)
            for (std::size_t k = 0; k < 3; ++k)
                mesh.triangles(static_cast<Eigen::Index>(t), static_cast<Eigen::Index>(k)) =
                    used.emplace(part[t][k], static_cast<int>(used.size())).first->second;
        mesh.positions.resize(static_cast<Eigen::Index>(used.size()), 3);
        for (const auto& [from, to] : used) mesh.positions.row(to) = into_space(plane[static_cast<std::size_t>(from)]);
        meshes.push_back(std::move(mesh));
    }
    return meshes;
}

Vec3 onto_sphere(const Vec2& point) {
    const double away = point.norm(), angle = 2 * std::asin(std::min(1.0, away / (2 * sphere)));
    if (away < 1e-12) return {0, 0, sphere};
    return {sphere * std::sin(angle) * point.x() / away, sphere * std::sin(angle) * point.y() / away,
            sphere * std::cos(angle)};
}

TriangleMesh zigzag_disc(double curvature, double across, double jumble, unsigned seed) {
    const double angle = std::acos(1 - curvature / (2 * std::numbers::pi)), radius = 2 * sphere * std::sin(angle / 2);
    return cut_along_mesh(
               {radius / across, radius, jumble, seed},
               [&](const Vec2& point) { return point.norm() < radius ? 0 : -1; }, onto_sphere)
        .front();
}

}  // namespace ripstop::testing
