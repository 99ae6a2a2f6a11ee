#include "ripstop/assembly/find_seams.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "ripstop/assembly/seam_lengths.h"
#include "ripstop/assembly/seam_runs.h"
#include "ripstop/base/error.h"
#include "ripstop/base/number_text.h"

namespace ripstop {
namespace {

constexpr double shortest_run = 4;      // tolerances: chains that meet at a corner touch for less
constexpr double shortest_chain = 20;   // tolerances, in the middle of an envelope
constexpr std::size_t few_chains = 40;  // so few are searched whatever their size
constexpr double shortest_miss = 0.25;  // of the shorter chain

/// What of the chains is sewn already.
class Claims {
  public:
    Claims(const std::vector<PlacedChain>& chains, double tolerance)
        : chains_(chains), tolerance_(tolerance), taken_(chains.size()) {}

    void clear() {
        for (auto& ranges : taken_) ranges.clear();
    }
    void take(const Run& run) {
        take(run.a, run.start_a(), run.end_a());
        take(run.b, run.low_b, run.high_b);
    }
    /// Does the place lie within what is taken, further than the tolerance from its ends?
    bool covers(int chain, double at) const {
        const ChainCurve& curve = chains_[static_cast<std::size_t>(chain)].curve;
        const double lap = curve.closed ? curve.length() : 0;
        const double station = station_at(curve, at);
        for (const auto& [low, high] : taken_[static_cast<std::size_t>(chain)])
            for (const double turn : {-lap, 0.0, lap}) {
                if (station + turn > low + tolerance_ && station + turn < high - tolerance_) return true;
                if (lap == 0) break;
            }
        return false;
    }
    bool covers(const Touch& touch) const { return covers(touch.a, touch.at_a) || covers(touch.b, touch.at_b); }

    /// Is nothing taken where the run goes, at its touches and between them?
    bool leave_free(const Run& run) const {
        for (std::size_t i = 0; i < run.touches.size(); ++i) {
            if (covers(run.touches[i])) return false;
            if (i == 0) continue;
            const Touch& p = run.touches[i - 1];
            const Touch& q = run.touches[i];
            if (covers(p.a, (p.at_a + q.at_a) / 2) || covers(p.b, (p.at_b + q.at_b) / 2)) return false;
        }
        return true;
    }

  private:
    void take(int chain, double from, double to) {
        const ChainCurve& curve = chains_[static_cast<std::size_t>(chain)].curve;
        taken_[static_cast<std::size_t>(chain)].push_back({station_at(curve, from), station_at(curve, to)});
    }

