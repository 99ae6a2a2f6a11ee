#include "support/sewn.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "support/shapes.h"

namespace ripstop::testing {
namespace {

using Place = std::array<long long, 3>;

Place place(const Vec3& point) {
    const auto cell = [](double x) { return std::llround(x * 1e7); };
    return {cell(point.x()), cell(point.y()), cell(point.z())};
}

struct Edge {
    int tile = -1, edge = -1, chain = -1;
};

std::vector<int> chain_of_edges(const Tile& tile) {
    std::vector<int> chains;
    std::vector<int> starts;
    for (std::size_t i = 0; i < tile.boundary.size(); ++i) {
        int chain = -1;
        for (std::size_t c = 0; c < tile.chains.size(); ++c)
            if (tile.chains[c].vertices.front() == tile.boundary[i]) chain = static_cast<int>(c);
        chains.push_back(chain);
    }
    // the loop may begin within a chain: what comes before the first start belongs to the last one
    int current = chains.empty() ? -1 : *std::max_element(chains.begin(), chains.end());
    for (auto it = chains.rbegin(); it != chains.rend(); ++it)
        if (*it >= 0) {
            current = *it;
            break;
        }
    for (int& chain : chains) current = chain = chain >= 0 ? chain : current;
    return chains;
}

/// Flat length from the side's start to the ends of its parts, against the length on the curve.
struct Cumulated {
    std::vector<double> drawn{0}, flat{0};
    void add(const SeamPart& part, double stretch) {
        drawn.push_back(drawn.back() + part.length);
        flat.push_back(flat.back() + part.length * stretch);
    }
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
    for (const SeamPart& part : parts) sum.add(part, flat[part.edge] / drawn[part.edge]);
    return sum;
}

}  // namespace

std::vector<Seam> conforming_seams(const std::vector<Tile>& tiles) {
    std::map<std::pair<Place, Place>, Edge> edges;
    std::vector<std::vector<int>> chains;
    const auto ends = [&](int t, int i) {
        const Tile& tile = tiles[static_cast<std::size_t>(t)];
        const auto point = [&](int k) {
            return place(tile.mesh.positions.row(tile.boundary[static_cast<std::size_t>(k) % tile.boundary.size()]));
        };
        return std::pair(point(i), point(i + 1));
    };
    for (int t = 0; t < static_cast<int>(tiles.size()); ++t) {
        chains.push_back(chain_of_edges(tiles[static_cast<std::size_t>(t)]));
        for (int i = 0; i < static_cast<int>(chains.back().size()); ++i)
            edges[ends(t, i)] = {t, i, chains.back()[static_cast<std::size_t>(i)]};
    }
    std::vector<Seam> seams;
    for (int t = 0; t < static_cast<int>(tiles.size()); ++t) {
        const Tile& tile = tiles[static_cast<std::size_t>(t)];
        const Eigen::VectorXd lengths = drawn_lengths(tile);
        const int count = static_cast<int>(lengths.size());
        // from the start of a chain on, so that a seam is not cut where the loop begins
        int first = 0;
        while (first < count &&
               chains[static_cast<std::size_t>(t)][static_cast<std::size_t>(first)] ==
                   chains[static_cast<std::size_t>(t)][static_cast<std::size_t>((first + count - 1) % count)])
            ++first;
        Edge last_mate;
        int last_chain = -1;
        for (int k = 0; k < count; ++k) {
            const int i = (first + k) % count;
            const auto [from, to] = ends(t, i);
            const auto found = edges.find({to, from});
            const Edge mate = found == edges.end() ? Edge{} : found->second;
            const int chain = chains[static_cast<std::size_t>(t)][static_cast<std::size_t>(i)];
            const bool mine = mate.tile > t || (mate.tile == t && mate.edge > i);
            if (mine) {
                const bool goes_on = chain == last_chain && mate.tile == last_mate.tile && mate.chain == last_mate.chain;
                if (!goes_on) {
                    seams.push_back({"S" + std::to_string(seams.size() + 1), {t, chain, {}}, {mate.tile, mate.chain, {}}});
                }
                Seam& seam = seams.back();
                const double length = lengths[i];
                seam.a.parts.push_back({i, length});
                seam.b.parts.insert(seam.b.parts.begin(), {mate.edge, length});
                seam.length += length;
            }
            last_mate = mine ? mate : Edge{};
            last_chain = chain;
        }
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
        tiles.push_back(make_tile("G" + std::to_string(g + 1), mesh, {.warp = Vec3::UnitZ()}));
        at += angle;
    }
    return sewn(std::move(tiles));
}

double worst_mismatch(const Envelope& envelope, const std::vector<Points2>& flats) {
    double worst = 0;
    for (const Seam& seam : envelope.seams) {
        const Cumulated a = cumulated(envelope, flats, seam.a, true), b = cumulated(envelope, flats, seam.b, false);
        for (std::size_t k = 1; k < a.drawn.size(); ++k)
            worst = std::max(worst, std::abs(a.flat[k] - b.at(a.drawn[k])) / seam.length);
    }
    return worst;
}

}  // namespace ripstop::testing
