#include "ripstop/pipeline/remesh/new_boundaries.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "ripstop/assembly/seams/seam_lengths.h"
#include "ripstop/assembly/seams/seam_runs.h"
#include "ripstop/pipeline/remesh/curve_division.h"
#include "ripstop/tile/seam_sheets.h"

namespace ripstop {
namespace {

constexpr double least_edge = 0.25;   // in edge lengths: a neighbour's vertices closer than this are not taken
constexpr double near_vertex = 1e-3;  // in edges: a new vertex closer than this to an old one takes its place

/// A new vertex of a chain, with the seam and part of the edge after it.
struct ChainNode {
    double at = 0;
    Vec3 position = Vec3::Zero();
    double length = 0;
    int seam = -1;
    bool is_side_b = false;
    std::size_t part = 0;
};

/// A part of a chain from the end of one seam to the next, without the vertex at its end.
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
        find_rounded();
    }

    NewBoundaries divide() {
        NewBoundaries result{std::vector<NewBoundary>(tiles_.size()), found_.seams};
        for (const Seam& seam : found_.seams)
            if (seam.into && !moves(seam.a.tile)) holds_staying_.insert(seam.into->seam);
        for (std::size_t s = 0; s < found_.seams.size(); ++s)
            if (!found_.seams[s].into) divide_seam(static_cast<int>(s), result.seams[s]);
        for (std::size_t s = 0; s < found_.seams.size(); ++s)
            if (found_.seams[s].into) divide_sheet(static_cast<int>(s), result.seams);
        for (std::size_t t = 0; t < tiles_.size(); ++t)
            if (moves(static_cast<int>(t))) result.tiles[t] = assemble(static_cast<int>(t), result.seams);
        for (Seam& seam : result.seams) {
            if (!seam.into) continue;
            const Seam& skin = result.seams[static_cast<std::size_t>(seam.into->seam)];
            const SeamSheet side{&skin, seam.into->backwards ? &skin.a : &skin.b, 0, skin.length,
                                 !seam.into->backwards};
            seam.b.parts = parts_between(side, seam.into->from, seam.into->from + seam.length);
        }
        return result;
    }

    const std::vector<bool>& coarse() const { return coarse_; }

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

    MeasuredCurve measured_side(int index, bool second) const {
        const Seam& seam = found_.seams[static_cast<std::size_t>(index)];
        const RunEnds& ends = found_.places[static_cast<std::size_t>(index)];
        return second ? measured_side(chain(chain_index(seam.b)), seam.b, ends.start_b, ends.end_b)
                      : measured_side(chain(chain_index(seam.a)), seam.a, ends.start_a, ends.end_a);
    }

    /// Whether the seam is known only as a polyline that turns too much for the tolerance.
    bool is_coarse(int index) const {
        const Seam& seam = found_.seams[static_cast<std::size_t>(index)];
        return conforms(chain(chain_index(seam.a)).curve, chain(chain_index(seam.b)).curve,
                        found_.places[static_cast<std::size_t>(index)]) &&
               std::max(turn_an_edge(measured_side(index, false)), turn_an_edge(measured_side(index, true))) >
                   most_turn_;
    }

    /// If one edge of a tile stays a polyline, all do, so that a wall is as wide above as below.
    void find_rounded() {
        for (std::size_t t = 0; t < tiles_.size(); ++t) rounded_.push_back(moves(static_cast<int>(t)));
        for (std::size_t s = 0; s < found_.seams.size(); ++s) coarse_.push_back(is_coarse(static_cast<int>(s)));
        for (bool changed = true; changed;) {
            changed = false;
            for (std::size_t s = 0; s < coarse_.size(); ++s) {
                const auto a = static_cast<std::size_t>(found_.seams[s].a.tile);
                const auto b = static_cast<std::size_t>(found_.seams[s].b.tile);
                if (!coarse_[s] || rounded_[a] == rounded_[b]) continue;
                rounded_[a] = rounded_[b] = false;
                changed = true;
            }
        }
    }

