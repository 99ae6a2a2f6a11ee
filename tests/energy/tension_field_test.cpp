#include "ripstop/energy/tension_field.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include "ripstop/base/text/units.h"
#include "support/finite_difference.h"
#include "support/membranes.h"

namespace ripstop {
namespace tension_field_test {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d stiffness(const Fabric& fabric) {
    Matrix3d C;
    C << fabric.c11(), fabric.c12(), 0, fabric.c12(), fabric.c22(), 0, 0, 0, fabric.shear_stiffness;
    return C;
}

/// A unit tension along `phi`, or a fold across it, as (xx, yy, xy). The third entry of a strain is twice that.
Vector3d ray(double phi) {
    const double c = std::cos(phi), s = std::sin(phi);
    return {c * c, s * s, s * c};
}

/// psi after the best fold, by t >= 0, across `phi`.
double folded_energy(const Matrix3d& C, const Vector3d& e, double phi) {
    Vector3d fold = ray(phi);
    fold[2] *= 2;
    const Vector3d folded = e + std::max(0.0, -e.dot(C * fold) / fold.dot(C * fold)) * fold;
    return 0.5 * folded.dot(C * folded);
}

/// min over D >= 0 of psi(e + D), by trial: all slack, no fold, and a fold across each of 2,000 directions, with
/// the best of them refined.
double brute_force(const Matrix3d& C, const Vector3d& e) {
    Eigen::Matrix2d strain;
    strain << e[0], 0.5 * e[2], 0.5 * e[2], e[1];
    if (Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(strain).eigenvalues().maxCoeff() <= 0) return 0;
    constexpr int count = 2000;
    double best = 0;
    for (int k = 1; k < count; ++k)
        if (const double phi = std::numbers::pi * k / count; folded_energy(C, e, phi) < folded_energy(C, e, best))
            best = phi;
    double low = best - std::numbers::pi / count, high = best + std::numbers::pi / count;
    for (int step = 0; step < 80; ++step) {
        const double a = low + 0.382 * (high - low), b = high - 0.382 * (high - low);
        (folded_energy(C, e, a) < folded_energy(C, e, b) ? high : low) =
            folded_energy(C, e, a) < folded_energy(C, e, b) ? b : a;
    }
    return folded_energy(C, e, 0.5 * (low + high));
}

struct Case {
    Fabric fabric;
    Vector3d strain;
};

/// Orthotropic cloths from soft to stiff, strains of a few per cent.
std::vector<Case> random_cases(int count) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(0, 1);
    std::normal_distribution<double> normal;
    std::vector<Case> cases;
    for (int k = 0; k < count; ++k) {
        Case each;
        each.fabric.warp_stiffness = 1e4 + 1e5 * share(random);
        each.fabric.weft_stiffness = each.fabric.warp_stiffness * (0.3 + share(random));
        each.fabric.poisson = 0.5 * share(random);
        each.fabric.shear_stiffness = each.fabric.warp_stiffness * (0.005 + 0.4 * share(random) * share(random));
        each.strain = 0.02 * Vector3d(normal(random), normal(random), normal(random));
        cases.push_back(each);
    }
    return cases;
}

TEST(TensionField, IsTheLeastEnergyOverAllFolds) {
    std::map<ClothState, int> count;
    for (const Case& each : random_cases(400)) {
        const ClothResponse response = TensionField(each.fabric).at(each.strain);
        const Matrix3d C = stiffness(each.fabric);
        // The search is exact up to the rounding of the energy before folding.
        const double tolerance = 1e-9 * response.energy + 1e-14 * each.strain.dot(C * each.strain);
        EXPECT_NEAR(response.energy, brute_force(C, each.strain), tolerance);
        ++count[response.state];
    }
    for (const ClothState state : {ClothState::taut, ClothState::wrinkled, ClothState::slack})
        EXPECT_GT(count[state], 30);
}

TEST(TensionField, StressProvesTheEnergyFromBelow) {
    // Any S >= 0 bounds psi_r from below by S·e - S·C^-1 S / 2; the solution's own S attains the bound.
    for (const Case& each : random_cases(400)) {
        const ClothResponse response = TensionField(each.fabric).at(each.strain);
        const Matrix3d C = stiffness(each.fabric);
        const Vector3d& S = response.stress;
        Eigen::Matrix2d tension;
        tension << S[0], S[2], S[2], S[1];
        const Vector3d force = C * each.strain;
        EXPECT_GE(Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(tension).eigenvalues().minCoeff(),
                  -1e-12 * force.norm());
        const double bound = S.dot(each.strain) - 0.5 * S.dot(C.inverse() * S);
        EXPECT_NEAR(response.energy, bound, 1e-9 * response.energy);
    }
}

TEST(TensionField, StressAndTangentAreTheDerivatives) {
    constexpr double step = 1e-7;
    for (const double residual : {0.0, 1e-3})
        for (const Case& each : random_cases(400)) {
            const TensionField cloth(each.fabric, residual);
            const ClothResponse response = cloth.at(each.strain);
            bool is_inside = true;  // of its state; the tangent jumps between two states
            for (int k = 0; k < 3; ++k)
                for (const double way : {-20 * step, 20 * step})
                    is_inside = is_inside && cloth.at(each.strain + way * Vector3d::Unit(k)).state == response.state;
            if (!is_inside) continue;
            const double scale = each.fabric.c11();
            const auto energy = [&](const Eigen::VectorXd& e) {
                return Eigen::VectorXd::Constant(1, cloth.at(e).energy).eval();
            };
            const auto stress = [&](const Eigen::VectorXd& e) -> Eigen::VectorXd { return cloth.at(e).stress; };
            // The rounding of an energy of about ten J/m² divided by the step, plus the square of the step over
            // the strain.
            EXPECT_LT((testing::jacobian(energy, each.strain, step).transpose() - response.stress).norm(),
                      1e-8 * scale);
            EXPECT_LT((testing::jacobian(stress, each.strain, step) - response.tangent).norm(), 1e-5 * scale);
        }
}

TEST(TensionField, TangentIsSymmetricAndNeverNegative) {
    for (const Case& each : random_cases(400)) {
        const Matrix3d tangent = TensionField(each.fabric).at(each.strain).tangent;
        EXPECT_LT((tangent - tangent.transpose()).norm(), 1e-12 * each.fabric.c11());
        EXPECT_GE(Eigen::SelfAdjointEigenSolver<Matrix3d>(tangent).eigenvalues().minCoeff(),
                  -1e-12 * each.fabric.c11());
    }
}

TEST(TensionField, FindsATensionInAVeryNarrowSector) {
    // Less than a tenth of a degree of all directions is stretched: a scan of the half circle misses it.
    const Vector3d strain(-0.02247315, -0.12426961, 0.10583768);
    const ClothResponse response = TensionField(testing::isotropic(1e3, 0.3)).at(strain);
    EXPECT_EQ(response.state, ClothState::wrinkled);
    EXPECT_NEAR(response.energy, 1.366455e-6, 1e-11);  // the digits of the strain
}

TEST(TensionField, IsotropicClothPullsAlongTheLargerPrincipalStrain) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    for (const double poisson : {0.0, 0.3, 0.45}) {
        const TensionField cloth(testing::isotropic(1e3, poisson));
        for (int k = 0; k < 100; ++k) {
            const double large = 0.02 * std::abs(normal(random)), angle = normal(random);
            const double small = -large * (poisson + std::abs(normal(random)));
            const double mean = 0.5 * (large + small), radius = 0.5 * (large - small);
            const Vector3d strain(mean + radius * std::cos(2 * angle), mean - radius * std::cos(2 * angle),
                                  2 * radius * std::sin(2 * angle));
            const ClothResponse response = cloth.at(strain);
            EXPECT_EQ(response.state, ClothState::wrinkled);
            EXPECT_NEAR(response.energy, 0.5 * 1e3 * large * large, 1e-12 * 1e3 * large * large);
            // The energy is flat in the angle, so the angle is accurate to the square root of rounding times that
            // flatness.
            EXPECT_LT((response.stress - 1e3 * large * ray(angle)).norm(), 1e-7 * 1e3 * large);
        }
    }
}

