#include "ripstop/assembly/seams/sewn_in.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "ripstop/assembly/seams/limits.h"
#include "ripstop/base/index.h"

namespace ripstop {
namespace {

constexpr double shortest_edge = 0.25;  // share of the shorter of the sheet's chain and the seam
constexpr double same_vertex = 1e-9;    // share of an edge

const ChainCurve& curve_of(const std::vector<PlacedChain>& chains, int c) {
    return chains[at(c)].curve;
}

/// A side of a seam as an ascending run of its chain.
struct Side {
    int chain;
    double low, high;
};
Side side_of(const RunOnSeam& place, bool b) {
    return b ? Side{place.b, place.ends.start_b, place.ends.end_b}
             : Side{place.a, place.ends.start_a, place.ends.end_a};
}

/// The ends of the sheet, moved to vertices and to the seam's ends within the tolerance.
RunEnds ends_on(const std::vector<PlacedChain>& chains, const Run& run, const Side& side, double tolerance) {
    const ChainCurve &a = curve_of(chains, run.a), &b = curve_of(chains, run.b);
    const auto brought = [&](const ChainCurve& curve, double at, double to) {
        return std::abs(station_at(curve, at) - station_at(curve, to)) < tolerance ? to : at;
    };
    const auto on_b = [&](double at, double end) {
        const double to_end = brought(b, at, end);
        return to_end == end ? end : brought(b, at, std::round(at));
    };
    return {brought(a, run.start_a(), std::round(run.start_a())), brought(a, run.end_a(), std::round(run.end_a())),
            on_b(run.low_b, side.low), on_b(run.high_b, side.high)};
}

/// True if the sheet ends properly: at the end of its own chain or after a full loop, at the seam's end, or at a
/// vertex of both.
bool ends_well(const std::vector<PlacedChain>& chains, const SewnInRun& sheet, const Side& side, double tolerance) {
    const ChainCurve &a = curve_of(chains, sheet.run.a), &b = curve_of(chains, sheet.run.b);
    const double near = near_end * tolerance, from = station_at(a, sheet.ends.start_a),
                 to = station_at(a, sheet.ends.end_a);
    if (a.closed && to - from > a.length() - near) return true;
    const auto ends = [&](double on_a, double at_a, double at_b, double seam_end) {
        if (!a.closed && (on_a < near || on_a > a.length() - near)) return true;
        if (std::abs(station_at(b, at_b) - station_at(b, seam_end)) < near) return true;
        return std::abs(at_a - std::round(at_a)) < one_vertex && std::abs(at_b - std::round(at_b)) < one_vertex;
    };
    return ends(from, sheet.ends.start_a, sheet.ends.end_b, side.high) &&
           ends(to, sheet.ends.end_a, sheet.ends.start_b, side.low);
}

/// Adds the part of the sheet along one seam, if there is one.
void add_along(const std::vector<PlacedChain>& chains, const Run& run, std::size_t seam, bool on_side_b,
               const RunOnSeam& place, double tolerance, std::vector<SewnInRun>& found) {
    const Side side = side_of(place, on_side_b);
    const int own = chains[at(run.a)].tile;
    for (const int chain : {place.a, place.b})
        if (chains[at(chain)].tile == own) return;
    const ChainCurve &sheet = curve_of(chains, run.a), &skin = curve_of(chains, run.b);
    const double lap = skin.closed ? skin.edge_count() : 0;
    for (const double turn : {-lap, 0.0, lap}) {
        if (auto part = cut_run(chains, run, true, side.low + turn, side.high + turn)) {
            for (Touch& touch : part->touches) touch.at_b -= turn;
            part->low_b -= turn;
            part->high_b -= turn;
            const double edge = std::min(sheet.length(), station_at(skin, side.high) - station_at(skin, side.low));
            if (part->length > shortest_run * tolerance && part->length > shortest_edge * edge) {
                const RunEnds ends = ends_on(chains, *part, side, tolerance);
                SewnInRun along{std::move(*part), seam, on_side_b, ends};
                if (ends_well(chains, along, side, tolerance)) found.push_back(std::move(along));
            }
        }
        if (lap == 0) break;
    }
}

/// Arc length along the seam's curve, at places of the chain of one side.
class SideLength {
  public:
    SideLength(const SeamSide& parts, const Side& side) : at_{side.low}, length_{0} {
        for (std::size_t k = 0; k < parts.parts.size(); ++k) {
            const double next = std::floor(at_.back()) + 1;
            at_.push_back(k + 1 == parts.parts.size() ? side.high : next);
            length_.push_back(length_.back() + parts.parts[k].length);
        }
    }
    double operator()(double at) const {
        const auto above = std::upper_bound(at_.begin() + 1, at_.end() - 1, at);
        const auto i = static_cast<std::size_t>(above - at_.begin());
        const double share = std::clamp((at - at_[i - 1]) / (at_[i] - at_[i - 1]), 0.0, 1.0);
        return length_[i - 1] + share * (length_[i] - length_[i - 1]);
    }
    double whole() const { return length_.back(); }

