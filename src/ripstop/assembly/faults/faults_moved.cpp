#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "ripstop/assembly/faults/faults.h"
#include "ripstop/assembly/faults/loose_edges.h"
#include "ripstop/assembly/faults/tile_fit.h"
#include "ripstop/base/index.h"
#include "ripstop/base/text/number_text.h"

namespace ripstop {
namespace {

constexpr int most_passes = 20;  // each pass mends all tiles that miss their neighbours on their own
constexpr int most_fitted = 40;  // tiles tried in the holes per pass; with more loose tiles, a hole tells nothing
constexpr double hole_openness = 0.01;
constexpr double most_scale = 100;      // larger ratios are accepted only if they are those of two units
constexpr double close_to_unit = 0.05;  // relative error of a ratio of two units
constexpr double most_residual = 0.02;  // share of the placed tile's extent; rejects a tile that shrank onto an edge
constexpr double least_of_edge = 0.05;  // smallest extent, as a share of the edge's: a panel beside a gore in one piece
constexpr double least_of_hole = 0.5;   // smallest extent, as a share of the hole's
constexpr double most_off_hole = 0.25;  // largest relative difference of the outlines' lengths

/// The envelope's state during one pass.
struct Picture {
    const std::vector<Tile>& tiles;
    const FoundSeams& found;
    const std::vector<PlacedChain>& chains;
    double tolerance;
};

/// Which tiles a tile misses, chain by chain, and how many of its edges are loose.
struct Standing {
    int tile = 0;
    std::set<int> missing_chains, missed_tiles;
    double loose = 0;  // number of edges

