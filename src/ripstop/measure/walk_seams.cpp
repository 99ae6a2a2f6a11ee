#include "ripstop/measure/walk_seams.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ripstop/base/index.h"
#include "ripstop/mesh/boundary.h"
#include "ripstop/tile/targets.h"

namespace ripstop {
namespace {

/// The edge lengths of a tile: drawn and on the cloth [m].
struct EdgeLengths {
    Eigen::VectorXd drawn, cloth;
};

EdgeLengths lengths_of(const FlatTile& flat) {
    EdgeLengths lengths;
    lengths.drawn = drawn_lengths(flat.tile);
    if (flat.flattening.positions.rows() == flat.tile.mesh.vertex_count())
        lengths.cloth = boundary_on_cloth(flat.tile, flat.flattening.positions, flat.flattening.edges_on_curve);
    else  // the tile was not flattened
        lengths.cloth = Eigen::VectorXd::Constant(lengths.drawn.size(), std::numeric_limits<double>::quiet_NaN());
    return lengths;
}

/// One side from the seam's start: the ends of its parts along the curve, and the cumulative length of cloth.
struct Profile {
    std::vector<double> at{0}, cloth{0};

    double cloth_at(double s) const {
        const auto above = std::upper_bound(at.begin() + 1, at.end() - 1, s);
        const auto i = static_cast<std::size_t>(above - at.begin());
        const double step = at[i] - at[i - 1];
        const double share = step > 0 ? std::clamp((s - at[i - 1]) / step, 0.0, 1.0) : 1;
        return cloth[i - 1] + share * (cloth[i] - cloth[i - 1]);
    }
};

Profile profile_of(std::vector<SeamPart> parts, const EdgeLengths& lengths, bool backwards, double total) {
    if (backwards) std::reverse(parts.begin(), parts.end());
    Profile profile;
    for (const SeamPart& part : parts) {
        profile.at.push_back(profile.at.back() + part.length);
        profile.cloth.push_back(profile.cloth.back() +
                                lengths.cloth[part.edge] * (part.length / lengths.drawn[part.edge]));
    }
    // The sums of the two sides differ by rounding, but they end at the same point.
    profile.at.back() = total;
    return profile;
}

Vec3 middle_of_edge(const Tile& tile, int edge) {
    const auto i = static_cast<std::size_t>(edge);
    const Vec3 from = tile.mesh.positions.row(tile.boundary[i]);
    const Vec3 to = tile.mesh.positions.row(tile.boundary[(i + 1) % tile.boundary.size()]);
    return (from + to) / 2;
}

Vec3 place_along(const SeamSide& side, const Tile& tile, double s) {
    std::size_t i = 0;
    for (double walked = 0; i + 1 < side.parts.size() && walked + side.parts[i].length < s; ++i)
        walked += side.parts[i].length;
    return middle_of_edge(tile, side.parts[i].edge);
}

SeamWalk walk(const Seam& seam, const std::vector<EdgeLengths>& lengths, const WalkOptions& options) {
    const Profile a = profile_of(seam.a.parts, lengths[at(seam.a.tile)], false, seam.length);
    const Profile b = profile_of(seam.b.parts, lengths[at(seam.b.tile)], true, seam.length);
    SeamWalk walk;
    walk.length = seam.length;
    walk.uncertainty = seam.uncertainty;
    walk.flat_a = a.cloth.back();
    walk.flat_b = b.cloth.back();
    const auto drift_at = [&](double s) { return b.cloth_at(s) - a.cloth_at(s); };
    const auto consider = [&](double s, double drift) {
        if (std::abs(drift) <= walk.drift_max || std::isnan(walk.drift_max)) return;
        walk.drift_max = std::abs(drift);
        walk.drift_max_at = s;
    };
    consider(seam.length, walk.mismatch());
    for (const Profile* side : {&a, &b})
        for (std::size_t i = 1; i + 1 < side->at.size(); ++i) consider(side->at[i], drift_at(side->at[i]));
    const int intervals =
        std::max(options.least_intervals, static_cast<int>(std::ceil(seam.length / options.notch_spacing - 1e-9)));
    for (int i = 1; i < intervals; ++i) {
        const double s = seam.length * i / intervals;
        walk.notches.push_back({s, drift_at(s)});
    }
    return walk;
}

}  // namespace

Eigen::VectorXd boundary_on_cloth(const Tile& tile, const Points2& flat, bool edges_on_curve) {
    const std::vector<int> loop = closed(tile.boundary);
    Eigen::VectorXd lengths = edge_lengths(flat, loop);
    if (edges_on_curve || tile.curve_lengths.size() == 0) return lengths;
    return lengths.cwiseProduct(tile.curve_lengths).cwiseQuotient(edge_lengths(tile.mesh.positions, loop));
}

std::vector<SeamWalk> walk_seams(const std::vector<FlatTile>& tiles, const std::vector<Seam>& seams,
                                 const Tolerances& tolerances, const WalkOptions& options) {
    std::vector<SeamWalk> walks;
    if (seams.empty()) return walks;
    std::vector<EdgeLengths> lengths;
    for (const FlatTile& tile : tiles) lengths.push_back(lengths_of(tile));
    for (const Seam& seam : seams) {
        SeamWalk& here = walks.emplace_back(walk(seam, lengths, options));
        here.limit = tolerances.length * seam.length;
        here.ok = here.drift_max <= here.limit;
        here.worst = place_along(seam.a, tiles[at(seam.a.tile)].tile, here.drift_max_at);
    }
    return walks;
}

}  // namespace ripstop
