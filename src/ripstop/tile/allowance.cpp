#include "ripstop/tile/allowance.h"

#include <algorithm>

#include "ripstop/base/index.h"
#include "ripstop/tile/targets.h"

namespace ripstop {
namespace {

constexpr double no_length = 1e-5;  // length that counts as none [m]

using Tiles = std::vector<const Tile*>;

Tiles tiles_of(const CutPlan& plan) {
    Tiles tiles;
    for (const FlatTile& flat : plan.tiles) tiles.push_back(&flat.tile);
    return tiles;
}
Tiles tiles_of(const Envelope& envelope) {
    Tiles tiles;
    for (const Tile& tile : envelope.tiles) tiles.push_back(&tile);
    return tiles;
}

template <class Work>
void for_each_part(const std::vector<Seam>& seams, Work&& work) {
    for (const Seam& seam : seams)
        for (const SeamSide* side : seam.own_sides())
            for (const SeamPart& part : side->parts)
                work(static_cast<std::size_t>(side->tile), part, seam.allowance(*side));
}

/// The length of each boundary edge of each tile that is in no seam [m].
std::vector<Eigen::VectorXd> free_of_edges(const Tiles& tiles, const std::vector<Seam>& seams) {
    std::vector<Eigen::VectorXd> left;
    for (const Tile* tile : tiles) left.push_back(drawn_lengths(*tile));
    for_each_part(seams, [&](std::size_t t, const SeamPart& part, double) { left[t][part.edge] -= part.length; });
    for (Eigen::VectorXd& lengths : left) lengths = (lengths.array() > no_length).select(lengths, 0).eval();
    return left;
}

/// The chain that each boundary edge belongs to.
std::vector<std::size_t> chains_of_edges(const Tile& tile) {
    std::vector<std::size_t> leaving(static_cast<std::size_t>(tile.mesh.vertex_count()), 0), chains;
    for (std::size_t c = 0; c < tile.chains.size(); ++c)
        for (int i = 0; i < tile.chains[c].edge_count(); ++i) leaving[at(tile.chains[c].vertices[at(i)])] = c;
    for (const int v : tile.boundary) chains.push_back(leaving[at(v)]);
    return chains;
}

std::vector<Eigen::VectorXd> free_of_chains(const Tiles& tiles, const std::vector<Seam>& seams) {
    const std::vector<Eigen::VectorXd> left = free_of_edges(tiles, seams);
    std::vector<Eigen::VectorXd> lengths;
    for (std::size_t t = 0; t < tiles.size(); ++t) {
        const std::vector<std::size_t> chains = chains_of_edges(*tiles[t]);
        lengths.emplace_back(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(tiles[t]->chains.size())));
        for (Eigen::Index i = 0; i < left[t].size(); ++i)
            lengths[t][static_cast<Eigen::Index>(chains[at(i)])] += left[t][i];
    }
    return lengths;
}

std::vector<SeamTypeUse> uses_of(const Tiles& tiles, const std::vector<Seam>& seams) {
    std::vector<SeamTypeUse> uses;
    const auto use_of = [&](const SeamType& type) -> SeamTypeUse& {
        const auto known =
            std::find_if(uses.begin(), uses.end(), [&](const SeamTypeUse& use) { return use.type == type; });
        return known != uses.end() ? *known : uses.emplace_back(SeamTypeUse{type});
    };
    for (const Seam& seam : seams) {
        if (seam.into) continue;  // sewn together with the seam that contains it
        SeamTypeUse& use = use_of(seam.type);
        ++use.seams;
        use.length += seam.length;
    }
    const std::vector<Eigen::VectorXd> left = free_of_chains(tiles, seams);
    for (std::size_t t = 0; t < tiles.size(); ++t)
        for (std::size_t c = 0; c < tiles[t]->chains.size(); ++c) {
            const double length = left[t][static_cast<Eigen::Index>(c)];
            if (!(length > 0)) continue;
            SeamTypeUse& use = use_of(tiles[t]->chains[c].finish);
            ++use.free_edges;
            use.length += length;
        }
    return uses;
}

}  // namespace

std::vector<Eigen::VectorXd> edge_allowances(const CutPlan& plan) {
    const Tiles tiles = tiles_of(plan);
    std::vector<Eigen::VectorXd> allowances = free_of_edges(tiles, plan.seams);
    for (std::size_t t = 0; t < tiles.size(); ++t) {
        const std::vector<std::size_t> chains = chains_of_edges(*tiles[t]);
        for (Eigen::Index i = 0; i < allowances[t].size(); ++i)
            if (allowances[t][i] > 0) allowances[t][i] = tiles[t]->chains[chains[at(i)]].finish.allowance;
    }
    for_each_part(plan.seams, [&](std::size_t t, const SeamPart& part, double allowance) {
        allowances[t][part.edge] = std::max(allowances[t][part.edge], allowance);
    });
    return allowances;
}

std::vector<Eigen::VectorXd> free_lengths(const CutPlan& plan) {
    return free_of_chains(tiles_of(plan), plan.seams);
}

std::vector<Eigen::VectorXd> free_lengths(const Envelope& envelope) {
    return free_of_chains(tiles_of(envelope), envelope.seams);
}

std::vector<SeamTypeUse> seam_types_used(const CutPlan& plan) {
    return uses_of(tiles_of(plan), plan.seams);
}

std::vector<SeamTypeUse> seam_types_used(const Envelope& envelope) {
    return uses_of(tiles_of(envelope), envelope.seams);
}

}  // namespace ripstop
