#include "ripstop/energy/symmetric_dirichlet.h"

#include <Eigen/LU>
#include <limits>

#include "ripstop/geometry/triangle.h"
#include "ripstop/numeric/psd.h"

namespace ripstop {
namespace {

using Eigen::Matrix4d;
using Eigen::Vector4d;

constexpr double infinite = std::numeric_limits<double>::infinity();

/// |J|^2 + |J^-1|^2 - 4, computed as |J - J^-T|^2, which is the sum of (s - 1/s)^2 over the singular values s. The
/// first form would lose half the digits near rest.
double density(const Mat22& J, const Mat22& cofactor, double det) {
    return (J - cofactor / det).squaredNorm();
}

Mat22 cofactor_of(const Mat22& J) {
    Mat22 c;
    c << J(1, 1), -J(1, 0), -J(0, 1), J(0, 0);
    return c;
}

}  // namespace

double symmetric_dirichlet_energy(const Mat22& rest, const Mat22& flat) {
    if (!(flat.determinant() > 0)) return infinite;
    const Mat22 J = flat * rest.inverse();
    return 0.5 * rest.determinant() * density(J, cofactor_of(J), J.determinant());
}

MembraneElement symmetric_dirichlet(const Mat22& rest, const Mat22& flat, Curvature curvature) {
    MembraneElement result;
    if (!(flat.determinant() > 0)) {
        result.energy = infinite;
        return result;
    }
    const double area = 0.5 * rest.determinant();
    const Mat22 J = flat * rest.inverse();
    const Mat22 C = cofactor_of(J);
    const double s = J.squaredNorm();
    const double r = 1 / J.determinant();
    result.energy = area * density(J, C, J.determinant());

    // J and its cofactor matrix as (11, 21, 12, 22), their order in memory
    const Vector4d j = J.reshaped(), c = C.reshaped();
    const Vector4d slope = 2 * (1 + r * r) * j - 2 * s * r * r * r * c;
    Matrix4d bend = 2 * (1 + r * r) * Matrix4d::Identity() - 4 * r * r * r * (j * c.transpose() + c * j.transpose()) +
                    6 * s * r * r * r * r * c * c.transpose();
    const double twist = -2 * s * r * r * r;
    bend(0, 3) += twist;
    bend(3, 0) += twist;
    bend(1, 2) -= twist;
    bend(2, 1) -= twist;
    if (curvature == Curvature::semidefinite) bend = positive_semidefinite(bend);

    const Eigen::Matrix<double, 2, 3> N = corner_gradients(rest);
    Eigen::Matrix<double, 4, 6> map = Eigen::Matrix<double, 4, 6>::Zero();  // J = sum_k u_k N_k^T
    for (int k = 0; k < 3; ++k)
        for (int b = 0; b < 2; ++b) map.block<2, 2>(2 * b, 2 * k) = N(b, k) * Mat22::Identity();
    result.gradient = area * map.transpose() * slope;
    result.hessian = area * map.transpose() * bend * map;
    return result;
}

}  // namespace ripstop
