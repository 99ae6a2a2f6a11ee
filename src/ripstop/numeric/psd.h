#pragma once

#include <Eigen/Core>

namespace ripstop {

/// The nearest positive semi-definite matrix in the Frobenius norm: negative eigenvalues become zero. A matrix that
/// is positive semi-definite to rounding (1e-14 of its trace) is returned unchanged, byte for byte. Reads the lower
/// triangle.
Eigen::Matrix4d positive_semidefinite(const Eigen::Matrix4d& matrix);

}  // namespace ripstop
