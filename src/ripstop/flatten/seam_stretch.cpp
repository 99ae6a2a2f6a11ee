#include "ripstop/flatten/seam_stretch.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "ripstop/base/error.h"
#include "ripstop/base/number_text.h"

namespace ripstop {
namespace {

constexpr double same_length = 1e-9;  // of a seam's two sides
constexpr double least_part = 0.5;    // of an edge, for its end to end an interval

/// A part of an edge with where it lies along the seam, from its start: 0 to 1.
struct Placed {
    int tile, edge;
    double from, to;
    double length;  ///< on the common curve [m]
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

/// Where intervals may end: between the parts of a side, but for its first or last where that is a small bit of an edge.
std::vector<double> ends(const std::vector<Placed>& parts, const Eigen::VectorXd& drawn) {
    const auto small = [&](const Placed& part) { return part.length < least_part * drawn[part.edge]; };
    std::vector<double> found{0};
    for (std::size_t k = 1; k < parts.size(); ++k)
        if (!(k == 1 && small(parts[0])) && !(k + 1 == parts.size() && small(parts[k]))) found.push_back(parts[k].from);
    found.push_back(1);
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
    const Tile& tile = envelope.tiles[static_cast<std::size_t>(side.tile)];
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
        throw InputError("seam " + seam.id + ": its sides are " + format_fixed(a, 9) + " and " +
                         format_fixed(b, 9) + " m long; measure both on one curve");
}

/// What tile, edge and interval share.
struct Share {
    int tile, interval, edge;
    double length;  ///< [m]
};

void add_shares(const std::vector<Placed>& parts, const std::vector<double>& knots, int first,
                std::vector<Share>& shares) {
    std::size_t k = 0;
    for (const Placed& part : parts) {
        while (k + 2 < knots.size() && knots[k + 1] <= part.from) ++k;
        for (std::size_t i = k; i + 1 < knots.size() && (i == k || knots[i] < part.to); ++i) {
            const double shared = std::min(part.to, knots[i + 1]) - std::max(part.from, knots[i]);
            if (shared > 0)
                shares.push_back({part.tile, first + static_cast<int>(i), part.edge,
                                  part.length * shared / (part.to - part.from)});
        }
    }
}

TileStretch gather(const Tile& tile, std::span<const Share> shares) {
    TileStretch stretch;
    for (const Share& share : shares)
        if (stretch.intervals.empty() || stretch.intervals.back() != share.interval)
            stretch.intervals.push_back(share.interval);
    const Eigen::ArrayXd longer = target_lengths(tile).array() / drawn_lengths(tile).array();
    stretch.reach.setZero(longer.size(), static_cast<Eigen::Index>(stretch.intervals.size()));
    Eigen::Index column = -1;
    int interval = -1;
    for (const Share& share : shares) {
        if (share.interval != interval) ++column;
        interval = share.interval;
        stretch.reach(share.edge, column) += longer[share.edge] * share.length;
    }
    return stretch;
}

}  // namespace

SeamStretch find_seam_stretch(const Envelope& envelope) {
    SeamStretch stretch{{0}, {}};
    std::vector<Share> shares;
    std::vector<Eigen::VectorXd> drawn;
    for (const Tile& tile : envelope.tiles) drawn.push_back(drawn_lengths(tile));
    for (const Seam& seam : envelope.seams) {
        require_sides(envelope, seam);
        const std::vector<Placed> a = place(seam.a, true), b = place(seam.b, false);
        const std::vector<double> ends_a = ends(a, drawn[static_cast<std::size_t>(seam.a.tile)]);
        const std::vector<double> ends_b = ends(b, drawn[static_cast<std::size_t>(seam.b.tile)]);
        // as many on both sides: those that lie less close, so that swapping the sides changes nothing
        const bool by_a = ends_a.size() != ends_b.size() ? ends_a.size() < ends_b.size()
                                                         : least_step(ends_a) >= least_step(ends_b);
        const std::vector<double>& knots = by_a ? ends_a : ends_b;
        add_shares(a, knots, stretch.count(), shares);
        add_shares(b, knots, stretch.count(), shares);
        stretch.first.push_back(stretch.count() + static_cast<int>(knots.size()) - 1);
    }
    std::stable_sort(shares.begin(), shares.end(), [](const Share& one, const Share& other) {
        return std::pair(one.tile, one.interval) < std::pair(other.tile, other.interval);
    });
    auto from = shares.begin();
    for (std::size_t t = 0; t < envelope.tiles.size(); ++t) {
        const auto to =
            std::find_if(from, shares.end(), [&](const Share& share) { return share.tile != static_cast<int>(t); });
        stretch.tiles.push_back(gather(envelope.tiles[t], std::span(from, to)));
        from = to;
    }
    return stretch;
}

}  // namespace ripstop
