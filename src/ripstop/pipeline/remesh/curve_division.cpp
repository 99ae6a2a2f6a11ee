#include "ripstop/pipeline/remesh/curve_division.h"

#include <algorithm>
#include <cmath>

#include "ripstop/base/text/units.h"

namespace ripstop {
namespace {

constexpr double count_rounding =
    1e-2;                            // of a count: equal curves are divided equally wherever they lie, rounded or not
constexpr double longest = 4.0 / 3;  // in edge lengths, as in remeshing
constexpr double sparse_enough = 0.45, shortest = 0.3, densest = 0.35;
constexpr double turn_wanted = 4 * degree;
constexpr double kink_cosine = 0.999;  // cosine between the tangents before and after a vertex: smaller at a corner

int edge_at(const ChainCurve& curve, double at) {
    const int count = curve.edge_count();
    return ((static_cast<int>(std::floor(at)) % count) + count) % count;
}

double turn_between(const ChainCurve& curve, double from, double to) {
    return (to - from) * turn_of_edge(curve, edge_at(curve, from));
}

/// Whether the curve has a corner at this vertex.
bool has_kink(const ChainCurve& curve, double at) {
    const int after = edge_at(curve, at), before = edge_at(curve, at + curve.edge_count() - 1);
    const Vec3 in = Vec3(curve.end_slopes.row(before)).normalized();
    const Vec3 out = Vec3(curve.start_slopes.row(after)).normalized();
    return in.dot(out) < kink_cosine;
}

double arc_between(const ChainCurve& curve, double from, double to) {
    return station_at(curve, to) - station_at(curve, from);
}

}  // namespace

MeasuredCurve make_measured(const ChainCurve& curve, double low, double high, const std::vector<double>& lengths) {
    MeasuredCurve measured{&curve, {low}, {0}};
    for (double v = std::floor(low) + 1; v < high; ++v) measured.breaks.push_back(v);
    measured.breaks.push_back(high);
    for (const double length : lengths) measured.stations.push_back(measured.stations.back() + length);
    return measured;
}

MeasuredCurve make_measured_by_chords(const ChainCurve& curve, double low, double high) {
    MeasuredCurve measured = make_measured(curve, low, high, {});
    for (std::size_t k = 0; k + 1 < measured.breaks.size(); ++k) {
        const double share = measured.breaks[k + 1] - measured.breaks[k];
        measured.stations.push_back(measured.stations.back() +
                                    share * chord_of_edge(curve, edge_at(curve, measured.breaks[k])));
    }
    return measured;
}

MeasuredCurve make_measured_by_arc(const ChainCurve& curve, double low, double high) {
    MeasuredCurve measured = make_measured(curve, low, high, {});
    for (std::size_t k = 1; k < measured.breaks.size(); ++k)
        measured.stations.push_back(arc_between(curve, low, measured.breaks[k]));
    return measured;
}

double MeasuredCurve::station_of(double at) const {
    const auto next = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, at);
    const std::size_t k = static_cast<std::size_t>(next - breaks.begin());
    const double share = arc_between(*curve, breaks[k - 1], at) / arc_between(*curve, breaks[k - 1], breaks[k]);
    return stations[k - 1] + share * (stations[k] - stations[k - 1]);
}

double MeasuredCurve::place_of(double station) const {
    const auto next = std::upper_bound(stations.begin() + 1, stations.end() - 1, station);
    const std::size_t k = static_cast<std::size_t>(next - stations.begin());
    const double near = 1e-9 * length();
    if (station <= stations[k - 1] + near) return breaks[k - 1];
    if (station >= stations[k] - near) return breaks[k];
    double low = breaks[k - 1], high = breaks[k];
    for (int step = 0; step < 60 && high - low > 1e-13; ++step) {
        const double middle = (low + high) / 2;
        (station_of(middle) < station ? low : high) = middle;
    }
    return (low + high) / 2;
}

double turn_an_edge(const MeasuredCurve& measured) {
    double sum = 0;
    for (std::size_t k = 0; k + 1 < measured.breaks.size(); ++k) {
        const double turn = turn_between(*measured.curve, measured.breaks[k], measured.breaks[k + 1]);
        sum += (measured.stations[k + 1] - measured.stations[k]) * turn * turn;
    }
    return std::sqrt(sum / measured.length());
}

bool serves(const MeasuredCurve& measured, double edge_length, double most_turn) {
    for (std::size_t k = 0; k + 1 < measured.breaks.size(); ++k) {
        const double length = measured.stations[k + 1] - measured.stations[k];
        if (length > longest * edge_length || length < shortest * edge_length) return false;
    }
    return measured.length() / static_cast<double>(measured.breaks.size() - 1) >= sparse_enough * edge_length &&
           turn_an_edge(measured) <= most_turn;
}

std::vector<double> divided(const MeasuredCurve& measured, double edge_length) {
    std::vector<double> places{measured.breaks.front()};
    const std::size_t last = measured.breaks.size() - 1;
    for (std::size_t from = 0, to = 1; from < last; from = to++) {
        while (to < last && !has_kink(*measured.curve, measured.breaks[to])) ++to;
        double turn = 0;
        for (std::size_t k = from; k < to; ++k)
            turn += turn_between(*measured.curve, measured.breaks[k], measured.breaks[k + 1]);
        const double start = measured.stations[from], length = measured.stations[to] - start;
        const double by_turn = std::min(turn / turn_wanted, length / (densest * edge_length));
        const int count = static_cast<int>(std::max(
            {1.0, std::ceil(length / edge_length - 0.25 - count_rounding), std::ceil(by_turn - count_rounding)}));
        for (int k = 1; k < count; ++k) places.push_back(measured.place_of(start + length * k / count));
        places.push_back(measured.breaks[to]);
    }
    return places;
}

std::vector<double> refined(const MeasuredCurve& measured, double edge_length) {
    std::vector<double> places;
    for (std::size_t k = 0; k + 1 < measured.breaks.size(); ++k) {
        const double from = measured.stations[k], length = measured.stations[k + 1] - from;
        const int count = length > longest * edge_length ? static_cast<int>(std::ceil(length / edge_length - 0.25)) : 1;
        places.push_back(measured.breaks[k]);
        for (int i = 1; i < count; ++i) places.push_back(measured.place_of(from + length * i / count));
    }
    places.push_back(measured.breaks.back());
    return places;
}

}  // namespace ripstop
