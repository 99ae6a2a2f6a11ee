#include "ripstop/assembly/seams/seam_lengths.h"

#include <algorithm>
#include <cmath>

#include "ripstop/assembly/seams/limits.h"
#include "ripstop/base/index.h"
#include "ripstop/mesh/boundary.h"

namespace ripstop {
namespace {

constexpr double coincident_share = 1e-6;  // share of the seam's length: vertices this close coincide

const PlacedChain& chain_of(const std::vector<PlacedChain>& chains, int c) {
    return chains[at(c)];
}

double at_vertex(const ChainCurve& curve, double at, double tolerance) {
    const double vertex = std::round(at);
    return std::abs(station_at(curve, at) - station_at(curve, vertex)) < tolerance ? vertex : at;
}

bool is_vertex(double at) {
    return at == std::round(at);
}

int local_edge(const ChainCurve& curve, double at) {
    const int count = curve.edge_count();
    return ((static_cast<int>(std::floor(at)) % count) + count) % count;
}

int boundary_edge(const PlacedChain& chain, double at) {
    return (chain.first_edge + local_edge(chain.curve, at)) % chain.boundary_edges;
}

/// The largest turn of an edge and its neighbours; a single edge is not enough where the curvature changes.
double turn_about(const ChainCurve& curve, int edge) {
    if (curve.unseen_turn > 0) return curve.unseen_turn;
    const int last = curve.edge_count() - 1;
    return std::max({turn_of_edge(curve, std::max(edge - 1, 0)), turn_of_edge(curve, edge),
                     turn_of_edge(curve, std::min(edge + 1, last))});
}

/// Three sums over the edges of a run: the uncertainty of their length, the error of the polyline, and its length.
struct Openness {
    double estimate = 0, sagging = 0, polyline = 0;
    int edges = 0;
};
Openness openness(const ChainCurve& curve, double low, double high) {
    Openness sum;
    const std::vector<double> breaks = breaks_between(low, high);
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
        const int edge = local_edge(curve, breaks[k]);
        const double part = (breaks[k + 1] - breaks[k]) * chord_of_edge(curve, edge);
        const double turn = turn_about(curve, edge), short_by = part * turn * turn / 24;
        sum.sagging += short_by;
        sum.estimate += short_by * (curve.unseen_turn > 0 ? 1.0 : std::min(1.0, turn * turn / 2));
        sum.polyline += part;
        ++sum.edges;
    }
    return sum;
}

/// Arc lengths on the master curve, from its start, of the breaks of the other side. Breaks ascend on that side,
/// so the result descends. Each vertex is projected; if that would squeeze an edge, all are placed in proportion.
std::vector<double> projected(const ChainCurve& master, const ChainCurve& other, const std::vector<double>& breaks,
                              const Run& run, bool master_is_a, const RunEnds& ends) {
    const double master_low = master_is_a ? ends.start_a : ends.start_b;
    const double master_high = master_is_a ? ends.end_a : ends.end_b;
    const double low = station_at(master, master_low), high = station_at(master, master_high);
    std::vector<double> places(breaks.size());
    places.front() = high;
    places.back() = low;
    for (const Touch& touch : run.touches) {
        const double mine = master_is_a ? touch.at_b : touch.at_a;
        const auto found = std::lower_bound(breaks.begin() + 1, breaks.end() - 1, mine);
        if (found == breaks.end() - 1 || *found != mine) continue;
        places[at(found - breaks.begin())] = station_at(master, master_is_a ? touch.at_a : touch.at_b);
    }
    const double from = station_at(other, breaks.front()), to = station_at(other, breaks.back());
    const double stretch = (high - low) / (to - from);
    bool fair = true;
    for (std::size_t k = 0; k + 1 < breaks.size() && fair; ++k) {
        const double own = stretch * (station_at(other, breaks[k + 1]) - station_at(other, breaks[k]));
        const double part = places[k] - places[k + 1];
        fair = part > fair_share_low * own && part < fair_share_high * own;
    }
    if (fair) return places;
    for (std::size_t k = 1; k + 1 < breaks.size(); ++k)
        places[k] = high - stretch * (station_at(other, breaks[k]) - from);
    return places;
}

SeamSide make_side(const PlacedChain& chain, const std::vector<double>& breaks, const std::vector<double>& lengths) {
    SeamSide side{chain.tile, chain.chain, {}};
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
        side.parts.push_back({boundary_edge(chain, breaks[k]), lengths[k]});
    return side;
}

std::vector<double> chords(const ChainCurve& curve, const std::vector<double>& breaks) {
    std::vector<double> lengths;
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
        lengths.push_back(chord_of_edge(curve, local_edge(curve, breaks[k])));
    return lengths;
}

/// Distances between neighbouring stations, in either direction.
std::vector<double> steps(const std::vector<double>& stations) {
    std::vector<double> lengths;
    for (std::size_t k = 0; k + 1 < stations.size(); ++k) lengths.push_back(std::abs(stations[k + 1] - stations[k]));
    return lengths;
}

}  // namespace

