#include "ripstop/energy/tension_field.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// The energy of a uniaxial tension along phi, L = eps^2 / (2 Sc), and its derivatives.
struct Ray {
    Vector3d m, m1;
    double eps, eps1, eps2;  ///< strain along phi and its derivatives with respect to phi
    double Sc, Sc1, Sc2;     ///< compliance along phi and its derivatives

    Ray(const Vector3d& strain, const Matrix3d& compliance, double phi) {
        const double c = std::cos(2 * phi), s = std::sin(2 * phi);
        m << 0.5 * (1 + c), 0.5 * (1 - c), 0.5 * s;
        m1 << -s, s, c;
        const Vector3d m2(-2 * c, 2 * c, -2 * s);
        eps = strain.dot(m);
        eps1 = strain.dot(m1);
        eps2 = strain.dot(m2);
        const Vector3d Cm = compliance * m, Cm1 = compliance * m1;
        Sc = m.dot(Cm);
        Sc1 = 2 * m1.dot(Cm);
        Sc2 = 2 * (m1.dot(Cm1) + m2.dot(Cm));
    }

    double energy() const { return eps > 0 ? 0.5 * eps * eps / Sc : 0; }
    double slope() const { return eps * (eps1 - 0.5 * eps * Sc1 / Sc) / Sc; }
    double curvature() const {
        return (eps1 * eps1 + eps * eps2) / Sc - 2 * eps * eps1 * Sc1 / (Sc * Sc) -
               0.5 * eps * eps * (Sc2 / (Sc * Sc) - 2 * Sc1 * Sc1 / (Sc * Sc * Sc));
    }
};

bool is_positive(double xx, double yy, double xy) {
    return xx + yy >= 0 && xx * yy >= xy * xy;
}

}  // namespace

TensionField::TensionField(const Fabric& fabric, double residual) : residual_(residual) {
    stiffness_ << fabric.c11(), fabric.c12(), 0, fabric.c12(), fabric.c22(), 0, 0, 0, fabric.shear_stiffness;
    compliance_ = stiffness_.inverse();
}

ClothResponse TensionField::at(const Vector3d& strain) const {
    ClothResponse response = relaxed(strain);
    if (residual_ > 0) {
        const Vector3d stress = stiffness_ * strain;
        response.energy += 0.5 * residual_ * strain.dot(stress);
        response.stress += residual_ * stress;
        response.tangent += residual_ * stiffness_;
    }
    return response;
}

ClothResponse TensionField::relaxed(const Vector3d& strain) const {
    const Vector3d stress = stiffness_ * strain;
    if (is_positive(stress[0], stress[1], stress[2]))
        return {ClothState::taut, 0.5 * strain.dot(stress), stress, stress, stiffness_, 0};
    if (is_positive(-strain[0], -strain[1], 0.5 * strain[2])) return {};
    return wrinkled(strain);
}

ClothResponse TensionField::wrinkled(const Vector3d& strain) const {
    const double mean = 0.5 * (strain[0] + strain[1]), radius = 0.5 * std::hypot(strain[0] - strain[1], strain[2]);
    const double centre = 0.5 * std::atan2(strain[2], strain[0] - strain[1]);
    // The sector of stretched directions can be a hundredth of a degree wide, so the samples are taken inside it.
    const double half = 0.5 * std::acos(std::clamp(-mean / radius, -1.0, 1.0));
    constexpr int samples = 25;
    const double spacing = 2 * half / (samples + 1);
    double best = centre, most = -1;
    for (int k = 1; k <= samples; ++k) {
        const double phi = centre - half + k * spacing;
        if (const double energy = Ray(strain, compliance_, phi).energy(); energy > most) {
            most = energy;
            best = phi;
        }
    }
    double low = best - spacing, high = best + spacing, phi = best;
    for (int k = 0; k < 60; ++k) {
        const Ray ray(strain, compliance_, phi);
        const double slope = ray.slope();
        (slope > 0 ? low : high) = phi;
        const double curvature = ray.curvature();
        double next = curvature < 0 ? phi - slope / curvature : low;
        if (!(next > low && next < high)) next = 0.5 * (low + high);
        const bool done = std::abs(next - phi) <= 1e-15 * std::numbers::pi || high - low <= 1e-15;
        phi = next;
        if (done) break;
    }
    const Ray ray(strain, compliance_, phi);
    if (!(ray.eps > 0)) return {};
    ClothResponse response{ClothState::wrinkled,
                           ray.energy(),
                           ray.eps / ray.Sc * ray.m,
                           ray.eps / ray.Sc * ray.m,
                           ray.m * ray.m.transpose() / ray.Sc,
                           phi};
    // The change of the tension's direction with the strain; skipped if the energy is constant in phi to rounding.
    const Vector3d l = (ray.eps1 * ray.m + ray.eps * ray.m1) / ray.Sc - ray.eps * ray.Sc1 / (ray.Sc * ray.Sc) * ray.m;
    if (const double curvature = ray.curvature(); curvature < 0) response.tangent -= l * l.transpose() / curvature;
    return response;
}

}  // namespace ripstop
