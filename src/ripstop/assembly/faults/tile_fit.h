#pragma once

#include <vector>

#include "ripstop/assembly/seams/chain_curve.h"

namespace ripstop {

/// The map x -> scale * turn * x + shift.
struct Similarity {
    double scale = 1;
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    Vec3 shift = Vec3::Zero();

    Vec3 operator()(const Vec3& point) const { return scale * (turn * point) + shift; }
};

/// A similarity that moves points onto curves, and the quality of the fit.
struct TileFit {
    Similarity move;
    double residual = 0;  ///< largest remaining distance [m]
};

/// An edge of a chain, as the target of a fit.
struct TargetEdge {
    const ChainCurve* curve;
    int edge;
};

/// The similarity that moves points onto edges, by iterated closest points [BM92] with scale after [U91], from
/// `start`. Without `with_scale`, a rigid motion. O(#points x #edges) per step, at most 60 steps.
TileFit fit_to_edges(const Points3& points, const std::vector<TargetEdge>& edges, const Similarity& start,
                     bool with_scale);

/// The similarity, without rotation, that maps the centre and size of one closed polygon to those of another. Both
/// come from the outlines, so the spacing of the points does not matter.
Similarity match_outlines(const Points3& from, const Points3& to);

}  // namespace ripstop