bool conforms(const ChainCurve& a, const ChainCurve& b, const RunEnds& ends) {
    const double count = ends.end_a - ends.start_a;
    if (!is_vertex(ends.start_a) || !is_vertex(ends.end_a) || !is_vertex(ends.start_b) || !is_vertex(ends.end_b) ||
        count != ends.end_b - ends.start_b)
        return false;
    const double near = coincident_share * (station_at(a, ends.end_a) - station_at(a, ends.start_a));
    for (double k = 0; k <= count; ++k)
        if ((point_at(a, ends.start_a + k) - point_at(b, ends.end_b - k)).norm() > near) return false;
    return true;
}

double open_length(const ChainCurve& curve, double low, double high) {
    return openness(curve, low, high).estimate;
}

RunEnds ends_of(const std::vector<PlacedChain>& chains, const Run& run, double tolerance) {
    const ChainCurve& a = chain_of(chains, run.a).curve;
    const ChainCurve& b = chain_of(chains, run.b).curve;
    return {at_vertex(a, run.start_a(), tolerance), at_vertex(a, run.end_a(), tolerance),
            at_vertex(b, run.low_b, tolerance), at_vertex(b, run.high_b, tolerance)};
}

Seam make_seam(const std::vector<PlacedChain>& chains, const Run& run, double tolerance) {
    const PlacedChain& a = chain_of(chains, run.a);
    const PlacedChain& b = chain_of(chains, run.b);
    const RunEnds ends = ends_of(chains, run, tolerance);
    const std::vector<double> breaks_a = breaks_between(ends.start_a, ends.end_a);
    const std::vector<double> breaks_b = breaks_between(ends.start_b, ends.end_b);
    const Openness open_a = openness(a.curve, ends.start_a, ends.end_a);
    const Openness open_b = openness(b.curve, ends.start_b, ends.end_b);
    const double own_a = station_at(a.curve, ends.end_a) - station_at(a.curve, ends.start_a);
    const double own_b = station_at(b.curve, ends.end_b) - station_at(b.curve, ends.start_b);

    Seam seam;
    seam.gap = run.gap;
    std::vector<double> lengths_a, lengths_b;
    if (conforms(a.curve, b.curve, ends)) {
        lengths_a = chords(a.curve, breaks_a);
        lengths_b.assign(lengths_a.rbegin(), lengths_a.rend());
        seam.uncertainty = open_a.sagging + open_a.estimate;
    } else {
        const bool master_is_a =
            open_a.edges != open_b.edges ? open_a.edges > open_b.edges : open_a.polyline >= open_b.polyline;
        const ChainCurve& master = master_is_a ? a.curve : b.curve;
        std::vector<double> stations;
        for (const double at : master_is_a ? breaks_a : breaks_b) stations.push_back(station_at(master, at));
        const std::vector<double> other = projected(master, master_is_a ? b.curve : a.curve,
                                                    master_is_a ? breaks_b : breaks_a, run, master_is_a, ends);
        lengths_a = steps(master_is_a ? stations : other);
        lengths_b = steps(master_is_a ? other : stations);
        seam.uncertainty = std::abs(own_a - own_b) + (master_is_a ? open_a : open_b).estimate;
    }
    for (const double length : lengths_a) seam.length += length;
    seam.a = make_side(a, breaks_a, lengths_a);
    seam.b = make_side(b, breaks_b, lengths_b);
    return seam;
}