    void divide_seam(int index, Seam& seam) {
        const bool a_moves = moves(seam.a.tile), b_moves = moves(seam.b.tile);
        if (!a_moves && !b_moves) return;
        const MeasuredCurve on_a = measured_side(index, false), on_b = measured_side(index, true);
        double edge = 0;
        for (const int tile : {seam.a.tile, seam.b.tile})
            if (moves(tile) && (edge == 0 || edge_lengths_[static_cast<std::size_t>(tile)] < edge))
                edge = edge_lengths_[static_cast<std::size_t>(tile)];

        const bool one_stays = a_moves != b_moves;
        bool a_leads = on_a.breaks.size() >= on_b.breaks.size();
        if (coarse_[static_cast<std::size_t>(index)]) a_leads = turn_an_edge(on_a) >= turn_an_edge(on_b);
        if (one_stays) {
            const MeasuredCurve& staying = a_moves ? on_b : on_a;
            if (staying.length() >= least_edge * edge * static_cast<double>(staying.breaks.size() - 1))
                a_leads = b_moves;
        }
        const MeasuredCurve &lead = a_leads ? on_a : on_b, &other = a_leads ? on_b : on_a;
        const bool takes_over = one_stays && a_leads == b_moves;
        std::vector<double> places = takes_over                       ? refined(lead, edge)
                                     : serves(lead, edge, most_turn_) ? lead.breaks
                                                                      : divided(lead, edge);
        std::vector<double> lengths;
        const bool too_coarse = !holds_staying_.contains(index) && coarse_[static_cast<std::size_t>(index)] &&
                                rounded_[static_cast<std::size_t>(seam.a.tile)];
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

    /// A new vertex of a seam's side: its distance along the side and its place.
    struct Knot {
        double along;
        Vec3 position;
    };
    std::vector<Knot> knots_of(const Seam& seam, int index, bool is_side_b) const {
        const SeamSide& side = is_side_b ? seam.b : seam.a;
        const PlacedChain& placed = chain(chain_index(side));
        std::vector<Knot> knots;
        double along = 0;
        for (const Stretch& stretch : stretches_[static_cast<std::size_t>(chain_index(side))]) {
            if (stretch.nodes.front().seam != index || stretch.nodes.front().is_side_b != is_side_b) continue;
            for (const ChainNode& node : stretch.nodes) {
                knots.push_back({along, node.position});
                along += node.length;
            }
            knots.push_back({along, point_at(placed.curve, stretch.to)});
            return knots;
        }
        const RunEnds& ends = found_.places[static_cast<std::size_t>(index)];
        const MeasuredCurve measured =
            measured_side(placed, side, is_side_b ? ends.start_b : ends.start_a, is_side_b ? ends.end_b : ends.end_a);
        for (std::size_t k = 0; k < measured.breaks.size(); ++k)
            knots.push_back({measured.stations[k], point_at(placed.curve, measured.breaks[k])});
        return knots;
    }

    /// Gives an additional sheet in a seam the vertices of the side that it hangs on.
    void divide_sheet(int index, std::vector<Seam>& seams) {
        const Seam& before = found_.seams[static_cast<std::size_t>(index)];
        Seam& sheet = seams[static_cast<std::size_t>(index)];
        const int skin = before.into->seam;
        const bool on_b = !before.into->backwards;
        const double scale =
            seams[static_cast<std::size_t>(skin)].length / found_.seams[static_cast<std::size_t>(skin)].length;
        sheet.length *= scale;
        sheet.into->from *= scale;
        if (!moves(before.a.tile)) return;
        const RunEnds& ends = found_.places[static_cast<std::size_t>(index)];
        const PlacedChain &own = chain(chain_index(before.a)), &mate = chain(chain_index(before.b));
        const MeasuredCurve curve = measured_side(own, before.a, ends.start_a, ends.end_a);
        const double whole = seams[static_cast<std::size_t>(skin)].length;
        const double low = on_b ? whole - sheet.into->from - sheet.length : sheet.into->from;
        const double high = low + sheet.length, near = near_vertex * sheet.length * 1e-3;
        std::vector<Knot> knots{{high, point_at(mate.curve, ends.end_b)}};
        std::vector<Knot> all = knots_of(seams[static_cast<std::size_t>(skin)], skin, on_b);
        std::reverse(all.begin(), all.end());
        for (const Knot& knot : all)
            if (knot.along > low + near && knot.along < high - near) knots.push_back(knot);
        if (ends.start_a == std::round(ends.start_a)) knots.front().position = point_at(own.curve, ends.start_a);
        Stretch stretch{curve.breaks.front(), curve.breaks.back(), {}};
        for (std::size_t k = 0; k < knots.size(); ++k) {
            const double next = k + 1 < knots.size() ? knots[k + 1].along : low;
            const double at = k == 0 ? curve.breaks.front() : curve.place_of((high - knots[k].along) / scale);
            stretch.nodes.push_back({at, knots[k].position, knots[k].along - next, index, false, k});
        }
        sheet.a.parts.resize(knots.size());
        stretches_[static_cast<std::size_t>(chain_index(before.a))].push_back(std::move(stretch));
    }

    /// One side of a divided seam: its own curve, its mate's, and its vertices on its own curve, ascending.
    struct DividedSide {
        int seam;
        bool is_side_b;
        const MeasuredCurve* own;
        const MeasuredCurve* mate;
        std::vector<double> at;
    };

    /// `on_lead`: the same vertices on the curve that both sides follow. At its ends each side keeps its own corner, or
    /// takes its mate's if it has none there.
    void add_stretch(const DividedSide& side, const MeasuredCurve& lead, const std::vector<double>& on_lead,
                     const std::vector<double>& lengths) {
        Stretch stretch{side.own->breaks.front(), side.own->breaks.back(), {}};
        for (std::size_t k = 0; k < lengths.size(); ++k)
            stretch.nodes.push_back(
                {side.at[k], point_at(*lead.curve, on_lead[k]), lengths[k], side.seam, side.is_side_b, k});
        const double start = stretch.from, beside = side.mate->breaks.back();  // the mate runs the other way
        if (start == std::round(start))
            stretch.nodes.front().position = point_at(*side.own->curve, start);
        else if (beside == std::round(beside))
            stretch.nodes.front().position = point_at(*side.mate->curve, beside);
        const Seam& seam = found_.seams[static_cast<std::size_t>(side.seam)];
        stretches_[static_cast<std::size_t>(chain_index(side.is_side_b ? seam.b : seam.a))].push_back(
            std::move(stretch));
    }

    Stretch loose_stretch(int index, double from, double to, double edge) const {
        const ChainCurve& curve = chain(index).curve;
        const MeasuredCurve polyline = make_measured_by_chords(curve, from, to);
        const bool too_coarse =
            rounded_[static_cast<std::size_t>(chain(index).tile)] && turn_an_edge(polyline) > most_turn_;
        const MeasuredCurve drawn = too_coarse ? make_measured_by_arc(curve, from, to) : polyline;
        const std::vector<double> places = serves(polyline, edge, most_turn_) ? polyline.breaks : divided(drawn, edge);
        Stretch stretch{from, to, {}};
        for (std::size_t k = 0; k + 1 < places.size(); ++k)
            stretch.nodes.push_back({places[k], point_at(curve, places[k]),
                                     drawn.station_of(places[k + 1]) - drawn.station_of(places[k]), -1});
        return stretch;
    }

    /// The seams along a chain in order, with the loose parts between them. Gaps and overlaps within two tolerances are
    /// ignored: two corners that meet there are one vertex of this chain.
    std::vector<Stretch> stretches_of(int index, double edge) const {
        const ChainCurve& curve = chain(index).curve;
        const double size = curve.edge_count();
        std::vector<Stretch> sewn = stretches_[static_cast<std::size_t>(index)];
        if (sewn.empty()) return {loose_stretch(index, 0, size, edge)};
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
            if (apart(reached, stretch.from)) all.push_back(loose_stretch(index, reached, stretch.from, edge));
            reached = stretch.to;
            all.push_back(std::move(stretch));
        }
        if (!curve.closed && apart(reached, size)) all.push_back(loose_stretch(index, reached, size, edge));
        if (!curve.closed) {  // the chain begins at its corner
            all.front().nodes.front().at = 0;
            all.front().nodes.front().position = point_at(curve, 0);
        }
        return all;
    }

