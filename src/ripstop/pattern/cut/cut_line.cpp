#include "ripstop/pattern/cut/cut_line.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <polyclipping/clipper.hpp>

#include "ripstop/geometry/simplify.h"
#include "ripstop/geometry/triangle.h"
#include "ripstop/pattern/cut/allowance_fit.h"

namespace ripstop {
namespace {

using ClipperLib::cInt;
using ClipperLib::IntPoint;
using ClipperLib::Path;

constexpr double steps_per_metre = 1e7;   // 0.1 micrometre; 64-bit integers hold a million kilometres
constexpr double fit_error = 1e-5;        // of a reach between two of its samples [m]
constexpr double finest = 1e-4;           // between samples [m]
constexpr double coarsest = 5e-3;         // between samples, where there is no allowance [m]
constexpr double chord_error = 5e-6;      // of the fitted cut line [m]
constexpr double nothing_missing = 6e-5;  // [m]: the slot between allowances that just fit, plus rounding

IntPoint to_steps(const Vec2& p) {
    return {static_cast<cInt>(std::llround(p.x() * steps_per_metre)),
            static_cast<cInt>(std::llround(p.y() * steps_per_metre))};
}

/// The outer boundary of a contour that may cross itself: the largest outline of the region with positive winding
/// number.
Points2 outside_of(const std::vector<Vec2>& contour) {
    Path path;
    for (const Vec2& p : contour) path.push_back(to_steps(p));
    ClipperLib::Clipper clipper;
    clipper.AddPath(path, ClipperLib::ptSubject, true);
    ClipperLib::Paths parts;
    clipper.Execute(ClipperLib::ctUnion, parts, ClipperLib::pftPositive, ClipperLib::pftPositive);
    const auto largest = std::max_element(parts.begin(), parts.end(), [](const Path& a, const Path& b) {
        return ClipperLib::Area(a) < ClipperLib::Area(b);
    });
    if (largest == parts.end()) return Points2(0, 2);
    ClipperLib::CleanPolygon(*largest, 2);  // removes points within 0.2 micrometres of the line of their neighbours
    Points2 outline(static_cast<Eigen::Index>(largest->size()), 2);
    for (std::size_t i = 0; i < largest->size(); ++i)
        outline.row(static_cast<Eigen::Index>(i)) << static_cast<double>((*largest)[i].X) / steps_per_metre,
            static_cast<double>((*largest)[i].Y) / steps_per_metre;
    return outline;
}

struct Sample {
    double along;
    ReachLimit limit;
};

/// The reach along a segment, linear between samples.
class ReachProfile {
  public:
    ReachProfile(const SewContour& contour, const AllowanceFit& fit, std::size_t segment)
        : fit_(fit), segment_(contour.segments()[segment]), index_(segment) {
        const double step = segment_.allowance > 0 ? std::max(segment_.allowance / 4, 2 * finest) : coarsest;
        const int parts = fit.is_free(segment) ? 1 : static_cast<int>(std::ceil(segment_.length / step));
        samples_.push_back(sample(0));
        for (int i = 1; i <= parts; ++i) refine(sample(segment_.length * i / parts));
    }

    const std::vector<Sample>& samples() const { return samples_; }
    double first() const { return samples_.front().limit.reach; }
    double last() const { return samples_.back().limit.reach; }

    /// The cut line beside the segment.
    Points2 points() const {
        Points2 line(static_cast<Eigen::Index>(samples_.size()), 2);
        Eigen::Index i = 0;
        for (const auto& [along, limit] : samples_) line.row(i++) = segment_.at(along) + limit.reach * segment_.outward;
        return samples_.size() > 2 ? simplified(line, chord_error) : line;
    }

  private:
    Sample sample(double along) const {
        return {along, fit_.limit({index_, along}, segment_.outward, segment_.allowance)};
    }

    /// Adds the samples between the last one and `end`, then `end`.
    void refine(const Sample& end) {
        const Sample start = samples_.back();
        const bool is_met = start.limit.segment >= 0 || end.limit.segment >= 0;
        if (is_met && end.along - start.along > finest) {
            const Sample middle = sample((start.along + end.along) / 2);
            const double chord = (start.limit.reach + end.limit.reach) / 2;
            if (std::abs(middle.limit.reach - chord) > fit_error) {
                refine(middle);
                refine(end);
                return;
            }
        }
        samples_.push_back(end);
    }

    const AllowanceFit& fit_;
    const SewSegment& segment_;
    std::size_t index_;
    std::vector<Sample> samples_;
};

/// Collects the places where allowances meet, by edge and the edge it meets.
class AllowanceMeetings {
  public:
    explicit AllowanceMeetings(const SewContour& contour) : contour_(contour) {}

