#include "ripstop/assembly/seams/one_sided.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "ripstop/base/index.h"
#include "ripstop/base/parallel.h"

namespace ripstop {
namespace {

constexpr int samples_per_tile = 8;  // triangles sampled per tile
constexpr int half_sphere = 16;      // directions; their opposites are used too
constexpr double own_cloth = 1e-4;   // share of the tile's size: closer hits belong to the tile itself

/// Directions spread evenly over the sphere, along a spiral.
std::array<Vec3, 2 * half_sphere> directions() {
    std::array<Vec3, 2 * half_sphere> found;
    const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
    for (int k = 0; k < half_sphere; ++k) {
        const double z = (k + 0.5) / half_sphere, radius = std::sqrt(1 - z * z);
        found[at(k)] = Vec3(radius * std::cos(golden * k), radius * std::sin(golden * k), z);
        found[at(k + half_sphere)] = -found[at(k)];
    }
    return found;
}

}  // namespace

double one_sidedness(const Tile& tile, const SightLines& cloth) {
    static const std::array<Vec3, 2 * half_sphere> all = directions();
    const double least = own_cloth * bounding_diagonal(tile.mesh);
    const int count = tile.mesh.triangle_count();
    std::array<double, 2> seen{0, 0}, open{0, 0};
    for (int s = 0; s < std::min(samples_per_tile, count); ++s) {
        // the golden section, because triangles in rows would always be hit at the same end
        const double place = (s + 1) * 0.6180339887498949;
        const int t = static_cast<int>((place - std::floor(place)) * count);
        const Vec3 a = tile.mesh.corner(t, 0), b = tile.mesh.corner(t, 1), c = tile.mesh.corner(t, 2);
        const Vec3 normal = (b - a).cross(c - a), from = (a + b + c) / 3;
        for (const Vec3& direction : all) {
            const std::size_t side = normal.dot(direction) > 0 ? 0 : 1;
            seen[side] += 1;
            open[side] += !cloth.is_blocked(from, direction, least);
        }
    }
    return std::abs(open[0] / std::max(1.0, seen[0]) - open[1] / std::max(1.0, seen[1]));
}

std::vector<double> one_sidedness(const std::vector<Tile>& tiles, const std::vector<char>& wanted) {
    std::vector<double> found(tiles.size(), 0);
    if (std::none_of(wanted.begin(), wanted.end(), [](char is_wanted) { return is_wanted != 0; })) return found;
    std::vector<const TriangleMesh*> meshes;
    for (const Tile& tile : tiles) meshes.push_back(&tile.mesh);
    const SightLines cloth(meshes);
    parallel_for(static_cast<int>(tiles.size()), 0, [&](int t) {
        const auto i = static_cast<std::size_t>(t);
        if (wanted[i]) found[i] = one_sidedness(tiles[i], cloth);
    });
    return found;
}

}  // namespace ripstop
