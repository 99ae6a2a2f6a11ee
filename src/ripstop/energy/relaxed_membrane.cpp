#include "ripstop/energy/relaxed_membrane.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

namespace ripstop {

RelaxedMembrane::RelaxedMembrane(const Mat22& flat) : area_(0.5 * flat.determinant()) {
    const Mat22 inverse = flat.inverse();
    shape_.row(1) = inverse.row(0);
    shape_.row(2) = inverse.row(1);
    shape_.row(0) = -(inverse.row(0) + inverse.row(1));
}

Mat32 RelaxedMembrane::deformation(const Vec3& a, const Vec3& b, const Vec3& c) const {
    return (b - a) * shape_.row(1) + (c - a) * shape_.row(2);
}

Vec3 green_voigt(const Mat32& F) {
    return {0.5 * (F.col(0).squaredNorm() - 1), 0.5 * (F.col(1).squaredNorm() - 1), F.col(0).dot(F.col(1))};
}

double RelaxedMembrane::energy(const TensionField& cloth, const Vec3& a, const Vec3& b, const Vec3& c) const {
    return area_ * cloth.at(green_voigt(deformation(a, b, c))).energy;
}

SpaceElement RelaxedMembrane::element(const TensionField& cloth, const Vec3& a, const Vec3& b, const Vec3& c) const {
    const Mat32 F = deformation(a, b, c);
    const Vec3 strain = green_voigt(F);
    const ClothResponse response = cloth.at(strain);
    const Vec3& pull = response.tension;
    Eigen::Matrix<double, 3, 9> B;
    for (int v = 0; v < 3; ++v) {
        const double n1 = shape_(v, 0), n2 = shape_(v, 1);
        B.block<1, 3>(0, 3 * v) = n1 * F.col(0).transpose();
        B.block<1, 3>(1, 3 * v) = n2 * F.col(1).transpose();
        B.block<1, 3>(2, 3 * v) = n1 * F.col(1).transpose() + n2 * F.col(0).transpose();
    }
    SpaceElement element;
    element.energy = area_ * response.energy;
    element.gradient = area_ * (B.transpose() * response.stress);
    element.hessian = area_ * (B.transpose() * response.tangent * B);
    Mat22 S;
    S << pull[0], pull[2], pull[2], pull[1];
    const Eigen::Matrix3d geometric = area_ * (shape_ * S * shape_.transpose());
    for (int v = 0; v < 3; ++v)
        for (int w = 0; w < 3; ++w) element.hessian.block<3, 3>(3 * v, 3 * w).diagonal().array() += geometric(v, w);
    return element;
}

Vec2 principal_tensions(const Mat32& F, const Vec3& stress) {
    Mat22 S;
    S << stress[0], stress[2], stress[2], stress[1];
    const double J = F.col(0).cross(F.col(1)).norm();
    if (!(J > 0)) return Vec2::Zero();
    // F S F^T has the eigenvalues of S F^T F and zero.
    const Mat22 N = S * (F.transpose() * F) / J;
    const double mean = 0.5 * N.trace();
    const double radius = std::sqrt(std::max(0.0, mean * mean - N.determinant()));
    return {mean + radius, mean - radius};
}

}  // namespace ripstop
