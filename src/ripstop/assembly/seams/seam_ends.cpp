#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "ripstop/assembly/seams/limits.h"
#include "ripstop/assembly/seams/seam_runs.h"

namespace ripstop {
namespace {

constexpr double one_place = 0.1;  // tolerances: vertices this close coincide; those of crossing edges rarely do

/// One end of a run, as arc length on both chains.
struct RunEnd {
    double on_a = 0, on_b = 0;
};

class EndFinder {
  public:
    EndFinder(const std::vector<PlacedChain>& chains, const std::vector<Touch>& touches, const std::vector<Run>& runs,
              double tolerance)
        : chains_(chains),
          touches_(touches),
          runs_(runs),
          tolerance_(tolerance),
          near_(near_end * tolerance),
          kept_(runs.size(), true) {
        for (std::size_t r = 0; r < runs.size(); ++r) {
            const Run& run = runs[r];
            ends_.push_back({RunEnd{station_at(a(run), run.start_a()), station_at(b(run), run.high_b)},
                             RunEnd{station_at(a(run), run.end_a()), station_at(b(run), run.low_b)}});
            runs_on_[run.a].push_back(r);
            if (run.b != run.a) runs_on_[run.b].push_back(r);
        }
    }

    std::vector<bool> find() {
        for (bool removed = true; removed;) {
            removed = false;
            for (std::size_t r = 0; r < runs_.size(); ++r) {
                if (!kept_[r] || (ends_well(r, 0) && ends_well(r, 1))) continue;
                kept_[r] = false;
                removed = true;
            }
        }
        return kept_;
    }

  private:
    const ChainCurve& curve(int chain) const { return chains_[static_cast<std::size_t>(chain)].curve; }
    const ChainCurve& a(const Run& run) const { return curve(run.a); }
    const ChainCurve& b(const Run& run) const { return curve(run.b); }

    static double apart(const ChainCurve& curve, double p, double q) {
        return curve.closed ? std::abs(std::remainder(p - q, curve.length())) : std::abs(p - q);
    }
    bool at_chain_end(const ChainCurve& curve, double at) const {
        return !curve.closed && (at < near_ || at > curve.length() - near_);
    }
    bool goes_round(const ChainCurve& curve, double from, double to) const {
        return curve.closed && std::abs(to - from) > curve.length() - near_;
    }

    bool ends_well(std::size_t r, std::size_t which) const {
        const Run& run = runs_[r];
        const RunEnd& end = ends_[r][which];
        const RunEnd& far = ends_[r][1 - which];
        if (at_chain_end(a(run), end.on_a) || at_chain_end(b(run), end.on_b)) return true;
        if (goes_round(a(run), end.on_a, far.on_a) || goes_round(b(run), end.on_b, far.on_b)) return true;
        if (run.a == run.b && apart(a(run), end.on_a, end.on_b) < near_) return true;
        if (parts_at_vertices(run, which)) return true;
        return meets_another(r, run.a, end.on_a) || meets_another(r, run.b, end.on_b) || goes_on(r, which) ||
               meets_at_corner(r, which);
    }

    /// True if the chains share all vertices up to this end and none beyond it.
    bool parts_at_vertices(const Run& run, std::size_t which) const {
        const Touch& last = which == 0 ? run.touches.front() : run.touches.back();
        return run.gap < one_place * tolerance_ && std::abs(last.at_a - std::round(last.at_a)) < one_vertex &&
               std::abs(last.at_b - std::round(last.at_b)) < one_vertex;
    }

    /// True if the two chains meet again where both end. Between, curves with few vertices may diverge.
    bool meets_at_corner(std::size_t r, std::size_t which) const {
        const Run& run = runs_[r];
        const double ahead = which == 1 ? 1 : -1;
        const auto pair = [](const Touch& t) { return std::tuple(t.a, t.b, t.same_way); };
        const auto first =
            std::lower_bound(touches_.begin(), touches_.end(), std::tuple(run.a, run.b, false),
                             [&](const Touch& t, const std::tuple<int, int, bool>& key) { return pair(t) < key; });
        for (auto touch = first; touch != touches_.end() && pair(*touch) == std::tuple(run.a, run.b, false); ++touch) {
            if (touch->distance > tolerance_) continue;
            const double on_a = station_at(a(run), touch->at_a), on_b = station_at(b(run), touch->at_b);
            if (!at_chain_end(a(run), on_a) || !at_chain_end(b(run), on_b)) continue;
            const double gap_a = ahead * (on_a - ends_[r][which].on_a);
            const double gap_b = ahead * (ends_[r][which].on_b - on_b);
            if (std::min(gap_a, gap_b) > -near_ && std::max(gap_a, gap_b) < 2 * run.length) return true;
        }
        return false;
    }

    /// True if another run ends at this place of the chain.
    bool meets_another(std::size_t r, int chain, double at) const {
        for (const std::size_t other : runs_on_.at(chain)) {
            if (other == r || !kept_[other]) continue;
            for (const RunEnd& end : ends_[other]) {
                if (runs_[other].a == chain && apart(curve(chain), end.on_a, at) < near_) return true;
                if (runs_[other].b == chain && apart(curve(chain), end.on_b, at) < near_) return true;
            }
        }
        return false;
    }

    /// True if another run on the same two chains continues farther along both.
    bool goes_on(std::size_t r, std::size_t which) const {
        const double ahead = which == 1 ? 1 : -1;
        for (const std::size_t other : runs_on_.at(runs_[r].a)) {
            if (other == r || !kept_[other] || runs_[other].a != runs_[r].a || runs_[other].b != runs_[r].b) continue;
            const double gap_a = ahead * (ends_[other][1 - which].on_a - ends_[r][which].on_a);
            const double gap_b = ahead * (ends_[r][which].on_b - ends_[other][1 - which].on_b);
            const double longest = runs_[r].length + runs_[other].length;
            if (std::min(gap_a, gap_b) > -near_ && std::max(gap_a, gap_b) < longest) return true;
        }
        return false;
    }

    const std::vector<PlacedChain>& chains_;
    const std::vector<Touch>& touches_;
    const std::vector<Run>& runs_;
    double tolerance_, near_;
    std::vector<bool> kept_;
    std::vector<std::array<RunEnd, 2>> ends_;
    std::map<int, std::vector<std::size_t>> runs_on_;
};

}  // namespace

std::vector<bool> find_well_ended(const std::vector<PlacedChain>& chains, const std::vector<Touch>& touches,
                                  const std::vector<Run>& runs, double tolerance) {
    return EndFinder(chains, touches, runs, tolerance).find();
}

}  // namespace ripstop
