#include "ripstop/numeric/psd.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <optional>

namespace ripstop {
namespace {

using Eigen::Matrix4d;
using Eigen::Vector4d;

/// The number of negative eigenvalues of a matrix (equal to the negative pivots of its LDLᵀ); if there is exactly
/// one, also a direction of negative curvature.
struct Signs {
    int negative = 0;
    bool certain = true;  ///< false if a pivot is zero
    Vector4d downhill = Vector4d::Zero();
};

Signs signs(const Matrix4d& m, double shift) {
    const double d0 = m(0, 0) + shift;
    const double l10 = m(1, 0) / d0, l20 = m(2, 0) / d0, l30 = m(3, 0) / d0;
    const double d1 = m(1, 1) + shift - l10 * m(1, 0);
    const double u21 = m(2, 1) - l20 * m(1, 0), u31 = m(3, 1) - l30 * m(1, 0);
    const double l21 = u21 / d1, l31 = u31 / d1;
    const double d2 = m(2, 2) + shift - l20 * m(2, 0) - l21 * u21;
    const double u32 = m(3, 2) - l30 * m(2, 0) - l31 * u21;
    const double l32 = u32 / d2;
    const double d3 = m(3, 3) + shift - l30 * m(3, 0) - l31 * u31 - l32 * u32;
    Signs result;
    result.certain = d0 != 0 && d1 != 0 && d2 != 0 && std::isfinite(d3);
    result.negative = (d0 < 0) + (d1 < 0) + (d2 < 0) + !(d3 > 0);
    // Lᵀ v is the unit vector of the negative pivot, so v · m v is this pivot.
    Vector4d& v = result.downhill;
    v[3] = !(d3 > 0);
    v[2] = (d2 < 0) - l32 * v[3];
    v[1] = (d1 < 0) - l21 * v[2] - l31 * v[3];
    v[0] = (d0 < 0) - l10 * v[1] - l20 * v[2] - l30 * v[3];
    return result;
}

/// The adjugate of a symmetric matrix given by its lower triangle: its inverse times its determinant. Unlike the
/// inverse it is defined and accurate for a singular matrix, which is where the Rayleigh quotient iteration needs it.
Matrix4d adjugate(const Matrix4d& m) {
    const double a = m(0, 0), b = m(1, 0), c = m(2, 0), d = m(3, 0);
    const double e = m(1, 1), f = m(2, 1), g = m(3, 1), h = m(2, 2), i = m(3, 2), j = m(3, 3);
    const double hj = h * j - i * i, fj = f * j - g * i, fi = f * i - g * h;
    const double cj = c * j - d * i, ci = c * i - d * h, cg = c * g - d * f;
    const double af = a * f - b * c, ag = a * g - b * d, bf = b * f - c * e, bg = b * g - d * e;
    const double ae = a * e - b * b;
    Matrix4d x;
    x(0, 0) = e * hj - f * fj + g * fi;
    x(1, 0) = -(b * hj - f * cj + g * ci);
    x(2, 0) = b * fj - e * cj + g * cg;
    x(3, 0) = -(b * fi - e * ci + f * cg);
    x(1, 1) = a * hj - c * cj + d * ci;
    x(2, 1) = -(a * fj - b * cj + d * cg);
    x(3, 1) = a * fi - b * ci + c * cg;
    x(2, 2) = j * ae - g * ag + d * bg;
    x(3, 2) = -(i * ae - g * af + d * bf);
    x(3, 3) = h * ae - f * af + c * bf;
    x(0, 1) = x(1, 0), x(0, 2) = x(2, 0), x(0, 3) = x(3, 0);
    x(1, 2) = x(2, 1), x(1, 3) = x(3, 1), x(2, 3) = x(3, 2);
    return x;
}

/// Removes the only negative eigenvalue of a matrix by Rayleigh quotient iteration, which triples the digits per
/// step. Empty if it does not converge to a negative eigenvalue; one that it finds must be the only one.
std::optional<Matrix4d> without_negative(const Matrix4d& m, Vector4d v, double size) {
    for (int iteration = 0; iteration < 8; ++iteration) {
        v /= v.norm();
        const Vector4d image = m * v;
        const double value = v.dot(image);
        if ((image - value * v).squaredNorm() <= 1e-25 * size * size) {
            if (!(value < 0)) return std::nullopt;
            return m - (value * v) * v.transpose();
        }
        Matrix4d shifted = m;
        shifted.diagonal().array() -= value;
        v = adjugate(shifted) * v;
    }
    return std::nullopt;
}

}  // namespace

Matrix4d positive_semidefinite(const Matrix4d& matrix) {
    const double size = matrix.diagonal().cwiseAbs().sum();
    const Signs sign = signs(matrix, 1e-14 * size);
    if (sign.certain && sign.negative == 0) return matrix;
    const Matrix4d full = matrix.selfadjointView<Eigen::Lower>();
    if (sign.certain && sign.negative == 1)
        if (const std::optional<Matrix4d> result = without_negative(full, sign.downhill, size)) return *result;
    const Eigen::SelfAdjointEigenSolver<Matrix4d> eigen(full);
    const Matrix4d half = eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal();
    return half * half.transpose();
}

}  // namespace ripstop
