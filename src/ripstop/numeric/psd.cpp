#include "ripstop/numeric/psd.h"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace ripstop {
namespace {

/// Whether LDLᵀ of matrix + shift·I meets only positive pivots. Unrolled by hand: it runs once a triangle.
bool is_definite(const Eigen::Matrix4d& m, double shift) {
    const double d0 = m(0, 0) + shift;
    if (!(d0 > 0)) return false;
    const double l10 = m(1, 0) / d0, l20 = m(2, 0) / d0, l30 = m(3, 0) / d0;
    const double d1 = m(1, 1) + shift - l10 * m(1, 0);
    if (!(d1 > 0)) return false;
    const double u21 = m(2, 1) - l20 * m(1, 0), u31 = m(3, 1) - l30 * m(1, 0);
    const double l21 = u21 / d1, l31 = u31 / d1;
    const double d2 = m(2, 2) + shift - l20 * m(2, 0) - l21 * u21;
    if (!(d2 > 0)) return false;
    const double u32 = m(3, 2) - l30 * m(2, 0) - l31 * u21;
    const double d3 = m(3, 3) + shift - l30 * m(3, 0) - l31 * u31 - u32 * u32 / d2;
    return d3 > 0;
}

}  // namespace

Eigen::Matrix4d positive_semidefinite(const Eigen::Matrix4d& matrix) {
    if (is_definite(matrix, 1e-14 * matrix.diagonal().cwiseAbs().sum())) return matrix;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> eigen(matrix);
    const Eigen::Matrix4d result =
        eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).asDiagonal() * eigen.eigenvectors().transpose();
    return 0.5 * (result + result.transpose());
}

}  // namespace ripstop