    /// The vertices of a chain in order.
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

    /// Also sets the parts of the seams along the tile.
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
        // A single corner must not begin the boundary, or it would count as no corner.
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
        if (share > 1 - near_vertex) edge += 1;
        if (share > 1 - near_vertex || share < near_vertex) share = 0;
        return {(placed.first_edge + static_cast<int>(edge)) % placed.boundary_edges, share};
    }

    const std::vector<Tile>& tiles_;
    const FoundSeams& found_;
    const std::vector<double>& edge_lengths_;
    double most_turn_, tolerance_;
    std::vector<PlacedChain> chains_;
    std::vector<int> first_chain_;
    std::vector<std::vector<Stretch>> stretches_;  ///< per chain
    std::vector<bool> coarse_;                     ///< per seam (`is_coarse`)
    std::vector<bool> rounded_;                    ///< per tile: its coarse polylines become curves
    std::set<int> holds_staying_;                  ///< seams that contain a sheet with an unchanged mesh
};

}  // namespace

NewBoundaries divide_boundaries(const std::vector<Tile>& tiles, const FoundSeams& found,
                                const std::vector<double>& edge_lengths, double length_tolerance,
                                double seam_tolerance) {
    return Divider(tiles, found, edge_lengths, length_tolerance, seam_tolerance).divide();
}

std::vector<bool> find_coarse_seams(const std::vector<Tile>& tiles, const FoundSeams& found, double length_tolerance) {
    const std::vector<double> none(tiles.size(), 0);
    return Divider(tiles, found, none, length_tolerance, 0).coarse();
}

}  // namespace ripstop
