#include "ripstop/energy/load_tape.h"

#include <algorithm>

namespace ripstop {
namespace {

double tape_strain(double rest, const Vec3& span) {
    return std::max(0.0, 0.5 * (span.squaredNorm() / (rest * rest) - 1));
}

}  // namespace

double tape_energy(double stiffness, double rest, const Vec3& a, const Vec3& b) {
    const double strain = tape_strain(rest, b - a);
    return 0.5 * rest * stiffness * strain * strain;
}

double tape_force(double stiffness, double rest, const Vec3& a, const Vec3& b) {
    return stiffness * tape_strain(rest, b - a) * (b - a).norm() / rest;
}

TapeElement tape_element(double stiffness, double rest, const Vec3& a, const Vec3& b) {
    TapeElement element;
    const Vec3 span = b - a;
    const double strain = tape_strain(rest, span);
    if (strain <= 0) return element;
    element.energy = 0.5 * rest * stiffness * strain * strain;
    const Vec3 pull = stiffness * strain / rest * span;
    element.gradient << -pull, pull;
    const Eigen::Matrix3d block = stiffness / (rest * rest * rest) * span * span.transpose() +
                                  stiffness * strain / rest * Eigen::Matrix3d::Identity();
    element.hessian << block, -block, -block, block;
    return element;
}

}  // namespace ripstop