    void add(std::size_t segment, const ReachProfile& profile) {
        const std::vector<Sample>& samples = profile.samples();
        const SewSegment& own = contour_.segments()[segment];
        const auto is_met = [&own](const Sample& sample) {
            return sample.limit.segment >= 0 && own.allowance - sample.limit.reach > nothing_missing;
        };
        for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
            if (!is_met(samples[i]) || !is_met(samples[i + 1])) continue;
            const double length = samples[i + 1].along - samples[i].along;
            for (const Sample* sample : {&samples[i], &samples[i + 1]}) add(own, *sample, length / 2);
        }
    }

    /// The meetings of two edges, each pair once. A corner at the end of a longer meeting is merged into it.
    std::vector<MetAllowances> list() const {
        const std::vector<Meeting> all = pairs();
        std::vector<MetAllowances> told;
        for (const auto& [met, lower, upper] : all) {
            const double both = allowance(met.edge) + allowance(met.mate_edge);
            const auto holds = [&, &met = met](const Meeting& other) {
                const Vec2 nearest = met.at.cwiseMax(other.lower).cwiseMin(other.upper);
                return other.met.length > met.length && (nearest - met.at).norm() < 2 * both;
            };
            if (met.length >= both || std::none_of(all.begin(), all.end(), holds)) told.push_back(met);
        }
        return told;
    }

  private:
    struct Meeting {
        MetAllowances met;
        Vec2 lower = Vec2::Constant(std::numeric_limits<double>::infinity()), upper = -lower;  // its bounding box
    };

    double allowance(int edge) const {
        for (const SewSegment& segment : contour_.segments())
            if (segment.edge == edge) return segment.allowance;
        return 0;
    }

    std::vector<Meeting> pairs() const {
        std::vector<Meeting> all;
        for (const auto& [edges, meeting] : met_) {
            const auto mate = met_.find({edges.second, edges.first});
            if (edges.first == edges.second) {
                all.push_back(meeting);
                all.back().met.length /= 2;
            } else if (mate == met_.end()) {
                all.push_back(meeting);
            } else if (edges.first < edges.second) {
                const MetAllowances &met = meeting.met, &other = mate->second.met;
                all.push_back(meeting);
                all.back().met.length = std::max(met.length, other.length);
                all.back().met.left = std::min(met.left, other.left);
            }
        }
        return all;
    }

    void add(const SewSegment& own, const Sample& sample, double length) {
        const SewSegment& other = contour_.segments()[static_cast<std::size_t>(sample.limit.segment)];
        const auto [found, is_new] = met_.try_emplace({own.edge, other.edge});
        MetAllowances& met = found->second.met;
        const Vec2 at = own.at(sample.along);
        found->second.lower = found->second.lower.cwiseMin(at);
        found->second.upper = found->second.upper.cwiseMax(at);
        met.length += length;
        if (is_new || sample.limit.gap < met.gap) {
            met.at = at;
            met.gap = sample.limit.gap;
        }
        met.left = is_new ? sample.limit.reach : std::min(met.left, sample.limit.reach);
        met.edge = own.edge;
        met.mate_edge = other.edge;
    }

    const SewContour& contour_;
    std::map<std::pair<int, int>, Meeting> met_;
};

/// Adds the points between the allowances of two segments. Where the sew line bends inward, the allowances cross,
/// and a detour over the sew line makes the loop between them clockwise.
void add_joint(std::vector<Vec2>& line, const SewContour& contour, const AllowanceFit& fit, std::size_t segment,
               double reach_in, double reach_out) {
    const Vec2 at = contour.segments()[segment].from;
    if (!contour.turns_outward(segment)) {
        line.push_back(at);
        return;
    }
    std::vector<Vec2> points = points_round(contour, segment, reach_in, reach_out);
    if (reach_in < 0 || reach_out < 0) {  // sew lines that touch
        const SewCorner corner = contour.corner(segment, reach_in, reach_out);
        Vec2 tip;
        points.clear();
        if (lines_meet(corner.end_in(), corner.in, corner.end_out(), corner.out, tip)) points.push_back(tip);
    }
    for (const Vec2& point : points) {
        const double wanted = (point - at).norm();
        const Vec2 way = (point - at) / wanted;
        line.push_back(wanted > 0 ? Vec2(at + fit.limit({segment, 0}, way, wanted).reach * way) : at);
    }
}

}  // namespace

CutLine make_cut_line(const std::vector<AllowedEdge>& edges) {
    const SewContour contour(edges);
    const AllowanceFit fit(contour);
    AllowanceMeetings meetings(contour);
    std::vector<ReachProfile> profiles;
    for (std::size_t i = 0; i < contour.segments().size(); ++i) {
        profiles.emplace_back(contour, fit, i);
        meetings.add(i, profiles.back());
    }
    std::vector<Vec2> line;
    for (std::size_t i = 0; i < profiles.size(); ++i) {
        add_joint(line, contour, fit, i, profiles[contour.before(i)].last(), profiles[i].first());
        const Points2 beside = profiles[i].points();
        for (Eigen::Index k = 0; k < beside.rows(); ++k) line.emplace_back(beside.row(k));
    }
    return {outside_of(line), meetings.list()};
}

}  // namespace ripstop
