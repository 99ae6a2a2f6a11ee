#include "ripstop/inflate/rig.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "ripstop/base/error.h"
#include "ripstop/base/union_find.h"
#include "ripstop/mesh/boundary.h"
#include "ripstop/tile/allowance.h"
#include "ripstop/tile/targets.h"

namespace ripstop {
namespace {

constexpr double most_rise = 0.3;  // relative to the height: a mouth may be slanted, but a single gore is not an
                                   // envelope

/// A connected run of boundary edges that are in no seam.
struct Opening {
    std::vector<std::array<SewnPoint, 2>> edges;  ///< counter-clockwise seen from outside
    std::set<int> nodes;
    double height = 0, rises = 0;  ///< mean height; height from its lowest to its highest point [m]
    bool is_round = false;         ///< runs through all sectors
};

/// The fraction of each boundary edge of each tile that is in a seam.
std::vector<Eigen::VectorXd> sewn_shares(const CutPlan& plan) {
    std::vector<Eigen::VectorXd> shares;
    for (const FlatTile& tile : plan.tiles) shares.push_back(Eigen::VectorXd::Zero(std::ssize(tile.tile.boundary)));
    for (const Seam& seam : plan.seams)
        for (const SeamSide* side : seam.own_sides())
            for (const SeamPart& part : side->parts) shares[at(side->tile)][part.edge] += part.length;
    for (std::size_t i = 0; i < plan.tiles.size(); ++i)
        shares[i] = shares[i].cwiseQuotient(drawn_lengths(plan.tiles[i].tile));
    return shares;
}

/// The openings of one sector, the lowest first.
std::vector<Opening> find_openings(const CutPlan& plan, const Symmetry& symmetry, const std::vector<char>& is_inside,
                                   const SewnEnvelope& sewn) {
    const std::vector<Eigen::VectorXd> shares = sewn_shares(plan);
    std::vector<std::array<SewnPoint, 2>> edges;
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        if (is_inside[i] || symmetry.tiles[i].turns != 0 || symmetry.tiles[i].of != static_cast<int>(i)) continue;
        const std::vector<int>& boundary = plan.tiles[i].tile.boundary;
        for (std::size_t e = 0; e < boundary.size(); ++e) {
            if (shares[i][static_cast<Eigen::Index>(e)] > 0.5) continue;
            const auto at = [&](std::size_t k) {
                return sewn.places[static_cast<std::size_t>(sewn.first_vertex[i] + boundary[k % boundary.size()])];
            };
            edges.push_back({at(e), at(e + 1)});
        }
    }
    UnionFind sets(static_cast<std::size_t>(sewn.nodes.rows()));
    for (const auto& edge : edges)
        for (const SewnPoint& place : edge)
            for (const NodeShare& part : place.shares) sets.join(edge[0].shares[0].node, part.node);
    std::map<int, Opening> by_root;
    for (const auto& edge : edges) {
        Opening& opening = by_root[sets.root(edge[0].shares[0].node)];
        opening.edges.push_back(edge);
        for (const SewnPoint& place : edge)
            for (const NodeShare& part : place.shares) {
                opening.nodes.insert(part.node);
                opening.is_round = opening.is_round || part.turns != 0;
            }
    }
    std::vector<Opening> openings;
    for (auto& [root, opening] : by_root) {
        double low = 1e300, high = -1e300;
        for (const int node : opening.nodes) {
            opening.height += sewn.nodes(node, 2) / static_cast<double>(opening.nodes.size());
            low = std::min(low, sewn.nodes(node, 2));
            high = std::max(high, sewn.nodes(node, 2));
        }
        opening.rises = high - low;
        openings.push_back(std::move(opening));
    }
    std::stable_sort(openings.begin(), openings.end(),
                     [](const Opening& a, const Opening& b) { return a.height < b.height; });
    return openings;
}

/// The points of a seam in order, with their arc length along it: the vertices of both sides.
std::vector<std::pair<double, SewnPoint>> points_of(const CutPlan& plan, const Seam& seam,
                                                    const PlaceOnBoundary& place_of) {
    std::vector<std::pair<double, SewnPoint>> points;
    const auto add = [&](double along) {
        points.emplace_back(along, place_of(seam.a.tile, place_on_side(plan.tiles, seam, false, along)));
    };
    double along = 0;
    add(0);
    for (std::size_t i = 0; i + 1 < seam.a.parts.size(); ++i) add(along += seam.a.parts[i].length);
    add(seam.length);
    return points;
}

std::set<int> nodes_of(const std::vector<std::pair<double, SewnPoint>>& points) {
    std::set<int> nodes;
    for (const auto& [along, place] : points)
        for (const NodeShare& part : place.shares) nodes.insert(part.node);
    return nodes;
}

bool touches(const SewnPoint& place, const std::set<int>& nodes) {
    return std::all_of(place.shares.begin(), place.shares.end(),
                       [&](const NodeShare& part) { return nodes.contains(part.node); });
}

/// The end of a load tape at the mouth, with its direction there.
struct TapeEnd {
    SewnPoint place;
    Vec3 at = Vec3::Zero(), run = Vec3::Zero();  ///< run: unit length, out of the envelope
};

std::vector<TapeEnd> add_load_tapes(const CutPlan& plan, const Rigging& rigging, const Symmetry& symmetry,
                                    const std::vector<double>& factors, const PlaceOnBoundary& place_of,
                                    const std::set<int>& mouth, SewnEnvelope& sewn) {
    std::vector<TapeEnd> ends;
    std::set<std::set<int>> laid;  // tapes already placed: in each sector the same seam recurs
    for (std::size_t s = 0; s < plan.seams.size(); ++s) {
        const Seam& seam = plan.seams[s];
        if (!seam.has_tape()) continue;
        const auto points = points_of(plan, seam, place_of);
        if (symmetry.sectors > 1 && !laid.insert(nodes_of(points)).second) continue;
        const double shorter = (1 - rigging.foreshortening) * (factors.empty() ? 1.0 : factors[s]);
        for (std::size_t i = 1; i < points.size(); ++i)
            sewn.tapes.push_back({TapeKind::load, points[i - 1].second, points[i].second,
                                  shorter * (points[i].first - points[i - 1].first), rigging.load_tape.stiffness,
                                  rigging.load_tape.mass, static_cast<int>(s)});
        const auto add_end = [&](const SewnPoint& end, const SewnPoint& before) {
            if (!touches(end, mouth)) return;
            const Vec3 at = position(end, sewn.nodes, symmetry.angle());
            ends.push_back({end, at, (at - position(before, sewn.nodes, symmetry.angle())).normalized()});
        };
        add_end(points.front().second, points[1].second);
        add_end(points.back().second, points[points.size() - 2].second);
    }
    return ends;
}

int add_held_node(const Vec3& at, SewnEnvelope& sewn) {
    const int node = static_cast<int>(sewn.nodes.rows());
    sewn.nodes.conservativeResize(node + 1, Eigen::NoChange);
    sewn.nodes.row(node) = at;
    sewn.freedom.push_back(Freedom::nowhere);
    sewn.held.push_back(node);
    return node;
}

void hold(const std::set<int>& nodes, SewnEnvelope& sewn) {
    for (const int node : nodes) {
        sewn.freedom[at(node)] = Freedom::nowhere;
        sewn.held.push_back(node);
    }
}

/// Triangles from the edges of an opening to its centre, outside up. An opening within one sector has its own centre.
std::vector<std::array<SewnPoint, 3>> closed(const Opening& opening, const Symmetry& symmetry) {
    const int turns = opening.is_round ? symmetry.sectors : 1;
    SewnPoint centre;
    const double share = 1.0 / static_cast<double>(opening.nodes.size() * static_cast<std::size_t>(turns));
    for (const int node : opening.nodes)
        for (int turn = 0; turn < turns; ++turn) centre.shares.push_back({node, share, turn});
    std::vector<std::array<SewnPoint, 3>> triangles;
    for (const auto& edge : opening.edges) triangles.push_back({edge[1], edge[0], centre});
    return triangles;
}

void append(const std::vector<std::array<SewnPoint, 3>>& triangles, std::vector<std::array<SewnPoint, 3>>& into) {
    into.insert(into.end(), triangles.begin(), triangles.end());
}

/// An envelope without a mouth rests on its lowest points.
std::set<int> lowest_nodes(const SewnEnvelope& sewn) {
    const auto heights = sewn.nodes.col(2);
    const double limit = heights.minCoeff() + 0.01 * (heights.maxCoeff() - heights.minCoeff());
    std::set<int> lowest;
    for (Eigen::Index n = 0; n < sewn.nodes.rows(); ++n)
        if (heights[n] <= limit) lowest.insert(static_cast<int>(n));
    return lowest;
}

}  // namespace