    const std::vector<PlacedChain>& chains_;
    double tolerance_;
    std::vector<std::vector<std::pair<double, double>>> taken_;
};

/// The parts of a run where nothing is taken yet.
std::vector<Run> free_parts(const std::vector<PlacedChain>& chains, const Run& run, const Claims& claims,
                            double tolerance) {
    std::vector<Run> parts;
    std::vector<Touch> free;
    const auto end_part = [&] {
        for (Run& part : join_touches(chains, free, tolerance)) parts.push_back(std::move(part));
        free.clear();
    };
    for (std::size_t i = 0; i < run.touches.size(); ++i) {
        const Touch& touch = run.touches[i];
        if (claims.covers(touch)) {
            end_part();
            continue;
        }
        if (!free.empty() && (claims.covers(touch.a, (free.back().at_a + touch.at_a) / 2) ||
                              claims.covers(touch.b, (free.back().at_b + touch.at_b) / 2)))
            end_part();
        free.push_back(touch);
    }
    end_part();
    return parts;
}

/// The touches of each pair of chains and direction that pass `wanted`, joined.
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

/// Takes the longest run first and of the others what it leaves free, down to the shortest allowed.
template <class LongEnough>
std::vector<Run> take_longest_first(const std::vector<PlacedChain>& chains, std::vector<Run> runs, double tolerance,
                                    Claims& claims, LongEnough&& long_enough) {
    const auto before = [&runs](std::size_t p, std::size_t q) {
        const Run &r = runs[p], &s = runs[q];
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
        for (Run& part : free_parts(chains, runs[first], claims, tolerance)) {
            if (!long_enough(part) || !(part.length < runs[first].length)) continue;
            runs.push_back(std::move(part));
            waiting.insert(runs.size() - 1);
        }
    }
    return taken;
}

/// Leaves the runs that end as seams do, and their claims; returns the others.
std::vector<Run> drop_crossings(const std::vector<PlacedChain>& chains, const std::vector<Touch>& touches,
                                std::vector<Run>& runs, double tolerance, Claims& claims) {
    const std::vector<bool> ends_well = find_well_ended(chains, touches, runs, tolerance);
    std::vector<Run> kept, dropped;
    for (std::size_t r = 0; r < runs.size(); ++r) (ends_well[r] ? kept : dropped).push_back(std::move(runs[r]));
    runs = std::move(kept);
    claims.clear();
    for (const Run& run : runs) claims.take(run);
    return dropped;
}

/// The runs that are seams.
std::vector<Run> sew(const std::vector<PlacedChain>& chains, const std::vector<Touch>& touches, double tolerance,
                     Claims& claims) {
    const auto no_touch = [&](const Run& run) { return run.length > shortest_run * tolerance; };
    std::vector<Run> runs = runs_where(
        chains, touches, tolerance, [&](const Touch& t) { return !t.same_way && t.distance <= tolerance + t.slack; });
    std::vector<Run> sewn = take_longest_first(chains, runs, tolerance, claims, no_touch);
    const std::vector<Run> dropped = drop_crossings(chains, touches, sewn, tolerance, claims);
    if (!dropped.empty()) {  // a seam may lie where one of them lay
        const auto place = [](const Run& run) {
            return std::tuple(run.a, run.b, run.start_a(), run.end_a(), run.low_b);
        };
        std::set<std::tuple<int, int, double, double, double>> gone;
        for (const Run& run : dropped) gone.insert(place(run));
        std::erase_if(runs, [&](const Run& run) { return gone.contains(place(run)); });
        for (Run& run : take_longest_first(chains, std::move(runs), tolerance, claims, no_touch))
            sewn.push_back(std::move(run));
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
    const PlacedChain& a = chains[static_cast<std::size_t>(run.a)];
    const PlacedChain& b = chains[static_cast<std::size_t>(run.b)];
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
                .dot(outward_at(tiles[static_cast<std::size_t>(a.tile)], a, worst.at_a))};
}

std::string seam_id(std::size_t index, std::size_t count) {
    const std::string number = std::to_string(index + 1);
    const std::size_t digits = std::max<std::size_t>(4, std::to_string(count).size());
    return "S" + std::string(digits - number.size(), '0') + number;
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

/// Beyond this everything lies beside everything: no seam means anything, and the search would take minutes.
bool are_too_short(const std::vector<PlacedChain>& chains, double tolerance) {
    return chains.size() > few_chains && !(median_length(chains) > shortest_chain * tolerance);
}

}  // namespace

FoundSeams find_seams(const std::vector<Tile>& tiles, const SeamOptions& options) {
    const double tolerance = options.tolerance;
    if (!(tolerance > 0) || !std::isfinite(tolerance))
        throw InputError("the seam tolerance is " + format_shortest(tolerance / millimetre) +
                         " mm; give a length above 0");
    const std::vector<PlacedChain> chains = place_chains(tiles);
    if (are_too_short(chains, tolerance))
        throw InputError(
            "the edges of the tiles are short, half of them less than " +
            format_fixed(median_length(chains) / millimetre, 3) + " mm, and mean nothing against a seam tolerance of " +
            format_fixed(tolerance / millimetre, 3) + " mm; check --unit, or give a smaller --seam-tolerance");
    const std::vector<Touch> touches = find_touches(chains, tolerance);
    const auto shorter = [&](const Run& run) {
        return std::min(chains[static_cast<std::size_t>(run.a)].curve.length(),
                        chains[static_cast<std::size_t>(run.b)].curve.length());
    };
    const auto is_long = [&](const Run& run) {
        return run.length > shortest_run * tolerance && run.length > shortest_miss * shorter(run);
    };
    Claims claims(chains, tolerance);

    const std::vector<Run> sewn = sew(chains, touches, tolerance, claims);
    FoundSeams found;
    std::vector<RunOnSeam> places;
    for (const Run& run : sewn) {
        found.seams.push_back(make_seam(chains, run, tolerance));
        found.seams.back().id = seam_id(places.size(), sewn.size());
        places.push_back({run.a, run.b, ends_of(chains, run, tolerance)});
        found.places.push_back(places.back().ends);
    }
    found.loose = loose_runs_of(tiles, chains, places, tolerance);
    found.curve_lengths = curve_lengths_of(tiles, chains, found.seams, places, tolerance);

    for (const Run& run : runs_where(chains, touches, tolerance, [&](const Touch& t) {
             return t.same_way && t.distance <= tolerance + t.slack &&
                    !(claims.covers(t.a, t.at_a) && claims.covers(t.b, t.at_b));
         }))
        if (is_long(run)) found.same_way.push_back(near_miss(tiles, chains, run));
    for (const Run& run : take_longest_first(
             chains,
             runs_where(chains, touches, tolerance, [&](const Touch& t) { return !t.same_way && !claims.covers(t); }),
             tolerance, claims, is_long))
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
