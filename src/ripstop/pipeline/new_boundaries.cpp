#include "ripstop/pipeline/new_boundaries.h"

#include <algorithm>
#include <cmath>

#include "ripstop/assembly/seam_lengths.h"
#include "ripstop/assembly/seam_runs.h"
#include "ripstop/pipeline/curve_division.h"

namespace ripstop {
namespace {

constexpr double densest = 0.25;      // edge lengths: a neighbour's vertices nearer than this are not taken
constexpr double same_vertex = 1e-3;  // of an edge: so near a vertex a new one is put in its place

/// A new vertex of a chain, and which part of which seam the edge after it is.
struct ChainNode {
    double at = 0;
    Vec3 position = Vec3::Zero();
    double length = 0;
    int seam = -1;
    bool is_side_b = false;
    std::size_t part = 0;
};

/// A stretch of a chain from one seam's end to the next, without the vertex at its end.
struct Stretch {
    double from = 0, to = 0;
    std::vector<ChainNode> nodes;
};

class Divider {
  public:
    Divider(const std::vector<Tile>& tiles, const FoundSeams& found, const std::vector<double>& edge_lengths,
            double length_tolerance, double seam_tolerance)
        : tiles_(tiles),
          found_(found),
          edge_lengths_(edge_lengths),
          most_turn_(std::sqrt(24 * length_tolerance / 2)),
          tolerance_(seam_tolerance),
          chains_(place_chains(tiles)),
          stretches_(chains_.size()) {
        int first = 0;
        for (const Tile& tile : tiles) {
            first_chain_.push_back(first);
            first += static_cast<int>(tile.chains.size());
        }
    }

    NewBoundaries divide() {
        NewBoundaries result{std::vector<NewBoundary>(tiles_.size()), found_.seams};
        for (std::size_t s = 0; s < found_.seams.size(); ++s) divide_seam(static_cast<int>(s), result.seams[s]);
        for (std::size_t t = 0; t < tiles_.size(); ++t)
            if (moves(static_cast<int>(t))) result.tiles[t] = assemble(static_cast<int>(t), result.seams);
        return result;
    }

  private:
    bool moves(int tile) const { return edge_lengths_[static_cast<std::size_t>(tile)] > 0; }
    int chain_index(const SeamSide& side) const {
        return first_chain_[static_cast<std::size_t>(side.tile)] + side.chain;
    }
    const PlacedChain& chain(int index) const { return chains_[static_cast<std::size_t>(index)]; }

    static MeasuredCurve measured_side(const PlacedChain& chain, const SeamSide& side, double low, double high) {
        std::vector<double> lengths;
        for (const SeamPart& part : side.parts) lengths.push_back(part.length);
        return make_measured(chain.curve, low, high, lengths);
    }

    void divide_seam(int index, Seam& seam) {
        const bool a_moves = moves(seam.a.tile), b_moves = moves(seam.b.tile);
        if (!a_moves && !b_moves) return;
        const PlacedChain &a = chain(chain_index(seam.a)), &b = chain(chain_index(seam.b));
        const RunEnds& ends = found_.places[static_cast<std::size_t>(index)];
        const MeasuredCurve on_a = measured_side(a, seam.a, ends.start_a, ends.end_a);
        const MeasuredCurve on_b = measured_side(b, seam.b, ends.start_b, ends.end_b);
        double edge = 0;
        for (const int tile : {seam.a.tile, seam.b.tile})
            if (moves(tile) && (edge == 0 || edge_lengths_[static_cast<std::size_t>(tile)] < edge))
                edge = edge_lengths_[static_cast<std::size_t>(tile)];

        const bool one_stays = a_moves != b_moves;
        bool a_leads = on_a.breaks.size() >= on_b.breaks.size();
        if (one_stays) {
            const MeasuredCurve& staying = a_moves ? on_b : on_a;
            if (staying.length() >= densest * edge * static_cast<double>(staying.breaks.size() - 1)) a_leads = b_moves;
        }
        const MeasuredCurve &lead = a_leads ? on_a : on_b, &other = a_leads ? on_b : on_a;
        const bool takes_over = one_stays && a_leads == b_moves;
        std::vector<double> places = takes_over                       ? refined(lead, edge)
                                     : serves(lead, edge, most_turn_) ? lead.breaks
                                                                      : divided(lead, edge);
        std::vector<double> lengths;
        const bool too_coarse = !one_stays && conforms(a.curve, b.curve, ends) && turn_an_edge(lead) > most_turn_;
        const MeasuredCurve drawn =
            too_coarse ? make_measured_by_arc(*lead.curve, places.front(), places.back()) : lead;
        for (std::size_t k = 0; k + 1 < places.size(); ++k)
            lengths.push_back(drawn.station_of(places[k + 1]) - drawn.station_of(places[k]));
        if (too_coarse) {
            seam.length = drawn.length();
            seam.uncertainty = open_length(*lead.curve, places.front(), places.back());
        }
        if (a_leads ? a_moves : b_moves) {
            add_stretch({index, !a_leads, &lead, &other, places}, lead, places, lengths);
            (a_leads ? seam.a : seam.b).parts.resize(lengths.size());
        }
        if (!(a_leads ? b_moves : a_moves)) return;
        std::vector<double> across;
        for (const double at : places) across.push_back(other.place_of(other.length() - lead.station_of(at)));
        across.front() = other.breaks.back();
        across.back() = other.breaks.front();
        for (std::vector<double>* list : {&across, &places, &lengths}) std::reverse(list->begin(), list->end());
        add_stretch({index, a_leads, &other, &lead, across}, lead, places, lengths);
        (a_leads ? seam.b : seam.a).parts.resize(lengths.size());
    }

