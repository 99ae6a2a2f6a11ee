#include "ripstop/assembly/faults/judge_unit.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "ripstop/base/text/number_text.h"

namespace ripstop {
namespace {

constexpr double largest_size = 100, smallest_size = 0.1;  // [m] sizes beyond these are wrong
constexpr double balloon_low = 5, balloon_high = 60;       // [m]
constexpr double model_low = 0.5;                          // [m] of sewn things other than balloons
constexpr double rounding = 1e-9;                          // relative rounding of a conversion factor
constexpr double two_allowances = 0.05;                    // [m] two allowances of an inch each

/// Rounds to 0.1 m; below one metre, to 0.1 mm.
std::string size_text(double length) {
    const double digits = length < 1 ? 1e4 : 10;
    return length < 1e4 ? format_shortest(std::round(length * digits) / digits) : format_fixed(length, 0);
}

struct Extent {
    double size = 0;    ///< of the common bounding box [m]
    double robust = 0;  ///< without the outermost 2 % of the tiles at either end [m]
    double tile = 0;    ///< median diagonal of a tile [m]
};

Extent extent_of(const std::vector<Eigen::AlignedBox3d>& surfaces) {
    const std::size_t count = surfaces.size(), cut = count / 50;
    Eigen::AlignedBox3d whole;
    std::vector<double> diagonals;
    for (const Eigen::AlignedBox3d& box : surfaces) {
        whole.extend(box);
        diagonals.push_back(box.diagonal().norm());
    }
    std::sort(diagonals.begin(), diagonals.end());
    Extent extent{whole.sizes().maxCoeff(), 0, diagonals[count / 2]};
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> low, high;
        for (const Eigen::AlignedBox3d& box : surfaces) {
            low.push_back(box.min()[axis]);
            high.push_back(box.max()[axis]);
        }
        std::sort(low.begin(), low.end());
        std::sort(high.begin(), high.end());
        extent.robust = std::max(extent.robust, high[count - 1 - cut] - low[cut]);
    }
    return extent;
}

struct Candidate {
    std::string unit;
    double factor;  ///< factor on the size as read
};

/// The ratio, at least 1, by which a size misses the range of balloons.
double off_balloon(double size) {
    return std::max({1.0, balloon_low / size, size / balloon_high});
}

/// Other units that give a balloon or a model, the likeliest first. With `any`, feet and inches are as likely as
/// metric units.
std::vector<Candidate> fitting_units(double extent, double metres, bool any) {
    std::vector<Candidate> metric, others;
    for (const char* unit : {"mm", "cm", "m", "ft", "in"}) {
        const double factor = metres_per_unit(unit) / metres;
        if (std::abs(factor - 1) < 1e-9 || extent * factor < model_low || extent * factor > largest_size) continue;
        (any || std::string_view(unit).ends_with("m") ? metric : others).push_back({unit, factor});
    }
    const auto nearer = [&](const Candidate& p, const Candidate& q) {
        return off_balloon(extent * p.factor) < off_balloon(extent * q.factor);
    };
    std::stable_sort(metric.begin(), metric.end(), nearer);
    std::stable_sort(others.begin(), others.end(), nearer);
    metric.insert(metric.end(), others.begin(), others.end());
    return metric;
}

bool any_balloon(const std::vector<Candidate>& units, double extent) {
    return std::any_of(units.begin(), units.end(),
                       [&](const Candidate& unit) { return off_balloon(extent * unit.factor) == 1; });
}

/// `with --unit cm it would measure 3.00 m, with in 7.62 m`.
std::string units_text(const std::vector<Candidate>& units, const Extent& extent) {
    std::string text;
    for (const Candidate& unit : units) {
        if (!text.empty() && off_balloon(extent.robust * unit.factor) > 1) continue;
        text += (text.empty() ? "with --unit " + unit.unit + " it would measure " : ", with " + unit.unit + " ") +
                format_fixed(extent.size * unit.factor, 2) + " m";
    }
    return text.empty() ? "check the unit" : text;
}

}  // namespace

std::optional<UnitDoubt> doubt_unit(const std::vector<Eigen::AlignedBox3d>& surfaces, const UnitRead& read) {
    if (surfaces.empty() || read.size_is_meant) return std::nullopt;
    const Extent extent = extent_of(surfaces);
    const bool is_large = extent.robust > largest_size, is_high = extent.robust > balloon_high * (1 + rounding);
    const std::vector<Candidate> units = fitting_units(extent.robust, read.unit.metres, is_high && !is_large);
    const bool is_small = extent.robust < smallest_size && !units.empty();
    const std::string what = "the envelope measures " + size_text(extent.size) + " m" +
                             (read.is_files ? " in the file's own unit, " + read.unit.name : std::string()) + ", ";
    const std::string then = units_text(units, extent) + "; give --size-is-meant if this size is right";
    if (is_large || is_small)
        return UnitDoubt{what + "a hot-air balloon is 5 to 60 m tall; " + then, extent.size,
                         is_large ? largest_size : smallest_size, true};
    if (!any_balloon(units, extent.robust)) return std::nullopt;
    if (is_high)
        return UnitDoubt{what + "a hot-air balloon is 5 to 60 m tall; " + then, extent.size, balloon_high, false};
    if (surfaces.size() > 1 && extent.tile < two_allowances)
        return UnitDoubt{what + "and half of its tiles are below " + format_fixed(two_allowances / millimetre, 0) +
                             " mm, twice a seam allowance of an inch; " + then,
                         extent.size, two_allowances, false};
    return std::nullopt;
}

}  // namespace ripstop
