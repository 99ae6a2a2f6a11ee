#include "ripstop/energy/woven_membrane.h"

#include <limits>

#include "ripstop/geometry/triangle.h"
#include "ripstop/numeric/psd.h"

namespace ripstop {
namespace {

using Eigen::Matrix4d;
using Eigen::Vector4d;

constexpr double unbounded = std::numeric_limits<double>::infinity();

Mat22 symmetric(const Mat22& lower) {
    Mat22 full = lower;
    full(0, 1) = full(1, 0);
    return full;
}

}  // namespace

/// The terms of the energy and its derivatives, in the letters of the header; R = D⁻¹.
struct WovenMembrane::State {
    Mat22 R;
    double area;
    double C11, C12, C22;
    double S11, S12, S22;
    double W;
};

WovenMembrane::WovenMembrane(const Fabric& fabric)
    : c11_(fabric.c11()), c12_(fabric.c12()), c22_(fabric.c22()), g_(fabric.shear_stiffness) {}

WovenMembrane::State WovenMembrane::state(const TriangleMetric& G, const Mat22& D, double det) const {
    State s;
    s.R << D(1, 1) / det, -D(0, 1) / det, -D(1, 0) / det, D(0, 0) / det;
    s.area = 0.5 * det;
    const double r11 = s.R(0, 0), r12 = s.R(0, 1), r21 = s.R(1, 0), r22 = s.R(1, 1);
    const double a1 = G.aa * r11 + G.ab * r21, b1 = G.ab * r11 + G.bb * r21;  // first column of G R
    const double a2 = G.aa * r12 + G.ab * r22, b2 = G.ab * r12 + G.bb * r22;  // second column
    s.C11 = r11 * a1 + r21 * b1;
    s.C12 = r11 * a2 + r21 * b2;
    s.C22 = r12 * a2 + r22 * b2;
    const double E11 = 0.5 * (s.C11 - 1), E22 = 0.5 * (s.C22 - 1);
    s.S11 = c11_ * E11 + c12_ * E22;
    s.S22 = c12_ * E11 + c22_ * E22;
    s.S12 = g_ * s.C12;
    s.W = 0.5 * (s.S11 * E11 + s.S22 * E22 + s.S12 * s.C12);
    return s;
}

/// The second derivative per area as a quadratic form in h = (H11, H12, H21, H22). Only its lower triangle is used.
Eigen::Matrix4d WovenMembrane::form_in_H(const State& s) const {
    // dE11 = -m1·h, dE22 = -m2·h, 2 dE12 = -m3·h
    const Vector4d m1(s.C11, 0, s.C12, 0);
    const Vector4d m2(0, s.C12, 0, s.C22);
    const Vector4d m3(s.C12, s.C11, s.C22, s.C12);
    Matrix4d K = (c11_ * m1 + c12_ * m2) * m1.transpose();
    K += (c12_ * m1 + c22_ * m2) * m2.transpose();
    K += (g_ * m3) * m3.transpose();

    Mat22 S;
    S << s.S11, s.S12, s.S12, s.S22;
    K.topLeftCorner<2, 2>() += s.C11 * S;
    K.bottomLeftCorner<2, 2>() += s.C12 * S;
    K.bottomRightCorner<2, 2>() += s.C22 * S;

    const double pressure = s.W - (s.C11 * s.S11 + 2 * s.C12 * s.S12 + s.C22 * s.S22);
    K(3, 0) += pressure;
    K(2, 1) -= pressure;
    return K;
}

double WovenMembrane::energy(const TriangleMetric& metric, const Mat22& flat) const {
    const double det = flat(0, 0) * flat(1, 1) - flat(0, 1) * flat(1, 0);
    if (!(det > 0)) return unbounded;
    const State s = state(metric, flat, det);
    return s.area * s.W;
}

MembraneElement WovenMembrane::element(const TriangleMetric& metric, const Mat22& flat, Curvature curvature) const {
    MembraneElement result;
    const double det = flat(0, 0) * flat(1, 1) - flat(0, 1) * flat(1, 0);
    if (!(det > 0)) {
        result.energy = unbounded;
        return result;
    }
    const State s = state(metric, flat, det);
    result.energy = s.area * s.W;

    Mat22 M;                                                                       // W I - C S
    M << s.W - (s.C11 * s.S11 + s.C12 * s.S12), -(s.C11 * s.S12 + s.C12 * s.S22),  //
        -(s.C12 * s.S11 + s.C22 * s.S12), s.W - (s.C12 * s.S12 + s.C22 * s.S22);
    const Mat22 edges = s.area * M * s.R.transpose();  // rows: axes, columns: edges
    result.gradient.segment<2>(2) = edges.col(0);
    result.gradient.segment<2>(4) = edges.col(1);
    result.gradient.segment<2>(0) = -(edges.col(0) + edges.col(1));

    Matrix4d K = form_in_H(s);
    if (curvature == Curvature::semidefinite) K = positive_semidefinite(K);
    // For each pair of axes (a, c): the 2 x 2 block over the edges. H = dD R.
    const Mat22 scaled = s.area * s.R;
    const Mat22 xx = scaled * symmetric(K.topLeftCorner<2, 2>()) * s.R.transpose();
    const Mat22 yx = scaled * K.bottomLeftCorner<2, 2>() * s.R.transpose();
    const Mat22 yy = scaled * symmetric(K.bottomRightCorner<2, 2>()) * s.R.transpose();
    auto& hessian = result.hessian;
    for (int e = 0; e < 2; ++e)
        for (int f = 0; f < 2; ++f) {
            Mat22 block;
            block << xx(e, f), yx(f, e), yx(e, f), yy(e, f);
            hessian.block<2, 2>(2 + 2 * e, 2 + 2 * f) = block;
        }
    hessian.block<4, 2>(2, 0) = -(hessian.block<4, 2>(2, 2) + hessian.block<4, 2>(2, 4));
    hessian.block<2, 4>(0, 2) = hessian.block<4, 2>(2, 0).transpose();
    hessian.block<2, 2>(0, 0) = -(hessian.block<2, 2>(2, 0) + hessian.block<2, 2>(4, 0));
    return result;
}

double membrane_energy(const std::vector<Mat22>& targets, const Triangles& triangles, const Points2& positions,
                       const Fabric& fabric) {
    const WovenMembrane membrane(fabric);
    double sum = 0;
    for (std::size_t t = 0; t < targets.size(); ++t)
        sum += membrane.energy(triangle_metric(targets[t]), flat_edges(triangles, positions, static_cast<int>(t)));
    return sum;
}

double membrane_energy(const TriangleMesh& surface, const Points2& positions, const Fabric& fabric) {
    std::vector<Mat22> targets;
    for (int t = 0; t < surface.triangle_count(); ++t)
        targets.push_back(lay_flat(surface.corner(t, 0), surface.corner(t, 1), surface.corner(t, 2)));
    return membrane_energy(targets, surface.triangles, positions, fabric);
}

}  // namespace ripstop