std::vector<Eigen::VectorXd> curve_lengths_of(const std::vector<Tile>& tiles, const std::vector<PlacedChain>& chains,
                                              const std::vector<Seam>& seams, const std::vector<RunOnSeam>& runs,
                                              double tolerance) {
    std::vector<Eigen::VectorXd> lengths, covered;
    for (const Tile& tile : tiles) {
        lengths.push_back(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(tile.boundary.size())));
        covered.push_back(lengths.back());
    }
    const auto add = [&](const SeamSide& side, const PlacedChain& chain, double low, double high) {
        const std::vector<double> breaks = breaks_between(low, high);
        const std::size_t tile = static_cast<std::size_t>(side.tile);
        for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
            lengths[tile][side.parts[k].edge] += side.parts[k].length;
            covered[tile][boundary_edge(chain, breaks[k])] += breaks[k + 1] - breaks[k];
        }
    };
    for (std::size_t s = 0; s < seams.size(); ++s) {
        add(seams[s].a, chain_of(chains, runs[s].a), runs[s].ends.start_a, runs[s].ends.end_a);
        if (seams[s].into) continue;  // the seam it lies in has already set its mate's length
        add(seams[s].b, chain_of(chains, runs[s].b), runs[s].ends.start_b, runs[s].ends.end_b);
    }
    for (std::size_t t = 0; t < tiles.size(); ++t) {
        const Eigen::VectorXd chords = edge_lengths(tiles[t].mesh.positions, closed(tiles[t].boundary));
        bool own = true;
        for (Eigen::Index e = 0; e < chords.size(); ++e) {
            const double loose = (1 - covered[t][e]) * chords[e];
            if (covered[t][e] == 0 || loose > tolerance) lengths[t][e] += std::max(0.0, loose);
            own = own && std::abs(lengths[t][e] - chords[e]) <= 1e-12 * chords[e];
        }
        if (own) lengths[t].resize(0);
    }
    return lengths;
}

std::vector<LooseRun> loose_runs_of(const std::vector<Tile>& tiles, const std::vector<PlacedChain>& chains,
                                    const std::vector<RunOnSeam>& runs, double tolerance) {
    std::vector<std::vector<std::pair<double, double>>> covered(tiles.size());
    const auto add = [&](int c, double start, double end) {
        const PlacedChain& chain = chain_of(chains, c);
        const double size = chain.boundary_edges;
        double from = chain.first_edge + start, to = chain.first_edge + end;
        const double laps = std::floor(from / size);
        from -= laps * size;
        to -= laps * size;
        auto& mine = covered[static_cast<std::size_t>(chain.tile)];
        mine.push_back({from, std::min(to, size)});
        if (to > size) mine.push_back({0, to - size});
    };
    for (const RunOnSeam& run : runs) {
        add(run.a, run.ends.start_a, run.ends.end_a);
        add(run.b, run.ends.start_b, run.ends.end_b);
    }
    std::vector<LooseRun> loose;
    for (std::size_t t = 0; t < tiles.size(); ++t) {
        const double size = static_cast<double>(tiles[t].boundary.size());
        auto& mine = covered[t];
        if (mine.empty()) {
            loose.push_back({static_cast<int>(t), 0, size});
            continue;
        }
        std::sort(mine.begin(), mine.end());
        const Eigen::VectorXd chords = edge_lengths(tiles[t].mesh.positions, closed(tiles[t].boundary));
        const auto length_to = [&](double at) {
            const double whole = std::floor(at / size);
            at -= whole * size;
            const Eigen::Index edge = std::min(chords.size() - 1, static_cast<Eigen::Index>(at));
            return whole * chords.sum() + chords.head(edge).sum() + (at - static_cast<double>(edge)) * chords[edge];
        };
        double reached = mine.front().second;
        for (std::size_t k = 1; k <= mine.size(); ++k) {
            const double next = k < mine.size() ? mine[k].first : mine.front().first + size;
            if (length_to(next) - length_to(reached) > tolerance) loose.push_back({static_cast<int>(t), reached, next});
            if (k < mine.size()) reached = std::max(reached, mine[k].second);
        }
    }
    return loose;
}

}  // namespace ripstop
