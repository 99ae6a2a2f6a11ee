#include "support/sphere_patches.h"

#include <algorithm>
#include <cmath>

#include "ripstop/tile/make_tile.h"
#include "support/sewn.h"
#include "support/shapes.h"

namespace ripstop::testing {
namespace {

Vec2 chart(const Vec3& point) {
    return {std::atan2(point.y(), point.x()), std::asin(point.z())};
}

/// The two ends of a boundary edge, in longitude and latitude.
std::pair<Vec2, Vec2> flat_ends(const Tile& tile, int edge) {
    const auto point = [&](int i) {
        return chart(tile.mesh.positions.row(tile.boundary[static_cast<std::size_t>(i) % tile.boundary.size()]));
    };
    return {point(edge), point(edge + 1)};
}

Tile make_patch(const Patch& patch) {
    const TriangleMesh mesh = grid(patch.columns, patch.rows, [&](double u, double v) {
        const double longitude = patch.west + u * (patch.east - patch.west);
        const double latitude = patch.south + v * (patch.north - patch.south);
        return Vec3(std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
                    std::sin(latitude));
    });
    Tile tile = make_tile(patch.name, mesh, {.warp = Vec3::UnitZ()});
    tile.curve_lengths.resize(static_cast<Eigen::Index>(tile.boundary.size()));
    for (int e = 0; e < tile.curve_lengths.size(); ++e) {
        const auto [from, to] = flat_ends(tile, e);
        tile.curve_lengths[e] = std::abs(to.y() - from.y()) + std::cos(from.y()) * std::abs(to.x() - from.x());
    }
    return tile;
}

/// The parts of a chain between two values of the coordinate that runs along it (0 longitude, 1 latitude).
SeamSide side_between(const Envelope& envelope, int t, int chain, int along, double low, double high) {
    SeamSide side{t, chain, {}};
    const Tile& tile = envelope.tiles[static_cast<std::size_t>(t)];
    for (const int e : edges_of_chain(tile, chain)) {
        const auto [from, to] = flat_ends(tile, e);
        const double shared =
            std::min(high, std::max(from[along], to[along])) - std::max(low, std::min(from[along], to[along]));
        if (shared > 1e-9) side.parts.push_back({e, shared * (along == 0 ? std::cos(from.y()) : 1)});
    }
    return side;
}

/// The circle that a chain lies on, and its range there.
struct Run {
    int along;
    double circle, low, high;
};

Run run_of(const Tile& tile, int chain) {
    const std::vector<int> edges = edges_of_chain(tile, chain);
    const Vec2 from = flat_ends(tile, edges.front()).first, to = flat_ends(tile, edges.back()).second;
    const int along = std::abs(to.x() - from.x()) > std::abs(to.y() - from.y()) ? 0 : 1;
    return {along, from[1 - along], std::min(from[along], to[along]), std::max(from[along], to[along])};
}

}  // namespace

Envelope sewn_patches(const std::vector<Patch>& patches) {
    Envelope envelope;
    for (const Patch& patch : patches) envelope.tiles.push_back(make_patch(patch));
    for (int a = 0; a < static_cast<int>(patches.size()); ++a)
        for (int b = a + 1; b < static_cast<int>(patches.size()); ++b)
            for (int i = 0; i < 4; ++i)
                for (int j = 0; j < 4; ++j) {
                    const Run one = run_of(envelope.tiles[static_cast<std::size_t>(a)], i);
                    const Run other = run_of(envelope.tiles[static_cast<std::size_t>(b)], j);
                    const double low = std::max(one.low, other.low), high = std::min(one.high, other.high);
                    if (one.along != other.along || std::abs(one.circle - other.circle) > 1e-9 || high - low < 1e-6)
                        continue;
                    Seam seam{numbered('S', envelope.seams.size() + 1),
                              side_between(envelope, a, i, one.along, low, high),
                              side_between(envelope, b, j, one.along, low, high)};
                    for (const SeamPart& part : seam.a.parts) seam.length += part.length;
                    envelope.seams.push_back(seam);
                }
    return envelope;
}

}  // namespace ripstop::testing
