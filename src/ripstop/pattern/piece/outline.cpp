#include "ripstop/pattern/piece/outline.h"

#include <algorithm>
#include <map>

#include "ripstop/base/index.h"
#include "ripstop/geometry/polygon.h"
#include "ripstop/geometry/simplify.h"
#include "ripstop/pattern/piece/pieces.h"
#include "ripstop/tile/allowance.h"
#include "ripstop/tile/seam_sheets.h"
#include "ripstop/tile/targets.h"

namespace ripstop {
namespace {

constexpr double same_allowance = 1e-6;  // [m]

/// The part of a boundary edge that a seam covers on a tile; one for each sheet that lies there.
struct SewnPart {
    const Seam* seam = nullptr;
    const SeamType* type = nullptr;  ///< the type for this tile's side
    int mate = 0;                    ///< tile
    double flat_length = 0;
};
using SewnParts = std::vector<std::vector<SewnPart>>;

std::size_t boundary_size(const FlatTile& tile) {
    return tile.tile.boundary.size();
}

double flat_edge(const FlatTile& tile, std::size_t edge) {
    const std::vector<int>& loop = tile.tile.boundary;
    return (tile.flattening.positions.row(loop[(edge + 1) % loop.size()]) - tile.flattening.positions.row(loop[edge]))
        .norm();
}

std::vector<SewnParts> sewn_parts(const CutPlan& plan) {
    std::vector<SewnParts> parts;
    for (const FlatTile& tile : plan.tiles) parts.emplace_back(boundary_size(tile));
    const auto add = [&](const Seam& seam, const SeamSheet& sheet, const SeamSheet& mate) {
        const int t = sheet.side->tile;
        const FlatTile& tile = plan.tiles[at(t)];
        const double from = std::max(sheet.from, mate.from), to = std::min(sheet.to, mate.to);
        if (!tile.is_flat() || !(from < to)) return;
        const Eigen::VectorXd drawn = drawn_lengths(tile.tile);
        for (const SeamPart& part : parts_between(sheet, from, to)) {
            const auto edge = static_cast<std::size_t>(part.edge);
            parts[at(t)][edge].push_back(
                {&seam, &sheet.record->type, mate.side->tile, flat_edge(tile, edge) * part.length / drawn[part.edge]});
        }
    };
    const std::vector<std::vector<SeamSheet>> sheets = sheets_of_seams(plan.seams);
    for (std::size_t s = 0; s < sheets.size(); ++s)
        for (const SeamSheet& sheet : sheets[s])
            for (const SeamSheet& mate : sheets[s])
                if (&sheet != &mate) add(plan.seams[s], sheet, mate);
    return parts;
}

/// Maps each boundary vertex to the chain of the edge that starts there.
std::map<int, std::size_t> chains_from(const Tile& tile) {
    std::map<int, std::size_t> chain_of;
    for (std::size_t c = 0; c < tile.chains.size(); ++c)
        for (int i = 0; i < tile.chains[c].edge_count(); ++i) chain_of[tile.chains[c].vertices[at(i)]] = c;
    return chain_of;
}

/// How an edge is sewn or, if it is free, finished.
struct SewnAs {
    bool is_free;
    SeamType type;

