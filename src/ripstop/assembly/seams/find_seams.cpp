#include "ripstop/assembly/seams/find_seams.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "ripstop/assembly/seams/cloth_across.h"
#include "ripstop/assembly/seams/limits.h"
#include "ripstop/assembly/seams/run_claims.h"
#include "ripstop/assembly/seams/seam_lengths.h"
#include "ripstop/assembly/seams/seam_runs.h"
#include "ripstop/assembly/seams/sewn_in.h"
#include "ripstop/assembly/seams/sheets.h"
#include "ripstop/base/error.h"
#include "ripstop/base/index.h"
#include "ripstop/base/text/number_text.h"

namespace ripstop {
namespace {

constexpr double shortest_chain = 20;   // in tolerances: the median chain of an envelope
constexpr double same_length = 1e-6;    // [m]
constexpr std::size_t few_chains = 40;  // envelopes with so few chains are searched at any size
constexpr double widest_slit = 0.1;     // share of the tile's width, for edges of one tile

/// Joins the touches that pass `wanted` into runs, for each pair of chains and direction.
template <class Wanted>
std::vector<Run> runs_where(const std::vector<PlacedChain>& chains, const std::vector<Touch>& touches, double tolerance,
                            Wanted&& wanted) {
    std::vector<Run> runs;
    std::vector<Touch> group;
    for (std::size_t i = 0; i < touches.size(); ++i) {
        if (wanted(touches[i])) group.push_back(touches[i]);
        const bool last = i + 1 == touches.size() || touches[i + 1].a != touches[i].a ||
                          touches[i + 1].b != touches[i].b || touches[i + 1].same_way != touches[i].same_way;
        if (!last) continue;
        for (Run& run : join_touches(chains, std::move(group), tolerance)) runs.push_back(std::move(run));
        group.clear();
    }
    return runs;
}

/// The names of a run's tiles, in alphabetical order.
std::pair<std::string, std::string> names_of(const std::vector<Tile>& tiles, const std::vector<PlacedChain>& chains,
                                             const Run& run) {
    const auto name = [&](int chain) { return tiles[at(chains[at(chain)].tile)].name; };
    return std::minmax(name(run.a), name(run.b));
}

/// Greedily takes the longest run, and among competing runs the one of lowest rank. Shorter runs keep what is left
/// free, down to the shortest that `long_enough` allows.
template <class LongEnough>
std::vector<Run> take_longest_first(const std::vector<Tile>& tiles, const std::vector<PlacedChain>& chains,
                                    std::vector<Run> runs, RunClaims& claims, LongEnough&& long_enough) {
    const auto before = [&](std::size_t p, std::size_t q) {
        const Run &r = runs[p], &s = runs[q];
        const auto turn = [](const Run& run) { return std::tuple(-std::max(run.turn, run.length), run.rank); };
        if (turn(r) != turn(s)) return turn(r) < turn(s);
        if (r.rank != 0) {  // independent of the order in the file and of rounding
            const auto first = std::tuple(-std::round(r.length / same_length), names_of(tiles, chains, r));
            const auto second = std::tuple(-std::round(s.length / same_length), names_of(tiles, chains, s));
            if (first != second) return first < second;
        }
        return std::tuple(-r.length, r.gap, r.a, r.b, p) < std::tuple(-s.length, s.gap, s.a, s.b, q);
    };
    std::set<std::size_t, decltype(before)> waiting(before);
    for (std::size_t r = 0; r < runs.size(); ++r)
        if (long_enough(runs[r])) waiting.insert(r);
    std::vector<Run> taken;
    while (!waiting.empty()) {
        const std::size_t first = *waiting.begin();
        waiting.erase(waiting.begin());
        if (claims.leave_free(runs[first])) {
            claims.take(runs[first]);
            taken.push_back(runs[first]);
            continue;
        }
        for (Run& part : claims.free_parts(runs[first])) {
            if (!long_enough(part) || !(part.length < runs[first].length)) continue;
            runs.push_back(std::move(part));
            waiting.insert(runs.size() - 1);
        }
    }
    return taken;
}

/// Removes the runs that do not end as seams do, with their claims, and returns them.
std::vector<Run> drop_crossings(const std::vector<PlacedChain>& chains, const std::vector<Touch>& touches,
                                std::vector<Run>& runs, double tolerance, RunClaims& claims) {
    const std::vector<bool> ends_well = find_well_ended(chains, touches, runs, tolerance);
    std::vector<Run> kept, dropped;
    for (std::size_t r = 0; r < runs.size(); ++r) (ends_well[r] ? kept : dropped).push_back(std::move(runs[r]));
    runs = std::move(kept);
    claims.clear();
    for (const Run& run : runs) claims.take(run);
    return dropped;
}

bool is_same_place(const Run& p, const Run& q) {
    const auto place = [](const Run& run) { return std::tuple(run.a, run.b, run.start_a(), run.end_a(), run.low_b); };
    return place(p) == place(q);
}

/// The runs that are seams. Removes runs that merely cross each other from `runs`.
std::vector<Run> sew(const std::vector<Tile>& tiles, const std::vector<PlacedChain>& chains,
                     const std::vector<Touch>& touches, std::vector<Run>& runs, double tolerance, RunClaims& claims) {
    const auto no_touch = [&](const Run& run) { return run.length > shortest_run * tolerance; };
    std::vector<Run> sewn = take_longest_first(tiles, chains, runs, claims, no_touch);
    const std::vector<Run> dropped = drop_crossings(chains, touches, sewn, tolerance, claims);
    if (!dropped.empty()) {  // a seam may lie where one of them was
        std::erase_if(runs, [&](const Run& run) {
            return std::any_of(dropped.begin(), dropped.end(), [&](const Run& one) { return is_same_place(one, run); });
        });
        for (Run& run : take_longest_first(tiles, chains, runs, claims, no_touch)) sewn.push_back(std::move(run));
        drop_crossings(chains, touches, sewn, tolerance, claims);
    }
    std::sort(sewn.begin(), sewn.end(), [](const Run& p, const Run& q) {
        return std::tuple(p.a, p.start_a(), p.b, p.low_b) < std::tuple(q.a, q.start_a(), q.b, q.low_b);
    });
    return sewn;
}

/// The direction out of a tile across its boundary edge, in the plane of the triangle there.
Vec3 outward_at(const Tile& tile, const PlacedChain& placed, double at) {
    const int edge = std::clamp(static_cast<int>(at) % placed.curve.edge_count(), 0, placed.curve.edge_count() - 1);
    const int k = (placed.first_edge + edge) % placed.boundary_edges;
    const int from = tile.boundary[static_cast<std::size_t>(k)];
    const int to = tile.boundary[static_cast<std::size_t>((k + 1) % placed.boundary_edges)];
    const Vec3 p = tile.mesh.positions.row(from), along = (Vec3(tile.mesh.positions.row(to)) - p).normalized();
    for (Eigen::Index f = 0; f < tile.mesh.triangles.rows(); ++f)
        for (int c = 0; c < 3; ++c) {
            if (tile.mesh.triangles(f, c) != from || tile.mesh.triangles(f, (c + 1) % 3) != to) continue;
            const Vec3 inward = Vec3(tile.mesh.positions.row(tile.mesh.triangles(f, (c + 2) % 3))) - p;
            return -(inward - along * along.dot(inward)).normalized();
        }
    return Vec3::Zero();
}

NearMiss near_miss(const std::vector<Tile>& tiles, const std::vector<PlacedChain>& chains, const Run& run) {
    const PlacedChain& a = chains[at(run.a)];
    const PlacedChain& b = chains[at(run.b)];
    const Touch& worst = *std::max_element(run.touches.begin(), run.touches.end(),
                                           [](const Touch& p, const Touch& q) { return p.distance < q.distance; });
    return {a.tile,
            a.chain,
            b.tile,
            b.chain,
            run.length,
            run.gap,
            (point_at(a.curve, worst.at_a) + point_at(b.curve, worst.at_b)) / 2,
            (point_at(a.curve, worst.at_a) - point_at(b.curve, worst.at_b))
                .dot(outward_at(tiles[at(a.tile)], a, worst.at_a))};
}

std::string seam_id(std::size_t index, std::size_t count) {
    return "S" + padded(index + 1, count, 4);
}

}  // namespace

namespace {

double median_length(const std::vector<PlacedChain>& chains) {
    std::vector<double> lengths;
    for (const PlacedChain& chain : chains) lengths.push_back(chain.curve.length());
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    return lengths.empty() ? 0 : *middle;
}

/// True if the chains are so short that every edge is near every other. Seams mean nothing then, and the search
/// would take minutes.
bool are_too_short(const std::vector<PlacedChain>& chains, double tolerance) {
    return chains.size() > few_chains && !(median_length(chains) > shortest_chain * tolerance);
}

/// Makes the seams, and returns their places: first those of two sheets, then the further sheets sewn into them.
std::vector<RunOnSeam> make_seams(const std::vector<Tile>& tiles, const std::vector<PlacedChain>& chains,
                                  const std::vector<Touch>& touches, std::vector<Run>& opposed, double tolerance,
                                  RunClaims& claims, FoundSeams& found) {
    std::vector<RunOnSeam> places;
    for (const Run& run : sew(tiles, chains, touches, opposed, tolerance, claims)) {
        found.seams.push_back(make_seam(chains, run, tolerance));
        places.push_back({run.a, run.b, ends_of(chains, run, tolerance)});
    }
    const std::vector<RunOnSeam> skin = places;
    for (const SewnInRun& sheet : find_sewn_in(chains, opposed, skin, tolerance, claims)) {
        found.seams.push_back(make_sewn_in(chains, sheet, found.seams, skin[sheet.seam]));
        places.push_back({sheet.run.a, sheet.run.b, sheet.ends});
    }
    for (std::size_t s = 0; s < places.size(); ++s) {
        found.seams[s].id = seam_id(s, places.size());
        found.places.push_back(places[s].ends);
    }
    return places;
}

/// The pairs of edges that run the same way, although neither belongs to a further sheet.
std::vector<NearMiss> find_same_way(const std::vector<Tile>& tiles, const std::vector<PlacedChain>& chains,
                                    const std::vector<Touch>& touches, const std::vector<Run>& same_way,
                                    const SheetOrder& order, const RunClaims& claims, double tolerance) {
    std::vector<NearMiss> found;
    std::set<std::pair<int, int>> competing;
    for (std::size_t r = 0; r < same_way.size(); ++r) {
        if (!order.competes[r]) continue;
        competing.insert({same_way[r].a, same_way[r].b});
        if (order.shows_turned[r]) found.push_back(near_miss(tiles, chains, same_way[r]));
    }
    for (const Run& run : runs_where(chains, touches, tolerance, [&](const Touch& t) {
             return t.same_way && t.distance <= tolerance + t.slack &&
                    !(claims.is_sewn(t.a, t.at_a) && claims.is_sewn(t.b, t.at_b));
         }))
        if (is_long_run(chains, run, tolerance) && !competing.contains({run.a, run.b}))
            found.push_back(near_miss(tiles, chains, run));
    return found;
}

}  // namespace

FoundSeams find_seams(const std::vector<Tile>& tiles, const SeamOptions& options) {
    const double tolerance = options.tolerance;
    if (!(tolerance > 0) || !std::isfinite(tolerance))
        throw InputError("the seam tolerance is " + format_shortest(tolerance / millimetre) +
                         " mm; give a length above 0");
    const std::vector<PlacedChain> chains = place_chains(tiles);
    if (are_too_short(chains, tolerance))
        throw InputError("half of the edges of the tiles are shorter than " +
                         format_fixed(median_length(chains) / millimetre, 3) +
                         " mm, too short for a seam tolerance of " + format_fixed(tolerance / millimetre, 3) +
                         " mm; check --unit, or give a smaller --seam-tolerance");
    ClothAcross across(tiles, chains);
    std::vector<Touch> touches = find_touches(chains, tolerance);
    std::erase_if(touches, [&](const Touch& t) { return !t.same_way && across.in_one_tile(t) && across.joins(t); });
    const auto within = [&](bool same_way) {
        return runs_where(chains, touches, tolerance,
                          [&](const Touch& t) { return t.same_way == same_way && t.distance <= tolerance + t.slack; });
    };
    std::vector<Run> opposed = within(false);
    const std::vector<Run> same_way = within(true);
    const SheetOrder order = order_sheets(tiles, chains, opposed, same_way, tolerance);
    RunClaims claims(chains, order.beside, tolerance);
    FoundSeams found;
    const std::vector<RunOnSeam> places = make_seams(tiles, chains, touches, opposed, tolerance, claims, found);
    found.loose = loose_runs_of(tiles, chains, places, tolerance);
    found.curve_lengths = curve_lengths_of(tiles, chains, found.seams, places, tolerance);

    const auto is_long = [&](const Run& run) { return is_long_run(chains, run, tolerance); };
    found.same_way = find_same_way(tiles, chains, touches, same_way, order, claims, tolerance);
    across.cross(found.seams);
    const auto may_miss = [&](const Touch& t) {
        if (t.same_way || claims.is_sewn(t)) return false;
        const double narrower = std::min(across.width_at(t.a), across.width_at(t.b));
        const double widest = across.in_one_tile(t) ? widest_slit * narrower : narrower;
        return t.distance <= std::max(widest, tolerance + t.slack) && !across.joins(t);
    };
    for (const Run& run :
         take_longest_first(tiles, chains, runs_where(chains, touches, tolerance, may_miss), claims, is_long))
        found.near_misses.push_back(near_miss(tiles, chains, run));
    std::sort(found.near_misses.begin(), found.near_misses.end(), [](const NearMiss& p, const NearMiss& q) {
        return std::tuple(p.tile_a, p.chain_a, p.tile_b, p.chain_b) <
               std::tuple(q.tile_a, q.chain_a, q.tile_b, q.chain_b);
    });
    return found;
}

void add_seams(Envelope& envelope, const SeamOptions& options) {
    if (options.tolerance > 0 && are_too_short(place_chains(envelope.tiles), options.tolerance)) return;
    FoundSeams found = find_seams(envelope.tiles, options);
    envelope.seams = std::move(found.seams);
    for (std::size_t t = 0; t < envelope.tiles.size(); ++t)
        envelope.tiles[t].curve_lengths = std::move(found.curve_lengths[t]);
}

}  // namespace ripstop
