#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "ripstop/assembly/faults/faults.h"
#include "ripstop/assembly/seams/seam_runs.h"
#include "ripstop/base/index.h"
#include "ripstop/tile/make_tile.h"

namespace ripstop {
namespace {

/// True if every vertex of the tile's boundary is near the other tile's boundary.
bool lies_on(const std::vector<PlacedChain>& chains, const Tile& tile, double tolerance) {
    for (const int v : tile.boundary) {
        const Vec3 point = tile.mesh.positions.row(v);
        bool near = false;
        for (const PlacedChain& chain : chains)
            for (int e = 0; e < chain.curve.edge_count() && !near; ++e)
                near = foot_on_edge(chain.curve, e, point).distance <=
                       tolerance + chord_of_edge(chain.curve, e) * turn_of_edge(chain.curve, e) / 32;
        if (!near) return false;
    }
    return true;
}

bool are_one(const Tile& a, const Tile& b, double tolerance) {
    const double area_a = surface_area(a.mesh), area_b = surface_area(b.mesh);
    return std::abs(area_a - area_b) < 0.01 * area_a && lies_on(place_chains({a}), b, tolerance) &&
           lies_on(place_chains({b}), a, tolerance);
}

/// The tile with its other side up; corners stay in place.
Tile turned_over(const Tile& tile) {
    TileOptions options;
    if (tile.grain.field.rows() == 0) options.warp = tile.grain.direction;
    options.warp_field = tile.grain.field;
    options.warp_source = tile.grain.source;
    options.drawn = tile.drawn;
    options.compensation = tile.compensation;
    options.attributes = tile.attributes;
    const bool has_corners = tile.chains.size() > 1;
    for (const Chain& chain : tile.chains)
        if (has_corners) options.corners.push_back(tile.mesh.positions.row(chain.vertices.front()));
    TriangleMesh mesh = tile.mesh;
    mesh.triangles.col(1).swap(mesh.triangles.col(2));
    Tile turned = make_tile(tile.name, std::move(mesh), options);
    turned.inside = tile.inside;
    return turned;
}

/// The groups to turn over so that neighbours have opposite directions: in each connected set, the part with fewer
/// tiles.
std::vector<bool> groups_to_turn(const std::vector<int>& group, const std::vector<NearMiss>& same_way) {
    const std::size_t count = static_cast<std::size_t>(*std::max_element(group.begin(), group.end()) + 1);
    std::vector<std::vector<int>> beside(count);
    std::vector<int> size(count, 0), side(count, -1);
    for (const int g : group) ++size[at(g)];
    for (const NearMiss& pair : same_way) {
        const int a = group[at(pair.tile_a)], b = group[at(pair.tile_b)];
        if (a == b) continue;
        beside[at(a)].push_back(b);
        beside[at(b)].push_back(a);
    }
    std::vector<bool> turn(count, false);
    for (std::size_t first = 0; first < count; ++first) {
        if (side[first] >= 0) continue;
        std::vector<std::size_t> reached{first};
        side[first] = 0;
        int tiles[2] = {size[first], 0};
        for (std::size_t k = 0; k < reached.size(); ++k)
            for (const int next : beside[reached[k]]) {
                int& its = side[at(next)];
                if (its >= 0) continue;
                its = 1 - side[reached[k]];
                tiles[its] += size[at(next)];
                reached.push_back(static_cast<std::size_t>(next));
            }
        const int fewer = tiles[1] <= tiles[0] ? 1 : 0;
        for (const std::size_t g : reached) turn[g] = reached.size() > 1 && side[g] == fewer;
    }
    return turn;
}

}  // namespace

std::vector<EnvelopeIssue> remove_doubled(std::vector<Tile>& tiles, double tolerance) {
    const std::size_t count = tiles.size();
    std::vector<Vec3> centres;
    for (const Tile& tile : tiles) centres.push_back(centroid(tile.mesh));
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](std::size_t p, std::size_t q) {
        return std::pair(centres[p].x(), p) < std::pair(centres[q].x(), q);
    });
    std::vector<std::size_t> original(count, count);  // for a doubled tile: the tile it lies on
    for (std::size_t k = 0; k < count; ++k) {
        const double near = std::max(2 * tolerance, 0.002 * bounding_diagonal(tiles[order[k]].mesh));
        for (std::size_t l = k + 1; l < count && centres[order[l]].x() - centres[order[k]].x() < near; ++l) {
            const std::size_t first = std::min(order[k], order[l]), second = std::max(order[k], order[l]);
            if ((centres[first] - centres[second]).norm() > near || original[second] < count) continue;
            const bool opposed = area_vector(tiles[first].mesh).dot(area_vector(tiles[second].mesh)) < 0;
            if (opposed && count == 2) continue;  // front and back of a cushion laid flat
            if (are_one(tiles[first], tiles[second], tolerance)) original[second] = first;
        }
    }
    std::vector<EnvelopeIssue> issues;
    std::vector<Tile> kept;
    for (std::size_t t = 0; t < count; ++t) {
        if (original[t] == count) {
            kept.push_back(tiles[t]);
            continue;
        }
        const std::string& under = tiles[original[t]].name;
        issues.push_back({"doubled",
                          "tile " + tiles[t].name + " lies on tile " + under + " at " + place_text(centres[t]) +
                              ": the same outline twice; delete one of them",
                          {tiles[t].name, under},
                          centres[t],
                          0});
    }
    tiles = std::move(kept);
    return issues;
}

