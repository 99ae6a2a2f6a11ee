#include "support/sewn.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "ripstop/mesh/boundary.h"
#include "ripstop/tile/make_tile.h"
#include "ripstop/tile/targets.h"
#include "support/shapes.h"

namespace ripstop::testing {
namespace {

using Place = std::array<long long, 3>;

/// The ends of a boundary edge, rounded to 0.1 micrometres.
std::pair<Place, Place> ends(const Tile& tile, int edge) {
    const auto place = [&](int i) {
        const Vec3 point = tile.mesh.positions.row(tile.boundary[static_cast<std::size_t>(i) % tile.boundary.size()]);
        const auto cell = [](double x) { return std::llround(x * 1e7); };
        return Place{cell(point.x()), cell(point.y()), cell(point.z())};
    };
    return {place(edge), place(edge + 1)};
}

struct Edge {
    int tile = -1, chain = -1, edge = -1;
};

/// Flat lengths from a seam's start to the ends of its parts, with the lengths along the curve.
struct Cumulated {
    std::vector<double> drawn{0}, flat{0};
    double at(double s) const {
        const auto next = std::upper_bound(drawn.begin() + 1, drawn.end() - 1, s) - drawn.begin();
        const auto k = static_cast<std::size_t>(next);
        return flat[k - 1] + (flat[k] - flat[k - 1]) * (s - drawn[k - 1]) / (drawn[k] - drawn[k - 1]);
    }
};

Cumulated cumulated(const Envelope& envelope, const std::vector<Points2>& flats, const SeamSide& side, bool along) {
    const Tile& tile = envelope.tiles[static_cast<std::size_t>(side.tile)];
    const Eigen::VectorXd drawn = drawn_lengths(tile);
    const Eigen::VectorXd flat = edge_lengths(flats[static_cast<std::size_t>(side.tile)], closed(tile.boundary));
    std::vector<SeamPart> parts = side.parts;
    if (!along) std::reverse(parts.begin(), parts.end());
    Cumulated sum;
    for (const SeamPart& part : parts) {
        sum.drawn.push_back(sum.drawn.back() + part.length);
        sum.flat.push_back(sum.flat.back() + part.length * flat[part.edge] / drawn[part.edge]);
    }
    return sum;
}

}  // namespace

std::string numbered(char letter, std::size_t number) {
    std::string name(1, letter);
    return name += std::to_string(number);
}

std::vector<int> edges_of_chain(const Tile& tile, int chain) {
    std::vector<int> edges;
    const std::vector<int>& vertices = tile.chains[static_cast<std::size_t>(chain)].vertices;
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i)
        edges.push_back(static_cast<int>(std::find(tile.boundary.begin(), tile.boundary.end(), vertices[i]) -
                                         tile.boundary.begin()));
    return edges;
}

std::vector<Seam> conforming_seams(const std::vector<Tile>& tiles) {
    std::vector<Edge> edges;
    std::map<std::pair<Place, Place>, Edge> found;
    for (int t = 0; t < static_cast<int>(tiles.size()); ++t)
        for (int c = 0; c < static_cast<int>(tiles[static_cast<std::size_t>(t)].chains.size()); ++c)
            for (const int e : edges_of_chain(tiles[static_cast<std::size_t>(t)], c)) {
                edges.push_back({t, c, e});
                found[ends(tiles[static_cast<std::size_t>(t)], e)] = edges.back();
            }
    std::vector<Seam> seams;
    Edge last, last_mate;
    for (const Edge& edge : edges) {
        const Tile& tile = tiles[static_cast<std::size_t>(edge.tile)];
        const auto [from, to] = ends(tile, edge.edge);
        const auto mate = found.find({to, from});
        const bool first_of_two =
            mate != found.end() && std::pair(edge.tile, edge.chain) < std::pair(mate->second.tile, mate->second.chain);
        if (first_of_two) {
            const Edge other = mate->second;
            if (edge.tile != last.tile || edge.chain != last.chain || other.tile != last_mate.tile ||
                other.chain != last_mate.chain)
                seams.push_back(
                    {numbered('S', seams.size() + 1), {edge.tile, edge.chain, {}}, {other.tile, other.chain, {}}});
            const double length = drawn_lengths(tile)[edge.edge];
            seams.back().a.parts.push_back({edge.edge, length});
            seams.back().b.parts.insert(seams.back().b.parts.begin(), {other.edge, length});
            seams.back().length += length;
        }
        last = edge;
        last_mate = first_of_two ? mate->second : Edge{};
    }
    return seams;
}

Envelope sewn(std::vector<Tile> tiles) {
    Envelope envelope{std::move(tiles)};
    envelope.seams = conforming_seams(envelope.tiles);
    return envelope;
}

Envelope gores(const std::vector<double>& angles, int count, int columns, int rows) {
    std::vector<Tile> tiles;
    double at = 0;
    for (int g = 0; g < count; ++g) {
        const double angle = angles[static_cast<std::size_t>(g) % angles.size()];
        TriangleMesh mesh = lune(angle, std::max(2, static_cast<int>(std::lround(columns * angle / angles[0]))), rows);
        const double turn = at + 0.5 * angle;
        Eigen::Matrix3d about;
        about << std::cos(turn), -std::sin(turn), 0, std::sin(turn), std::cos(turn), 0, 0, 0, 1;
        mesh.positions = (mesh.positions * about.transpose()).eval();
        tiles.push_back(make_tile(numbered('G', tiles.size() + 1), mesh, {.warp = Vec3::UnitZ()}));
        at += angle;
    }
    return sewn(std::move(tiles));
}

double worst_mismatch(const Envelope& envelope, const std::vector<Points2>& flats) {
    double worst = 0;
    for (const Seam& seam : envelope.seams) {
        const Cumulated a = cumulated(envelope, flats, seam.a, true), b = cumulated(envelope, flats, seam.b, false);
        worst = std::max(worst, std::abs(a.flat.back() - b.flat.back()) / seam.length);
    }
    return worst;
}

double worst_drift(const Envelope& envelope, const std::vector<Points2>& flats) {
    double worst = 0;
    for (const Seam& seam : envelope.seams) {
        const Cumulated a = cumulated(envelope, flats, seam.a, true), b = cumulated(envelope, flats, seam.b, false);
        for (std::size_t k = 1; k < a.drawn.size(); ++k)
            worst = std::max(worst, std::abs(a.flat[k] - b.at(a.drawn[k])) / seam.length);
        for (std::size_t k = 1; k < b.drawn.size(); ++k)
            worst = std::max(worst, std::abs(b.flat[k] - a.at(b.drawn[k])) / seam.length);
    }
    return worst;
}

}  // namespace ripstop::testing