TEST(TensionField, WrinkledShearBearsAQuarterOfTheYoungModulus) {
    // Between rigid edges: tau = S11 = S22 = E gamma / 4 for any nu; taut cloth would carry G gamma.
    for (const double poisson : {0.0, 0.2, 0.3, 0.5})
        for (const double gamma : {1e-4, 1e-2}) {
            const ClothResponse response = TensionField(testing::isotropic(1, poisson)).at({0, 0, gamma});
            EXPECT_LT((response.stress - 0.25 * gamma * Vector3d::Ones()).norm(), 1e-9 * gamma);
            EXPECT_NEAR(response.direction, std::numbers::pi / 4, 1e-8);
        }
}

TEST(TensionField, PulledOffTheThreadsItIsAsSoftAsLaminateTheorySays) {
    // 1 / E(a) = cos^4 / E1 + sin^4 / E2 + cos^2 sin^2 (1 / G - 2 nu12 / E1), in N/m for 60 and 50 kN/m, nu 0.2,
    // G 1.5 kN/m.
    const std::vector<std::pair<double, double>> table = {{0, 60000}, {10, 28575},   {22.5, 10518},
                                                          {45, 5742}, {67.5, 10264}, {90, 50000}};
    const Fabric fabric = testing::balloon_nylon();
    for (const auto& [degrees, modulus] : table) {
        const Vector3d along = ray(degrees * degree);
        // A strip in uniaxial tension carries the same if it is folded further across.
        Vector3d fold = ray((degrees + 90) * degree);
        fold[2] *= 2;
        const Vector3d strain = stiffness(fabric).inverse() * (100 * along);
        for (const double folds : {0.0, 1e-4, 0.05}) {
            const ClothResponse response = TensionField(fabric).at(strain - folds * fold);
            EXPECT_LT((response.stress - 100 * along).norm(), 1e-5) << degrees;  // N/m; the rounding of the angle
            EXPECT_NEAR(100 / strain.dot(along), modulus, 0.5);                  // the digits of the table
        }
    }
}

TEST(TensionField, ResidualAddsItsShareOfTheClothThatPushes) {
    const Vector3d strain(-0.01, -0.02, 0.004);
    const Fabric fabric = testing::balloon_nylon();
    EXPECT_EQ(TensionField(fabric).at(strain).state, ClothState::slack);
    EXPECT_EQ(TensionField(fabric).at(strain).energy, 0);
    EXPECT_EQ(TensionField(fabric).at(strain).stress, Vector3d::Zero());
    const ClothResponse response = TensionField(fabric, 1e-3).at(strain);
    EXPECT_LT((response.stress - 1e-3 * stiffness(fabric) * strain).norm(), 1e-12);
    EXPECT_NEAR(response.energy, 0.5e-3 * strain.dot(stiffness(fabric) * strain), 1e-12);
}

}  // namespace tension_field_test
}  // namespace ripstop