    bool mostly_loose(const Tile& its) const { return loose > 0.5 * static_cast<double>(its.boundary.size()); }
};

std::vector<Standing> standings(const Picture& picture) {
    std::vector<Standing> all(picture.tiles.size());
    for (std::size_t t = 0; t < all.size(); ++t) all[t].tile = static_cast<int>(t);
    for (const NearMiss& miss : picture.found.near_misses) {
        if (miss.tile_a == miss.tile_b) continue;
        Standing& a = all[at(miss.tile_a)];
        Standing& b = all[at(miss.tile_b)];
        a.missing_chains.insert(miss.chain_a);
        b.missing_chains.insert(miss.chain_b);
        a.missed_tiles.insert(miss.tile_b);
        b.missed_tiles.insert(miss.tile_a);
    }
    for (const LooseRun& run : picture.found.loose) all[at(run.tile)].loose += run.end - run.start;
    std::stable_sort(all.begin(), all.end(), [](const Standing& p, const Standing& q) {
        return p.missing_chains.size() > q.missing_chains.size();
    });
    return all;
}

double extent_of(const Points3& points) {
    return (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm();
}

/// True if the fit keeps the tile's size. Fitting by nearest points shrinks a tile, and one shrunk to a speck lies
/// on any edge, which explains nothing.
bool is_conditioned(const TileFit& fit, const Points3& points, double least_extent) {
    const double ratio = std::max(fit.move.scale, 1 / fit.move.scale), extent = fit.move.scale * extent_of(points);
    const std::array<double, 2> units = {304.8, 1000};  // mm for ft, mm for m
    const bool may_be = ratio <= most_scale * (1 + close_to_unit) ||
                        std::any_of(units.begin(), units.end(),
                                    [&](double unit) { return std::abs(ratio / unit - 1) < close_to_unit; });
    return may_be && extent >= least_extent && fit.residual <= most_residual * extent;
}

/// Fits the tile to these edges: by a motion if that suffices, else also by a scale that keeps its extent above
/// `least_extent`.
std::optional<TileFit> lay_on(const Points3& points, const std::vector<TargetEdge>& edges, const Similarity& start,
                              double tolerance, double least_extent) {
    if (points.rows() < 3 || edges.empty()) return {};
    Similarity unscaled = start;
    unscaled.scale = 1;
    const Vec3 centre = points.colwise().mean().transpose();
    unscaled.shift = start(centre) - centre;
    const TileFit moved = fit_to_edges(points, edges, unscaled, false);
    const TileFit scaled = fit_to_edges(points, edges, start, true);
    const bool may_scale = is_conditioned(scaled, points, least_extent);
    const bool may_move = moved.residual <= 2 * scaled.residual + 0.1 * tolerance;
    const TileFit& best = may_move || !may_scale ? moved : scaled;
    if (!(best.residual <= 2 * tolerance)) return {};
    double furthest = 0;
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        const Vec3 point = points.row(i);
        furthest = std::max(furthest, (best.move(point) - point).norm());
    }
    if (!(furthest > tolerance / 2)) return {};  // it already lies there, so the fault is a gap
    return best;
}

/// Fits the tile to the chains that it misses and to those that it is sewn to.
std::optional<TileFit> fit_to_neighbours(const Picture& picture, int tile) {
    std::set<std::pair<int, int>> own, other;
    const auto add = [&](int tile_a, int chain_a, int tile_b, int chain_b) {
        if (tile_a == tile_b) return;
        if (tile_a == tile) own.insert({tile_a, chain_a}), other.insert({tile_b, chain_b});
        if (tile_b == tile) own.insert({tile_b, chain_b}), other.insert({tile_a, chain_a});
    };
    for (const NearMiss& miss : picture.found.near_misses) add(miss.tile_a, miss.chain_a, miss.tile_b, miss.chain_b);
    for (const Seam& seam : picture.found.seams) add(seam.a.tile, seam.a.chain, seam.b.tile, seam.b.chain);
    std::vector<TargetEdge> edges;
    std::vector<Vec3> vertices;
    double shortest = std::numeric_limits<double>::infinity();
    for (const PlacedChain& chain : picture.chains) {
        if (other.contains({chain.tile, chain.chain})) {
            for (int e = 0; e < chain.curve.edge_count(); ++e) edges.push_back({&chain.curve, e});
            shortest = std::min(shortest, extent_of(chain.curve.points));
        }
        if (own.contains({chain.tile, chain.chain}))
            for (int v = 0; v <= chain.curve.edge_count(); ++v) vertices.push_back(chain.curve.points.row(v));
    }
    Points3 points(static_cast<Eigen::Index>(vertices.size()), 3);
    for (Eigen::Index i = 0; i < points.rows(); ++i) points.row(i) = vertices[at(i)];
    return lay_on(points, edges, {}, picture.tolerance, least_of_edge * shortest);
}

Points3 boundary_points(const Tile& tile) {
    Points3 points(static_cast<Eigen::Index>(tile.boundary.size()), 3);
    for (Eigen::Index i = 0; i < points.rows(); ++i) points.row(i) = tile.mesh.positions.row(tile.boundary[at(i)]);
    return points;
}

/// A hole that a tile could have fallen out of: its outline and the edges around it.
struct Hole {
    Points3 outline;
    std::vector<TargetEdge> edges;
    std::vector<int> tiles;
};

/// The holes of the envelope if the edges of one tile are removed.
std::vector<Hole> find_holes(const Picture& picture, int without) {
    std::vector<LooseRun> loose;
    for (const LooseRun& run : picture.found.loose)
        if (run.tile != without) loose.push_back(run);
    std::vector<std::vector<int>> runs;
    const std::vector<LooseLoop> loops = find_loops(picture.tiles, picture.chains, loose, picture.tolerance, &runs);
    std::vector<Hole> holes;
    for (std::size_t l = 0; l < loops.size(); ++l) {
        if (!loops[l].closed || loops[l].outline || loops[l].openness < hole_openness || loops[l].corners == 0)
            continue;
        Hole hole;
        std::vector<Vec3> outline;
        for (const int r : runs[l]) {
            const LooseRun& run = loose[static_cast<std::size_t>(r)];
            const BoundaryCurve curve(picture.chains, run.tile);
            outline.push_back(curve.point(run.start));
            for (double at = std::floor(run.start) + 1; at < run.end; ++at) outline.push_back(curve.point(at));
            outline.push_back(curve.point(run.end));
            for (int e = static_cast<int>(std::floor(run.start)); e < run.end; ++e) {
                const auto [chain, edge] = curve.edge(e);
                hole.edges.push_back({chain, edge});
            }
            hole.tiles.push_back(run.tile);
        }
        hole.outline.resize(static_cast<Eigen::Index>(outline.size()), 3);
        for (Eigen::Index i = 0; i < hole.outline.rows(); ++i)
            hole.outline.row(i) = outline[static_cast<std::size_t>(i)];
        holes.push_back(std::move(hole));
    }
    return holes;
}

double length_round(const Points3& polygon) {
    double sum = 0;
    for (Eigen::Index i = 0; i < polygon.rows(); ++i)
        sum += (polygon.row((i + 1) % polygon.rows()) - polygon.row(i)).norm();
    return sum;
}

/// Fits the tile to the hole whose outline matches it best, at any scale.
std::optional<TileFit> fit_to_hole(const Picture& picture, int tile, std::vector<int>& around) {
    const std::vector<Hole> holes = find_holes(picture, tile);
    const Points3 points = boundary_points(picture.tiles[at(tile)]);
    std::optional<TileFit> best;
    for (const Hole& hole : holes) {
        const Similarity start = match_outlines(points, hole.outline);
        const double ratio = length_round(points) / length_round(hole.outline);
        if (std::abs(start.scale * ratio - 1) > 0.05) continue;
        const std::optional<TileFit> fit =
            lay_on(points, hole.edges, start, picture.tolerance, least_of_hole * extent_of(hole.outline));
        if (!fit || (best && best->residual <= fit->residual)) continue;
        if (std::abs(fit->move.scale * ratio - 1) > most_off_hole) continue;
        best = fit;
        around = hole.tiles;
    }
    return best;
}

EnvelopeIssue moved_issue(const Tile& tile, const Similarity& move, const std::vector<std::string>& neighbours) {
    const Vec3 centre = boundary_points(tile).colwise().mean().transpose();
    const double scale = 1 / move.scale;  // undoing the fault is the inverse of the move
    const double shift = (move(centre) - centre).norm();
    const double turn = std::abs(Eigen::AngleAxisd(move.turn).angle());
    const std::string turned =
        turn > 0.1 * degree ? " and turned by " + format_fixed(turn / degree, 1) + " degrees" : std::string();
    EnvelopeIssue issue{"shifted", {}, {tile.name}, centre, shift};
    const std::string against = ", as its neighbours " + names_text(neighbours) + " show";
    if (move.scale == 1) {
        issue.message = "tile " + tile.name + " at " + place_text(centre) + " lies " + length_text(shift) +
                        " away from its place" + turned + against + "; move it by (" +
                        format_fixed((move(centre) - centre).x() / millimetre, 1) + ", " +
                        format_fixed((move(centre) - centre).y() / millimetre, 1) + ", " +
                        format_fixed((move(centre) - centre).z() / millimetre, 1) + ") mm";
        return issue;
    }
    issue.code = "scaled";
    issue.value = scale;
    const std::string ratio = std::abs(scale - 1) < 0.5 ? format_fixed(100 * std::abs(scale - 1), 2) + " %"
                                                        : format_fixed(scale > 1 ? scale : 1 / scale, 3) + " times";
    issue.message = "tile " + tile.name + " at " + place_text(centre) + " is " + ratio + " too " +
                    (scale > 1 ? "large" : "small") + " (scaled by " + format_fixed(scale, scale < 0.1 ? 6 : 4) +
                    turned + ")" + against + "; scale it by " + format_fixed(move.scale, move.scale < 0.1 ? 6 : 4);
    return issue;
}

double length_sewn(const FoundSeams& found) {
    double sum = 0;
    for (const Seam& seam : found.seams) sum += seam.length;
    return sum;
}

}  // namespace

std::vector<EnvelopeIssue> move_back(std::vector<Tile>& tiles, FoundSeams& found, const SeamOptions& options) {
    std::vector<EnvelopeIssue> issues;
    for (int pass = 0; pass < most_passes; ++pass) {
        const std::size_t issues_before = issues.size();
        const std::vector<PlacedChain> chains = place_chains(tiles);
        const Picture picture{tiles, found, chains, options.tolerance};
        std::vector<std::pair<int, Similarity>> moves;
        std::set<int> settled;
        int fitted_to_holes = 0;
        for (const Standing& standing : standings(picture)) {
            const int t = standing.tile;
            const bool misses = standing.missing_chains.size() >= 2 && standing.missed_tiles.size() >= 2;
            const bool free = standing.mostly_loose(tiles[at(t)]);
            if (settled.contains(t) || (!misses && !free)) continue;
            std::optional<TileFit> fit;
            std::vector<int> around(standing.missed_tiles.begin(), standing.missed_tiles.end());
            if (free && fitted_to_holes++ < most_fitted) fit = fit_to_hole(picture, t, around);
            if (!fit && misses) fit = fit_to_neighbours(picture, t);
            if (!fit) continue;
            std::vector<std::string> names;
            for (const int other : around) {
                settled.insert(other);
                const std::string& name = tiles[at(other)].name;
                if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
            }
            settled.insert(t);
            issues.push_back(moved_issue(tiles[at(t)], fit->move, names));
            moves.emplace_back(t, fit->move);
        }
        if (moves.empty()) break;
        std::vector<Tile> mended = tiles;
        for (const auto& [t, move] : moves) {
            Points3& positions = mended[at(t)].mesh.positions;
            for (Eigen::Index v = 0; v < positions.rows(); ++v) positions.row(v) = move(positions.row(v).transpose());
        }
        FoundSeams mended_seams = find_seams(mended, options);
        if (length_sewn(mended_seams) < length_sewn(found) - options.tolerance) {  // the moves mend nothing
            issues.resize(issues_before);
            break;
        }
        tiles = std::move(mended);
        found = std::move(mended_seams);
    }
    return issues;
}

}  // namespace ripstop