    /// One side of a seam that is divided: its own curve and its mate's, and its vertices on its own, ascending.
    struct DividedSide {
        int seam;
        bool is_side_b;
        const MeasuredCurve* own;
        const MeasuredCurve* mate;
        std::vector<double> at;
    };

    /// `on_lead`: the same vertices on the curve that both sides follow. At its ends each side keeps its own corner; where it
    /// has none there it takes its mate's.
    void add_stretch(const DividedSide& side, const MeasuredCurve& lead, const std::vector<double>& on_lead,
                     const std::vector<double>& lengths) {
        Stretch stretch{side.own->breaks.front(), side.own->breaks.back(), {}};
        for (std::size_t k = 0; k < lengths.size(); ++k)
            stretch.nodes.push_back(
                {side.at[k], point_at(*lead.curve, on_lead[k]), lengths[k], side.seam, side.is_side_b, k});
        const double start = stretch.from, beside = side.mate->breaks.back();  // it runs the other way
        if (start == std::round(start))
            stretch.nodes.front().position = point_at(*side.own->curve, start);
        else if (beside == std::round(beside))
            stretch.nodes.front().position = point_at(*side.mate->curve, beside);
        const Seam& seam = found_.seams[static_cast<std::size_t>(side.seam)];
        stretches_[static_cast<std::size_t>(chain_index(side.is_side_b ? seam.b : seam.a))].push_back(
            std::move(stretch));
    }

    Stretch loose_stretch(const ChainCurve& curve, double from, double to, double edge) const {
        const MeasuredCurve polyline = make_measured_by_chords(curve, from, to);
        const bool too_coarse = turn_an_edge(polyline) > most_turn_;
        const MeasuredCurve drawn = too_coarse ? make_measured_by_arc(curve, from, to) : polyline;
        const std::vector<double> places = serves(polyline, edge, most_turn_) ? polyline.breaks : divided(drawn, edge);
        Stretch stretch{from, to, {}};
        for (std::size_t k = 0; k + 1 < places.size(); ++k)
            stretch.nodes.push_back({places[k], point_at(curve, places[k]),
                                     drawn.station_of(places[k + 1]) - drawn.station_of(places[k]), -1});
        return stretch;
    }

    /// The seams along a chain in its order, what lies loose between them too. A gap or an overlap within two tolerances is
    /// none: two corners that meet there are one vertex of this chain.
    std::vector<Stretch> stretches_of(int index, double edge) const {
        const ChainCurve& curve = chain(index).curve;
        const double size = curve.edge_count();
        std::vector<Stretch> sewn = stretches_[static_cast<std::size_t>(index)];
        if (sewn.empty()) return {loose_stretch(curve, 0, size, edge)};
        for (Stretch& stretch : sewn) {
            const double laps = curve.closed ? std::floor(stretch.from / size) : 0;
            stretch.from -= laps * size;
            stretch.to -= laps * size;
            for (ChainNode& node : stretch.nodes) node.at -= laps * size;
        }
        std::sort(sewn.begin(), sewn.end(), [](const Stretch& p, const Stretch& q) { return p.from < q.from; });
        const auto apart = [&](double from, double to) {
            return station_at(curve, to) - station_at(curve, from) > 2 * tolerance_;
        };
        std::vector<Stretch> all;
        double reached = curve.closed ? sewn.back().to - size : 0;
        for (Stretch& stretch : sewn) {
            if (apart(reached, stretch.from)) all.push_back(loose_stretch(curve, reached, stretch.from, edge));
            reached = stretch.to;
            all.push_back(std::move(stretch));
        }
        if (!curve.closed && apart(reached, size)) all.push_back(loose_stretch(curve, reached, size, edge));
        if (!curve.closed) {  // the chain begins at its corner, whatever came first
            all.front().nodes.front().at = 0;
            all.front().nodes.front().position = point_at(curve, 0);
        }
        return all;
    }

