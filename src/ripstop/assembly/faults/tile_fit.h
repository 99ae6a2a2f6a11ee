#pragma once

#include <vector>

#include "ripstop/assembly/seams/chain_curve.h"

namespace ripstop {

/// x -> scale * turn * x + shift.
struct Similarity {
    double scale = 1;
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    Vec3 shift = Vec3::Zero();

    Vec3 operator()(const Vec3& point) const { return scale * (turn * point) + shift; }
};

/// How a set of points is to be moved onto curves, and how well it lies there then.
struct TileFit {
    Similarity move;
    double residual = 0;  ///< largest distance left [m]
};

/// An edge of a chain, to lie on.
struct TargetEdge {
    const ChainCurve* curve;
    int edge;
};

/// The similarity that lays points onto edges, by the nearest points in turn [BM92], with scale after [U91], from
/// `start`. `with_scale` false: a motion alone. O(#points x #edges) a step, at most 60 steps.
TileFit fit_to_edges(const Points3& points, const std::vector<TargetEdge>& edges, const Similarity& start,
                     bool with_scale);

/// The similarity without turn that brings one closed polygon's centre and size to another's: centres and spreads of
/// the outlines themselves, however their points are spaced.
Similarity match_outlines(const Points3& from, const Points3& to);

}  // namespace ripstop
