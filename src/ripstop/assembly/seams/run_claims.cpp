#include "ripstop/assembly/seams/run_claims.h"

#include <algorithm>

#include "ripstop/base/index.h"

namespace ripstop {
namespace {

Touch between_touches(const Touch& p, const Touch& q, double share) {
    Touch touch = p;
    touch.at_a += share * (q.at_a - p.at_a);
    touch.at_b += share * (q.at_b - p.at_b);
    touch.distance = std::max(p.distance, q.distance);
    return touch;
}

}  // namespace

RunClaims::RunClaims(const std::vector<PlacedChain>& chains, const std::vector<Run>& beside, double tolerance)
    : chains_(chains),
      beside_(beside),
      beside_on_(chains.size()),
      tolerance_(tolerance),
      sewn_(chains.size()),
      on_seam_(chains.size()) {
    for (std::size_t r = 0; r < beside.size(); ++r) {
        beside_on_[at(beside[r].a)].push_back(r);
        if (beside[r].b != beside[r].a) beside_on_[at(beside[r].b)].push_back(r);
    }
}

void RunClaims::clear() {
    for (Ranges* ranges : {&sewn_, &on_seam_})
        for (auto& some : *ranges) some.clear();
}

void RunClaims::take(const Run& run) {
    take(run.a, run.start_a(), run.end_a());
    take(run.b, run.low_b, run.high_b);
    take_beside(run, run.a, run.start_a(), run.end_a());
    take_beside(run, run.b, run.low_b, run.high_b);
}

void RunClaims::take(int chain, double from, double to) {
    const ChainCurve& curve = chains_[at(chain)].curve;
    sewn_[at(chain)].push_back({station_at(curve, from), station_at(curve, to)});
}

void RunClaims::take_beside(const Run& run, int chain, double from, double to) {
    const ChainCurve& curve = chains_[at(chain)].curve;
    const double lap = curve.closed ? curve.edge_count() : 0;
    for (const std::size_t r : beside_on_[at(chain)]) {
        const Run& other = beside_[r];
        const bool by_b = other.b == chain;
        const int across = by_b ? other.a : other.b;
        if (is_of_one_tile(across, run)) continue;  // a pleat: its layers are sewn to each other
        const ChainCurve& its = chains_[at(across)].curve;
        for (const double turn : {-lap, 0.0, lap}) {
            if (const auto part = cut_run(chains_, other, by_b, from + turn, to + turn))
                on_seam_[at(across)].push_back(
                    by_b ? std::pair(station_at(its, part->start_a()), station_at(its, part->end_a()))
                         : std::pair(station_at(its, part->low_b), station_at(its, part->high_b)));
            if (lap == 0) break;
        }
    }
}

bool RunClaims::is_of_one_tile(int chain, const Run& run) const {
    const auto tile = [this](int c) { return chains_[at(c)].tile; };
    return tile(chain) == tile(run.a) || tile(chain) == tile(run.b);
}

bool RunClaims::covers(const Ranges& ranges, int chain, double at, double margin) const {
    const ChainCurve& curve = chains_[static_cast<std::size_t>(chain)].curve;
    const double lap = curve.closed ? curve.length() : 0;
    const double station = station_at(curve, at);
    for (const auto& [low, high] : ranges[static_cast<std::size_t>(chain)])
        for (const double turn : {-lap, 0.0, lap}) {
            if (station + turn > low + margin && station + turn < high - margin) return true;
            if (lap == 0) break;
        }
    return false;
}

bool RunClaims::leave_free(const Run& run) const {
    for (std::size_t i = 0; i < run.touches.size(); ++i) {
        if (is_taken(run.touches[i])) return false;
        if (i == 0) continue;
        const Touch& p = run.touches[i - 1];
        const Touch& q = run.touches[i];
        if (is_taken(p.a, (p.at_a + q.at_a) / 2) || is_taken(p.b, (p.at_b + q.at_b) / 2)) return false;
    }
    return true;
}

bool RunClaims::leave_a_unsewn(const Run& run) const {
    for (std::size_t i = 0; i < run.touches.size(); ++i) {
        if (is_sewn(run.a, run.touches[i].at_a)) return false;
        if (i > 0 && is_sewn(run.a, (run.touches[i - 1].at_a + run.touches[i].at_a) / 2)) return false;
    }
    return true;
}

std::vector<Run> RunClaims::free_parts(const Run& run) const {
    std::vector<Run> parts;
    std::vector<Touch> free;
    const bool to_the_end = run.rank != 0;
    const auto add_end = [&](const Touch& taken, const Touch& open) {
        if (!to_the_end) return;
        if (const auto end = end_of_taken(taken, open)) free.push_back(*end);
    };
    const auto end_part = [&] {
        for (Run& part : join_touches(chains_, free, tolerance_)) parts.push_back(std::move(part));
        free.clear();
    };
    for (std::size_t i = 0; i < run.touches.size(); ++i) {
        const Touch& touch = run.touches[i];
        const bool taken = is_taken(touch);
        if (i > 0) {
            const Touch& before = run.touches[i - 1];
            const Touch between = between_touches(before, touch, 0.5);
            const bool before_taken = is_taken(before);
            if (!before_taken && !taken && is_taken(between)) {
                add_end(between, before);
                end_part();
                add_end(between, touch);
            }
            if (before_taken && !taken) add_end(before, touch);
            if (!before_taken && taken) add_end(touch, before);
        }
        if (taken)
            end_part();
        else
            free.push_back(touch);
    }
    end_part();
    return parts;
}

std::optional<Touch> RunClaims::end_of_taken(const Touch& taken, const Touch& open) const {
    const auto within = [&](const Touch& touch) {
        for (const Ranges* ranges : {&sewn_, &on_seam_})
            if (covers(*ranges, touch.a, touch.at_a, 0) || covers(*ranges, touch.b, touch.at_b, 0)) return true;
        return false;
    };
    if (within(open)) return {};
    double low = 0, high = 1;
    for (int halving = 0; halving < 50; ++halving) {
        const double middle = (low + high) / 2;
        (within(between_touches(taken, open, middle)) ? low : high) = middle;
    }
    return between_touches(taken, open, high);
}

}  // namespace ripstop