  private:
    std::vector<double> at_, length_;
};

/// The places of the sheet's breaks on the seam's curve, descending. Each vertex is projected onto the seam; if
/// that would squeeze an edge, all are placed in proportion.
std::vector<double> places_of(const ChainCurve& sheet, const std::vector<double>& breaks, const Run& run,
                              const SideLength& along, double low, double high) {
    std::vector<double> places(breaks.size());
    places.front() = high;
    places.back() = low;
    const double from = station_at(sheet, breaks.front());
    const double stretch = (high - low) / (station_at(sheet, breaks.back()) - from);
    const auto in_proportion = [&](double at) { return high - stretch * (station_at(sheet, at) - from); };
    for (std::size_t k = 1; k + 1 < breaks.size(); ++k) {
        const auto touch = std::lower_bound(run.touches.begin(), run.touches.end(), breaks[k] - same_vertex,
                                            [](const Touch& t, double at) { return t.at_a < at; });
        const bool is_there = touch != run.touches.end() && touch->at_a < breaks[k] + same_vertex;
        places[k] = is_there ? along(touch->at_b) : in_proportion(breaks[k]);
    }
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
        const double own = stretch * (station_at(sheet, breaks[k + 1]) - station_at(sheet, breaks[k]));
        const double part = places[k] - places[k + 1];
        if (part > fair_share_low * own && part < fair_share_high * own) continue;
        for (std::size_t i = 1; i + 1 < breaks.size(); ++i) places[i] = in_proportion(breaks[i]);
        break;
    }
    return places;
}

SeamSide make_sheet_side(const PlacedChain& chain, const std::vector<double>& breaks,
                         const std::vector<double>& places) {
    SeamSide side{chain.tile, chain.chain, {}};
    const int count = chain.curve.edge_count();
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
        const int edge = ((static_cast<int>(std::floor(breaks[k])) % count) + count) % count;
        side.parts.push_back({(chain.first_edge + edge) % chain.boundary_edges, std::abs(places[k + 1] - places[k])});
    }
    return side;
}

}  // namespace

std::vector<SewnInRun> find_sewn_in(const std::vector<PlacedChain>& chains, const std::vector<Run>& opposed,
                                    const std::vector<RunOnSeam>& places, double tolerance, RunClaims& claims) {
    std::vector<std::vector<std::pair<std::size_t, bool>>> seams_on(chains.size());
    for (std::size_t s = 0; s < places.size(); ++s)
        for (const bool b : {false, true}) seams_on[at(b ? places[s].b : places[s].a)].push_back({s, b});
    std::vector<SewnInRun> found;
    for (const Run& run : opposed)
        for (const bool from_b : {false, true}) {
            const Run seen = from_b ? seen_from_b(run) : run;
            for (const auto& [seam, b] : seams_on[at(seen.b)])
                add_along(chains, seen, seam, b, places[seam], tolerance, found);
        }
    std::sort(found.begin(), found.end(), [](const SewnInRun& p, const SewnInRun& q) {
        return std::tuple(-p.run.length, p.run.gap, p.run.a, p.run.b, p.run.start_a(), p.seam) <
               std::tuple(-q.run.length, q.run.gap, q.run.a, q.run.b, q.run.start_a(), q.seam);
    });
    std::vector<SewnInRun> taken;
    for (SewnInRun& sheet : found) {
        if (!claims.leave_a_unsewn(sheet.run)) continue;
        claims.take_a(sheet.run);
        taken.push_back(std::move(sheet));
    }
    std::sort(taken.begin(), taken.end(), [](const SewnInRun& p, const SewnInRun& q) {
        return std::tuple(p.run.a, p.run.start_a(), p.seam) < std::tuple(q.run.a, q.run.start_a(), q.seam);
    });
    return taken;
}

Seam make_sewn_in(const std::vector<PlacedChain>& chains, const SewnInRun& sheet, const std::vector<Seam>& seams,
                  const RunOnSeam& place) {
    const PlacedChain& a = chains[static_cast<std::size_t>(sheet.run.a)];
    const PlacedChain& b = chains[static_cast<std::size_t>(sheet.run.b)];
    const Seam& skin = seams[sheet.seam];
    const SideLength along(sheet.on_side_b ? skin.b : skin.a, side_of(place, sheet.on_side_b));
    const RunEnds& ends = sheet.ends;
    const double low = along(ends.start_b), high = along(ends.end_b);
    const std::vector<double> breaks_a = breaks_between(ends.start_a, ends.end_a);
    const std::vector<double> breaks_b = breaks_between(ends.start_b, ends.end_b);
    std::vector<double> on_b;
    for (const double at : breaks_b) on_b.push_back(along(at));
    const bool same_vertices = conforms(a.curve, b.curve, ends);

    Seam seam;
    seam.gap = sheet.run.gap;
    seam.a = make_sheet_side(a, breaks_a,
                             same_vertices ? std::vector<double>(on_b.rbegin(), on_b.rend())
                                           : places_of(a.curve, breaks_a, sheet.run, along, low, high));
    seam.b = make_sheet_side(b, breaks_b, on_b);
    for (const SeamPart& part : seam.b.parts) seam.length += part.length;
    seam.into = {static_cast<int>(sheet.seam), sheet.on_side_b ? along.whole() - high : low, !sheet.on_side_b};
    const double share = seam.length / skin.length;
    seam.uncertainty = share * skin.uncertainty;
    if (!same_vertices) {
        const double own = station_at(a.curve, ends.end_a) - station_at(a.curve, ends.start_a);
        const double skins = station_at(b.curve, ends.end_b) - station_at(b.curve, ends.start_b);
        seam.uncertainty += std::abs(own - skins);
    }
    return seam;
}

}  // namespace ripstop
