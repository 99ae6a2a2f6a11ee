#include "ripstop/flatten/seam/seam_stretch.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "ripstop/base/error.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/base/union_find.h"
#include "ripstop/tile/targets.h"

namespace ripstop {
namespace {

constexpr double same_length = 1e-9;  // relative tolerance for the lengths of a seam's two sides

/// A part of an edge and its range along the seam, from 0 at its start to 1.
struct Placed {
    int tile, edge;
    double from, to;
    double length;  ///< length on the common curve [m]
};

double total(const std::vector<SeamPart>& parts) {
    double sum = 0;
    for (const SeamPart& part : parts) sum += part.length;
    return sum;
}

/// The parts of a side from the seam's start to its end.
std::vector<Placed> place(const SeamSide& side, bool runs_along) {
    std::vector<SeamPart> parts = side.parts;
    if (!runs_along) std::reverse(parts.begin(), parts.end());
    const double whole = total(parts);
    std::vector<Placed> placed;
    double at = 0;
    for (const SeamPart& part : parts) {
        placed.push_back({side.tile, part.edge, at / whole, (at + part.length) / whole, part.length});
        at += part.length;
    }
    placed.back().to = 1;
    return placed;
}

/// The ends of the parts of a side.
std::vector<double> ends(const std::vector<Placed>& parts) {
    std::vector<double> found{0};
    for (const Placed& part : parts) found.push_back(part.to);
    return found;
}

double least_step(const std::vector<double>& values) {
    double least = 1;
    for (std::size_t k = 1; k < values.size(); ++k) least = std::min(least, values[k] - values[k - 1]);
    return least;
}

void require_side(const Envelope& envelope, const Seam& seam, const SeamSide& side) {
    if (side.tile < 0 || side.tile >= static_cast<int>(envelope.tiles.size()))
        throw InputError("seam " + seam.id + ": names tile " + std::to_string(side.tile) + ", there are " +
                         std::to_string(envelope.tiles.size()));
    const Tile& tile = envelope.tiles[at(side.tile)];
    for (const SeamPart& part : side.parts)
        if (part.edge < 0 || part.edge >= static_cast<int>(tile.boundary.size()) || !(part.length > 0))
            throw InputError("seam " + seam.id + ": a part of edge " + std::to_string(part.edge) + " of tile " +
                             tile.name + " is " + format_shortest(part.length) +
                             " m long; expected an edge of its boundary and a length above zero");
    if (side.parts.empty()) throw InputError("seam " + seam.id + ": has no part on tile " + tile.name);
}

void require_sides(const Envelope& envelope, const Seam& seam) {
    require_side(envelope, seam, seam.a);
    require_side(envelope, seam, seam.b);
    const double a = total(seam.a.parts), b = total(seam.b.parts);
    if (std::abs(a - b) > same_length * (a + b))
        throw InputError("seam " + seam.id + ": its sides are " + format_fixed(a, 9) + " and " + format_fixed(b, 9) +
                         " m long; measure both on one curve");
}

/// The part of an edge that lies in one interval.
struct Share {
    int tile, edge, seam, interval;
    double length;  ///< length of that part [m]
};

void add_shares(const std::vector<Placed>& parts, const std::vector<double>& knots, int seam, int first,
                std::vector<Share>& shares) {
    std::size_t k = 0;
    for (const Placed& part : parts) {
        while (k + 2 < knots.size() && knots[k + 1] <= part.from) ++k;
        for (std::size_t i = k; i + 1 < knots.size() && (i == k || knots[i] < part.to); ++i) {
            const double shared = std::min(part.to, knots[i + 1]) - std::max(part.from, knots[i]);
            if (shared > same_length)
                shares.push_back({part.tile, part.edge, seam, first + static_cast<int>(i),
                                  part.length * shared / (part.to - part.from)});
        }
    }
}

/// The shares of both sides of every seam in its intervals, sorted by tile and edge.
std::vector<Share> find_shares(const Envelope& envelope, UnionFind& intervals) {
    std::vector<Share> shares;
    for (std::size_t s = 0; s < envelope.seams.size(); ++s) {
        const Seam& seam = envelope.seams[s];
        require_sides(envelope, seam);
        const std::vector<Placed> a = place(seam.a, true), b = place(seam.b, false);
        const std::vector<double> ends_a = ends(a), ends_b = ends(b);
        // equally many on both sides: take the side with the wider spacing, so that swapping the sides changes
        // nothing
        const bool by_a =
            ends_a.size() != ends_b.size() ? ends_a.size() < ends_b.size() : least_step(ends_a) >= least_step(ends_b);
        const std::vector<double>& knots = by_a ? ends_a : ends_b;
        const int first = intervals.add();
        for (std::size_t k = 2; k < knots.size(); ++k) intervals.add();
        add_shares(a, knots, static_cast<int>(s), first, shares);
        add_shares(b, knots, static_cast<int>(s), first, shares);
    }
    std::stable_sort(shares.begin(), shares.end(), [](const Share& one, const Share& other) {
        return std::pair(one.tile, one.edge) < std::pair(other.tile, other.edge);
    });
    return shares;
}

/// Unites all intervals along an edge that belongs to two seams.
void join_across_seams(std::span<const Share> edge, UnionFind& intervals) {
    if (std::all_of(edge.begin(), edge.end(), [&](const Share& share) { return share.seam == edge[0].seam; })) return;
    for (const Share& share : edge) intervals.join(edge[0].interval, share.interval);
}

/// The shares of the same edge, beginning at `from`.
std::span<const Share> same_edge(const std::vector<Share>& shares, std::size_t from) {
    std::size_t to = from;
    while (to < shares.size() && shares[to].tile == shares[from].tile && shares[to].edge == shares[from].edge) ++to;
    return std::span(shares).subspan(from, to - from);
}

TileStretch make_stretch(const Tile& tile, std::span<const Share> shares, const std::vector<int>& numbers) {
    TileStretch stretch;
    const auto number = [&](const Share& share) { return numbers[at(share.interval)]; };
    for (const Share& share : shares) stretch.intervals.push_back(number(share));
    std::sort(stretch.intervals.begin(), stretch.intervals.end());
    stretch.intervals.erase(std::unique(stretch.intervals.begin(), stretch.intervals.end()), stretch.intervals.end());
    const Eigen::VectorXd targets = target_lengths(tile);
    stretch.reach.setZero(targets.size(), static_cast<Eigen::Index>(stretch.intervals.size()));
    for (const Share& share : shares) {
        const auto column = std::lower_bound(stretch.intervals.begin(), stretch.intervals.end(), number(share));
        stretch.reach(share.edge, column - stretch.intervals.begin()) += share.length;
    }
    const Eigen::ArrayXd whole = stretch.reach.rowwise().sum();
    const Eigen::VectorXd factors = (whole > 0).select(targets.array() / whole, 0);
    stretch.reach = (factors.asDiagonal() * stretch.reach).eval();
    return stretch;
}

}  // namespace

SeamStretch find_seam_stretch(const Envelope& envelope) {
    UnionFind intervals;
    const std::vector<Share> shares = find_shares(envelope, intervals);
    for (std::size_t k = 0; k < shares.size(); k += same_edge(shares, k).size())
        join_across_seams(same_edge(shares, k), intervals);
    SeamStretch stretch;
    const std::vector<int> numbers = intervals.numbers();
    stretch.count = numbers.empty() ? 0 : *std::max_element(numbers.begin(), numbers.end()) + 1;
    auto from = shares.begin();
    for (std::size_t t = 0; t < envelope.tiles.size(); ++t) {
        const auto to =
            std::find_if(from, shares.end(), [&](const Share& share) { return share.tile != static_cast<int>(t); });
        stretch.tiles.push_back(make_stretch(envelope.tiles[t], std::span(from, to), numbers));
        from = to;
    }
    return stretch;
}

}  // namespace ripstop
