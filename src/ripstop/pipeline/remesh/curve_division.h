#pragma once

#include <vector>

#include "ripstop/assembly/seams/chain_curve.h"

namespace ripstop {

/// A stretch of a chain's curve with the length it is drawn at: at its breaks, ascending, how far it is from the start.
/// Between two of them length goes with arc length.
struct MeasuredCurve {
    const ChainCurve* curve = nullptr;
    std::vector<double> breaks;    ///< places on the curve: its ends and the vertices between
    std::vector<double> stations;  ///< at each [m]

    double length() const { return stations.back(); }
    double station_of(double at) const;
    double place_of(double station) const;
};

/// `lengths`: from break to break.
MeasuredCurve make_measured(const ChainCurve& curve, double low, double high, const std::vector<double>& lengths);
/// The same drawn at its chords, and at its arc length.
MeasuredCurve make_measured_by_chords(const ChainCurve& curve, double low, double high);
MeasuredCurve make_measured_by_arc(const ChainCurve& curve, double low, double high);

/// By how much the polyline turns an edge: root mean square over the length [rad].
double turn_an_edge(const MeasuredCurve& measured);

/// Do its vertices serve edges of about `edge_length`? None longer than 4/3 of it, on average no shorter than 0.45 of
/// it and none below 0.3, and turning by no more than `most_turn` an edge.
bool serves(const MeasuredCurve& measured, double edge_length, double most_turn);

/// Even division by length: edges of about `edge_length`, turning by at most 4 degrees each unless they were shorter
/// than 0.35 of it. Vertices where the curve has a corner (`corner_turn`) are kept, and each stretch between is divided
/// by itself.
std::vector<double> divided(const MeasuredCurve& measured, double edge_length);

/// Its own breaks, with others where two are farther apart than 4/3 of the edge length.
std::vector<double> refined(const MeasuredCurve& measured, double edge_length);

}  // namespace ripstop