    /// The vertices of a chain in its order.
    std::vector<ChainNode> nodes_of(int index, double edge) const {
        const ChainCurve& curve = chain(index).curve;
        std::vector<ChainNode> nodes;
        for (const Stretch& stretch : stretches_of(index, edge))
            nodes.insert(nodes.end(), stretch.nodes.begin(), stretch.nodes.end());
        if (!curve.closed) return nodes;
        const double size = curve.edge_count();
        for (ChainNode& node : nodes) node.at -= std::floor(node.at / size) * size;
        const auto before = [](const ChainNode& p, const ChainNode& q) { return p.at < q.at; };
        std::rotate(nodes.begin(), std::min_element(nodes.begin(), nodes.end(), before), nodes.end());
        return nodes;
    }

    /// Sets the parts of the seams along the tile too.
    NewBoundary assemble(int t, std::vector<Seam>& seams) const {
        const Tile& tile = tiles_[static_cast<std::size_t>(t)];
        const Eigen::Index size = static_cast<Eigen::Index>(tile.boundary.size());
        NewBoundary boundary;
        boundary.slopes = {Points3::Zero(size, 3), Points3::Zero(size, 3)};
        std::vector<ChainNode> all;
        for (std::size_t c = 0; c < tile.chains.size(); ++c) {
            const int index = first_chain_[static_cast<std::size_t>(t)] + static_cast<int>(c);
            const PlacedChain& placed = chain(index);
            for (int e = 0; e < placed.curve.edge_count(); ++e) {
                const Eigen::Index edge = (placed.first_edge + e) % placed.boundary_edges;
                boundary.slopes.start.row(edge) = placed.curve.start_slopes.row(e);
                boundary.slopes.end.row(edge) = placed.curve.end_slopes.row(e);
            }
            boundary.chain_starts.push_back(static_cast<int>(all.size()));
            for (const ChainNode& node : nodes_of(index, edge_lengths_[static_cast<std::size_t>(t)])) {
                all.push_back(node);
                boundary.nodes.push_back({place_on_boundary(placed, node.at), node.position, node.length});
            }
        }
        // A corner that is the only one does not begin the boundary, else it would be taken for none.
        if (tile.chains.size() == 1 && tile.chains.front().vertices.front() != tile.boundary.front()) {
            std::rotate(boundary.nodes.begin(), boundary.nodes.begin() + 1, boundary.nodes.end());
            std::rotate(all.begin(), all.begin() + 1, all.end());
            boundary.chain_starts.front() = static_cast<int>(all.size()) - 1;
        }
        for (std::size_t v = 0; v < all.size(); ++v) {
            if (all[v].seam < 0) continue;
            Seam& seam = seams[static_cast<std::size_t>(all[v].seam)];
            (all[v].is_side_b ? seam.b : seam.a).parts[all[v].part] = {static_cast<int>(v), all[v].length};
        }
        return boundary;
    }

    static BoundaryPlace place_on_boundary(const PlacedChain& placed, double at) {
        double edge = std::floor(at), share = at - edge;
        if (share > 1 - same_vertex) edge += 1;
        if (share > 1 - same_vertex || share < same_vertex) share = 0;
        return {(placed.first_edge + static_cast<int>(edge)) % placed.boundary_edges, share};
    }

    const std::vector<Tile>& tiles_;
    const FoundSeams& found_;
    const std::vector<double>& edge_lengths_;
    double most_turn_, tolerance_;
    std::vector<PlacedChain> chains_;
    std::vector<int> first_chain_;
    std::vector<std::vector<Stretch>> stretches_;  ///< of each chain
};

}  // namespace

NewBoundaries divide_boundaries(const std::vector<Tile>& tiles, const FoundSeams& found,
                                const std::vector<double>& edge_lengths, double length_tolerance,
                                double seam_tolerance) {
    return Divider(tiles, found, edge_lengths, length_tolerance, seam_tolerance).divide();
}

}  // namespace ripstop
