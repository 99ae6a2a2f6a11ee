#pragma once

#include <vector>

#include "ripstop/assembly/seams/chain_curve.h"

namespace ripstop {

/// A part of a chain's curve with its drawn length: the distance of each break, ascending, from the start. Between two
/// breaks, length is proportional to arc length.
struct MeasuredCurve {
    const ChainCurve* curve = nullptr;
    std::vector<double> breaks;    ///< positions on the curve: its ends and the vertices between
    std::vector<double> stations;  ///< distance from the start at each break [m]

    double length() const { return stations.back(); }
    double station_of(double at) const;
    double place_of(double station) const;
};

/// `lengths`: between consecutive breaks.
MeasuredCurve make_measured(const ChainCurve& curve, double low, double high, const std::vector<double>& lengths);
/// The same with the lengths of the chords, or with the arc length.
MeasuredCurve make_measured_by_chords(const ChainCurve& curve, double low, double high);
MeasuredCurve make_measured_by_arc(const ChainCurve& curve, double low, double high);

/// The turn of the polyline per edge: root mean square over the length [rad].
double turn_an_edge(const MeasuredCurve& measured);

/// Whether its vertices suit edges of about `edge_length`: no edge is longer than 4/3 of it or shorter than 0.3 of it,
/// the mean is at least 0.45 of it, and no edge turns by more than `most_turn`.
bool serves(const MeasuredCurve& measured, double edge_length, double most_turn);

/// Divides the curve evenly into edges of about `edge_length`. Each turns by at most 4 degrees, unless it would be
/// shorter than 0.35 of that length. Vertices at corners of the curve (`corner_turn`) are kept, and each part between
/// them is divided separately.
std::vector<double> divided(const MeasuredCurve& measured, double edge_length);

/// Its own breaks, with additional ones where two are farther apart than 4/3 of the edge length.
std::vector<double> refined(const MeasuredCurve& measured, double edge_length);

}  // namespace ripstop