    bool operator==(const SewnAs&) const = default;
};

/// How each boundary edge is sewn or finished.
std::vector<SewnAs> sewn_as(const Tile& tile, const SewnParts& parts) {
    const std::map<int, std::size_t> chain_of = chains_from(tile);
    std::vector<SewnAs> found;
    for (std::size_t i = 0; i < tile.boundary.size(); ++i) {
        const auto longest = std::max_element(parts[i].begin(), parts[i].end(), [](const auto& a, const auto& b) {
            return a.flat_length < b.flat_length;
        });
        const bool is_free = longest == parts[i].end();
        found.push_back({is_free, is_free ? tile.chains[chain_of.at(tile.boundary[i])].finish : *longest->type});
    }
    return found;
}

/// The boundary edges that start a piece's edge: at corners, and where the seam type or the allowance changes.
std::vector<std::size_t> starts(const Tile& tile, const std::vector<SewnAs>& sewn, const Eigen::VectorXd& allowances) {
    const std::size_t count = tile.boundary.size();
    std::vector<bool> corner(static_cast<std::size_t>(tile.mesh.vertex_count()), false);
    if (tile.chains.size() > 1)
        for (const Chain& chain : tile.chains) corner[at(chain.vertices.front())] = true;
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < count; ++i) {
        const auto here = static_cast<Eigen::Index>(i), before = static_cast<Eigen::Index>((i + count - 1) % count);
        if (corner[at(tile.boundary[i])] || !(sewn[i] == sewn[(i + count - 1) % count]) ||
            std::abs(allowances[here] - allowances[before]) > same_allowance)
            found.push_back(i);
    }
    if (found.empty()) found.push_back(0);
    return found;
}

/// The mates of an edge and their seams.
class Mates {
  public:
    void add(const SewnPart& part, const CutPlan& plan) {
        const std::pair<const Seam*, int> mate(part.seam, part.mate);
        auto at = std::find(mates_.begin(), mates_.end(), mate);
        if (at == mates_.end()) {
            at = mates_.insert(at, mate);
            list.push_back(
                {part.seam->id, plan.tiles[static_cast<std::size_t>(part.mate)].tile.name, 0, part.type->name});
        }
        list[static_cast<std::size_t>(at - mates_.begin())].length += part.flat_length;
    }

    std::vector<Mate> list;

  private:
    std::vector<std::pair<const Seam*, int>> mates_;
};

PieceOutline make_outline(const CutPlan& plan, const FlatTile& flat, const SewnParts& parts,
                          const Eigen::VectorXd& allowances, double chord_error) {
    const Tile& tile = flat.tile;
    const std::size_t count = tile.boundary.size();
    const std::vector<SewnAs> sewn = sewn_as(tile, parts);
    const std::vector<std::size_t> first = starts(tile, sewn, allowances);
    PieceOutline outline;
    outline.edge_of.resize(count);
    std::vector<Vec2> points;
    for (std::size_t e = 0; e < first.size(); ++e) {
        const std::size_t steps = e + 1 < first.size() ? first[e + 1] - first[e] : first[0] + count - first[e];
        PieceEdge edge;
        edge.first = static_cast<int>(points.size());
        edge.allowance = allowances[static_cast<Eigen::Index>(first[e])];
        Mates mates;
        Points2 line(static_cast<Eigen::Index>(steps + 1), 2);
        for (std::size_t i = 0; i <= steps; ++i) {
            const std::size_t at = (first[e] + i) % count;
            line.row(static_cast<Eigen::Index>(i)) = flat.flattening.positions.row(tile.boundary[at]);
            if (i == steps) break;
            outline.edge_of[at] = static_cast<int>(e);
            edge.length += flat_edge(flat, at);
            for (const SewnPart& part : parts[at]) mates.add(part, plan);
        }
        edge.seam_type = sewn[first[e]].type.name;
        edge.mates = std::move(mates.list);
        line = simplified(line, chord_error);
        for (Eigen::Index i = 0; i + 1 < line.rows(); ++i) points.emplace_back(line.row(i));
        outline.edges.push_back(std::move(edge));
    }
    outline.sew_line.resize(static_cast<Eigen::Index>(points.size()), 2);
    for (std::size_t i = 0; i < points.size(); ++i) outline.sew_line.row(static_cast<Eigen::Index>(i)) = points[i];
    if (signed_area(outline.sew_line) < 0) {  // a failed flattening: it can be viewed but not sewn
        outline.sew_line = outline.sew_line.colwise().reverse().eval();
        outline.edges.clear();
    }
    return outline;
}

}  // namespace

std::vector<PieceOutline> make_outlines(const CutPlan& plan, double chord_error) {
    const std::vector<SewnParts> parts = sewn_parts(plan);
    const std::vector<Eigen::VectorXd> allowances = edge_allowances(plan);
    std::vector<PieceOutline> outlines(plan.tiles.size());
    for (std::size_t t = 0; t < plan.tiles.size(); ++t)
        if (plan.tiles[t].is_flat())
            outlines[t] = make_outline(plan, plan.tiles[t], parts[t], allowances[t], chord_error);
    return outlines;
}

}  // namespace ripstop