void add_rigging(const CutPlan& plan, const Rigging& rigging, const Symmetry& symmetry,
                 const std::vector<char>& is_inside, const std::vector<double>& tape_factors,
                 const PlaceOnBoundary& place_of, SewnEnvelope& sewn) {
    const std::vector<Opening> openings = find_openings(plan, symmetry, is_inside, sewn);
    const double height = sewn.nodes.col(2).maxCoeff() - sewn.nodes.col(2).minCoeff();
    for (const Opening& opening : openings)
        if (opening.rises > most_rise * height)
            throw InputError(
                fmt::format("the cloth does not enclose the gas: it is open over {:.2f} m of its {:.2f} m of height; "
                            "sew all tiles of the "
                            "envelope (ripstop check names the edges in no seam)",
                            opening.rises, height));
    const double middle = 0.5 * (sewn.nodes.col(2).minCoeff() + sewn.nodes.col(2).maxCoeff());
    const bool has_mouth = !openings.empty() && openings.front().height < middle;
    const bool has_crown = !openings.empty() && openings.back().height >= middle;
    const std::set<int> mouth = has_mouth ? openings.front().nodes : std::set<int>{};
    sewn.floor = has_mouth ? openings.front().height : sewn.nodes.col(2).minCoeff();

    const std::vector<TapeEnd> ends = add_load_tapes(plan, rigging, symmetry, tape_factors, place_of, mouth, sewn);
    const bool enough = ends.size() * static_cast<std::size_t>(symmetry.sectors) >= 3;
    if (rigging.mouth == MouthHold::wires && !enough)
        throw InputError(
            "the mouth cannot hang on wires: fewer than three load tapes end at it; give its seams a type with a "
            "tape, or hold its edge");
    if (rigging.mouth == MouthHold::wires || (rigging.mouth == MouthHold::automatic && enough)) {
        for (std::size_t i = 0; i < ends.size(); ++i) {
            const int frame = add_held_node(ends[i].at + rigging.wire_length * ends[i].run, sewn);
            sewn.tapes.push_back({TapeKind::wire,
                                  ends[i].place,
                                  {{{frame, 1, 0}}},
                                  rigging.wire_length,
                                  rigging.wire.stiffness,
                                  rigging.wire.mass,
                                  static_cast<int>(i)});
        }
    } else {
        hold(has_mouth ? mouth : lowest_nodes(sewn), sewn);
    }
    const std::size_t first = has_mouth ? 1 : 0, last = openings.size() - (has_crown ? 1 : 0);
    if (has_mouth) append(closed(openings.front(), symmetry), sewn.lids);
    // Vents and unsewn edges are treated as closed by cloth: they hold gas, and `check` names the edges.
    for (std::size_t i = first; i < last; ++i) append(closed(openings[i], symmetry), sewn.caps);
    if (!has_crown) return;
    if (!rigging.crown_ring && !rigging.crown_closed)
        throw InputError(
            "crown_ring and crown_closed are both false: nothing would hold the edge of the opening at the top against "
            "the "
            "gas; set one of them");
    if (rigging.crown_ring)
        for (const int node : openings.back().nodes) sewn.freedom[at(node)] = Freedom::vertical;
    append(closed(openings.back(), symmetry), rigging.crown_closed ? sewn.caps : sewn.lids);
    if (rigging.crown_closed) sewn.cap_mass = plan.fabric.mass;
}

}  // namespace ripstop