std::vector<EnvelopeIssue> name_inside_out(const std::vector<Tile>& tiles, const std::vector<LooseLoop>& loops) {
    constexpr double nearly_closed = 0.1;  // largest area of openings, as circles of the loops' lengths, per area
                                           // of the skin
    if (tiles.empty()) return {};
    double area = 0, openings = 0, volume = 0;
    for (const LooseLoop& loop : loops) openings += loop.length * loop.length / (4 * std::numbers::pi);
    for (const Tile& tile : tiles) area += surface_area(tile.mesh);
    if (openings > nearly_closed * area) return {};
    Vec3 middle = Vec3::Zero();
    for (const Tile& tile : tiles) middle += surface_area(tile.mesh) / area * centroid(tile.mesh);
    for (const Tile& tile : tiles)
        for (Eigen::Index f = 0; f < tile.mesh.triangles.rows(); ++f) {
            const auto corner = [&](int c) {
                return Vec3(Vec3(tile.mesh.positions.row(tile.mesh.triangles(f, c))) - middle);
            };
            volume += corner(0).dot(corner(1).cross(corner(2))) / 6;
        }
    constexpr double of_a_ball = 0.094;  // volume over area^(3/2); a sphere has 0.094
    if (!(volume < -0.05 * of_a_ball * std::pow(area, 1.5))) return {};
    return {{"inside_out",
             "the whole envelope is inside out: the outside of the cloth would face in; flip all faces",
             {},
             middle,
             0}};
}

std::vector<EnvelopeIssue> turn_back(std::vector<Tile>& tiles, const FoundSeams& found) {
    if (found.same_way.empty()) return {};
    std::vector<Seam> seams = found.seams;  // further sheets do not tell which side is up
    std::erase_if(seams, [](const Seam& seam) { return seam.into.has_value(); });
    const std::vector<int> group = sewn_groups(static_cast<int>(tiles.size()), seams);
    const std::vector<bool> turn = groups_to_turn(group, found.same_way);
    std::vector<EnvelopeIssue> issues;
    for (std::size_t g = 0; g < turn.size(); ++g) {
        if (!turn[g]) continue;
        EnvelopeIssue issue{"turned_over", {}, {}, Vec3::Zero(), 0};
        for (std::size_t t = 0; t < tiles.size(); ++t) {
            if (group[t] != static_cast<int>(g)) continue;
            if (issue.tiles.empty()) issue.at = centroid(tiles[t].mesh);
            issue.tiles.push_back(tiles[t].name);
            tiles[t] = turned_over(tiles[t]);
        }
        const bool one = issue.tiles.size() == 1;
        issue.message = std::string(one ? "tile " : "tiles ") + names_text(issue.tiles) + " at " +
                        place_text(issue.at) + (one ? " is" : " are") +
                        " inside out: the edges run the same way as those of the neighbours; reverse the triangles "
                        "(flip the normals)";
        issues.push_back(std::move(issue));
    }
    return issues;
}

}  // namespace ripstop
