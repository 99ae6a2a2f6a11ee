#include "ripstop/design/natural/natural_shape.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "ripstop/base/error.h"
#include "ripstop/base/text/units.h"
#include "support/refusal.h"

namespace ripstop {
namespace natural_shape_test {

using std::numbers::pi;
using ::testing::HasSubstr;

/// A shape that is closed to a point at the mouth, in units of (F/b)^(1/3), with Smalley's Sigma = (2 pi)^(1/3) w
/// / b.
NaturalShape smalley(double sigma) {
    NaturalShapeOptions options;
    options.load = 1;
    options.buoyancy = 1;
    options.weight = sigma / std::cbrt(2 * pi);
    options.mouth_ratio = 0;
    return natural_shape(options);
}

NaturalShape lobed(int tapes, double degrees) {
    NaturalShapeOptions options;
    options.tapes = tapes;
    options.bulge = degrees * degree;
    return natural_shape(options);
}

std::string refusal(const NaturalShapeOptions& options) {
    return testing::refusal([&] { natural_shape(options); });
}

constexpr double digits2 = 0.5e-2, digits3 = 0.5e-3, digits4 = 0.5e-4, digits5 = 0.5e-5, digits6 = 0.5e-6;
constexpr double last = 1.02;  // half a unit of the last printed digit, plus the rounding of the comparison

// The reference figures of this file come from an independent solver (DOP853, rtol 1e-11). It takes the heights of
// the equator, and some radii, from the widest of sampled points (0.344375 for 0.344379, which a third solver
// confirms), so those two have wider tolerances.

TEST(NaturalShape, ClosedFamilyHasTheKnownFigures) {
    const double table[][10] = {
        // Sigma, th0, L, H, R, z(R), V, A, V/L3, H/D
        {0.0, 50.1488, 1.99441, 1.28421, 0.65218, 0.84741, 1.000000, 4.91628, 0.126054, 0.98454},
        {0.1, 54.3914, 2.15455, 1.33903, 0.72583, 0.86163, 1.320510, 5.91427, 0.132030, 0.92242},
        {0.2, 58.8862, 2.35043, 1.40675, 0.81334, 0.88039, 1.783852, 7.23210, 0.137378, 0.86481},
        {0.4, 67.9195, 2.87047, 1.59121, 1.03603, 0.93735, 3.438187, 11.24778, 0.145368, 0.76794},
        {0.8, 80.9367, 4.40099, 2.17625, 1.65252, 1.15639, 12.900459, 27.44945, 0.151340, 0.65846},
    };
    for (const auto& row : table) {
        SCOPED_TRACE(row[0]);
        const NaturalShape shape = smalley(row[0]);
        ASSERT_TRUE(shape.summary.usable()) << shape.summary.text();
        EXPECT_NEAR(shape.theta0 / degree, row[1], digits4 * last);
        EXPECT_NEAR(shape.length, row[2], digits5 * last);
        EXPECT_NEAR(shape.height, row[3], digits5 * last);
        EXPECT_NEAR(shape.max_radius, row[4], digits5 * last);
        EXPECT_NEAR(shape.equator_z, row[5], 1e-4);
        EXPECT_NEAR(shape.volume, row[6], digits6 * last);
        EXPECT_NEAR(shape.area, row[7], digits5 * last);
        EXPECT_NEAR(shape.volume / std::pow(shape.length, 3), row[8], digits6 * last);
        EXPECT_NEAR(shape.height / (2 * shape.max_radius), row[9], digits5 * last);
        EXPECT_LT(std::abs(shape.imbalance), 1e-11);
    }
}

TEST(NaturalShape, WeightlessProfileIsTheKnownOne) {
    const double table[][4] = {// s/L, r/L, z/L, theta in degrees
                               {0.0, 0, 0, 50.149},
                               {0.1, .076687, .064180, 49.849},
                               {0.2, .152179, .129753, 47.744},
                               {0.3, .223174, .200119, 42.005},
                               {0.4, .283164, .279927, 30.800},
                               {0.5, .321005, .372038, 12.634},
                               {0.6, .322026, .471232, -12.456},
                               {0.7, .277513, .559606, -41.126},
                               {0.8, .196732, .617092, -66.955},
                               {0.9, .099895, .640483, -84.123},
                               {1.0, 0, .643904, -90}};
    const NaturalShape shape = smalley(0);
    for (const auto& row : table) {
        SCOPED_TRACE(row[0]);
        const MeridianPoint point = shape.point_at(row[0] * shape.length);
        EXPECT_NEAR(point.r / shape.length, row[1], digits6 * last);
        EXPECT_NEAR(point.z / shape.length, row[2], digits6 * last);
        EXPECT_NEAR(point.theta / degree, row[3], digits3 * last);
    }
    EXPECT_NEAR(shape.max_radius / shape.length, .327006, digits6 * last);
    EXPECT_NEAR(shape.meridian.equator().s / shape.length, .5533, 1e-4);
}

TEST(NaturalShape, WeightlessTensionIsConstantAndLiftIsTheLoad) {
    NaturalShapeOptions options;
    options.weight = 0;
    const NaturalShape shape = natural_shape(options);
    EXPECT_NEAR(shape.load, options.buoyancy * options.volume, 1e-7);
    for (const MeridianPoint& p : shape.meridian.stations) EXPECT_NEAR(p.tension, shape.mouth_tension, 1e-7);
    EXPECT_NEAR(shape.mouth_tension * std::cos(shape.theta0), shape.load, 1e-7);
}

TEST(NaturalShape, OpenMouthFamilyHasTheKnownFigures) {
    const double table[][7] = {
        // r0/R, th0, V/L3, R/L, H/L, A/L2, H/D
        {.15, 47.281, .149744, .344375, .65414, 1.37770, .94975},
        {.20, 46.168, .159010, .350661, .65731, 1.42667, .93724},
        {.25, 44.970, .169064, .357230, .66030, 1.47658, .92420},
        {.30, 43.680, .179976, .364114, .66310, 1.52750, .91056},
    };
    for (const auto& row : table) {
        SCOPED_TRACE(row[0]);
        NaturalShapeOptions options;
        options.weight = 0;
        options.mouth_ratio = row[0];
        const NaturalShape shape = natural_shape(options);
        const double L = shape.length;
        EXPECT_NEAR(shape.theta0 / degree, row[1], digits3 * last);
        EXPECT_NEAR(shape.volume / (L * L * L), row[2], digits6 * last);
        EXPECT_GT(shape.max_radius / L, row[3] - digits6 * last);
        EXPECT_LT(shape.max_radius / L, row[3] + 5e-6);
        EXPECT_NEAR(shape.height / L, row[4], digits5 * last);
        EXPECT_NEAR(shape.area / (L * L), row[5], digits5 * last);
        EXPECT_NEAR(shape.height / (2 * shape.max_radius), row[6], 2.5e-5);
        EXPECT_NEAR(shape.mouth_radius, row[0] * shape.max_radius, 1e-8);
    }
}

TEST(NaturalShape, OpenMouthConfirmedByAThirdSolver) {
    // Fourth-order Runge-Kutta with a fixed step of 1/1000, shooting by Newton's method: r0/R, th0, R/L, H/L.
    const double table[][4] = {{.15, 47.28068801699, 0.344379201319, 0.654136741634},
                               {.20, 46.16824788207, 0.350661813054, 0.657305489267}};
    for (const auto& row : table) {
        NaturalShapeOptions options;
        options.weight = 0;
        options.mouth_ratio = row[0];
        const NaturalShape shape = natural_shape(options);
        EXPECT_NEAR(shape.theta0 / degree, row[1], 1e-8);
        EXPECT_NEAR(shape.max_radius / shape.length, row[2], 1e-10);
        EXPECT_NEAR(shape.height / shape.length, row[3], 1e-10);
    }
}

TEST(NaturalShape, RegressionCaseA) {
    const NaturalShape shape = natural_shape({});
    EXPECT_NEAR(shape.theta0 / degree, 46.0099, digits4 * last);
    EXPECT_NEAR(shape.length, 25.84551, digits5 * last);
    EXPECT_NEAR(shape.height, 16.92481, digits5 * last);
    EXPECT_NEAR(shape.max_radius, 9.36057, digits5 * last);
    EXPECT_NEAR(shape.equator_z, 10.6305, 1.5e-3);
    EXPECT_NEAR(shape.area, 1002.496, digits3 * last);
    EXPECT_NEAR(shape.load, 7570.477, digits3 * last);
    EXPECT_NEAR(shape.mouth_tension, 10900.09, digits2 * last);
    EXPECT_NEAR(shape.crown_tension, 11390.27, 1.2 * digits2);
    EXPECT_NEAR(shape.mouth_radius, 2.4337, digits4 * last);
    EXPECT_LT(std::abs(shape.imbalance), 1e-11);
    const double profile[][3] = {{.1, 4.28395, 1.80458},  {.2, 6.06664, 3.67535},  {.3, 7.66005, 5.70778},
                                 {.4, 8.85740, 7.99168},  {.5, 9.35956, 10.51424}, {.6, 8.87285, 13.03246},
                                 {.7, 7.35061, 15.09417}, {.8, 5.11203, 16.35411}, {.9, 2.58273, 16.85242},
                                 {1.0, 0, 16.92481}};
    for (const auto& row : profile) {
        SCOPED_TRACE(row[0]);
        const MeridianPoint point = shape.point_at(row[0] * shape.length);
        EXPECT_NEAR(point.r, row[1], digits5 * last);
        EXPECT_NEAR(point.z, row[2], digits5 * last);
    }
}

TEST(NaturalShape, RegressionCaseB) {
    const NaturalShape shape = lobed(24, 30);
    EXPECT_NEAR(shape.theta0 / degree, 41.3670, digits4 * last);
    EXPECT_NEAR(shape.length, 26.31409, digits5 * last);
    EXPECT_NEAR(shape.height, 18.42186, digits5 * last);
    EXPECT_NEAR(shape.max_radius, 8.80951, digits5 * last);
    EXPECT_NEAR(shape.load, 7475.984, digits3 * last);
    EXPECT_NEAR(shape.mouth_tension, 9961.44, digits2 * last);
    EXPECT_NEAR(shape.crown_tension, 8659.71, digits2 * last);
    EXPECT_NEAR(shape.mouth_radius, 2.2905, digits4 * last);
    EXPECT_NEAR(shape.imbalance, -0.009, digits4 * 10);
    const MeridianPoint middle = shape.point_at(0.5 * shape.length);
    EXPECT_NEAR(middle.r, 8.79772, digits5 * last);
    EXPECT_NEAR(middle.z, 11.14645, digits5 * last);
}

TEST(NaturalShape, LobedFamilyHasTheKnownFigures) {
    const double table[][9] = {
        // n, B, th0, H, R, H/D, L, tension of a tape at the mouth and at the crown
        {24, 45, 43.04, 17.435, 8.905, .979, 25.650, 421, 400},
        {24, 30, 41.37, 18.422, 8.809, 1.046, 26.314, 415, 361},
        {24, 20, 38.54, 19.899, 8.572, 1.161, 27.222, 401, 301},
        {24, 10, 26.08, 27.924, 7.349, 1.900, 32.826, 349, 121},
        {12, 60, 41.16, 17.065, 8.502, 1.004, 24.851, 797, 744},
        {12, 45, 39.52, 18.416, 8.488, 1.085, 25.920, 794, 668},
        {12, 30, 35.33, 21.061, 8.204, 1.284, 27.767, 764, 508},
        {32, 20, 40.69, 18.948, 8.788, 1.078, 26.709, 310, 258},
    };
    for (const auto& row : table) {
        SCOPED_TRACE(std::to_string(row[0]) + " tapes, " + std::to_string(row[1]) + " degrees");
        const NaturalShape shape = lobed(static_cast<int>(row[0]), row[1]);
        ASSERT_TRUE(shape.summary.usable()) << shape.summary.text();
        EXPECT_NEAR(shape.theta0 / degree, row[2], digits2 * last);
        EXPECT_NEAR(shape.height, row[3], digits3 * last);
        EXPECT_NEAR(shape.max_radius, row[4], 1.2 * digits3);
        EXPECT_NEAR(shape.height / (2 * shape.max_radius), row[5], digits3 * last);
        EXPECT_NEAR(shape.length, row[6], digits3 * last);
        EXPECT_NEAR(shape.mouth_tension / row[0], row[7], 0.5 * last);
        EXPECT_NEAR(shape.crown_tension / row[0], row[8], 0.5 * last);
    }
}

/// N_h = p rho of the lobes, with p = b z [N/m].
double hoop_tension(const MeridianEquation& equation, const MeridianPoint& at) {
    return equation.buoyancy * at.z * at.r * std::sin(std::numbers::pi / equation.tapes) / std::sin(equation.bulge);
}

TEST(NaturalShape, LobedHoopTensionHasTheKnownPeak) {
    const double table[][3] = {{24, 45, 57.9}, {24, 30, 85.3},  {24, 20, 130.3}, {24, 10, 303.4},
                               {12, 60, 88.5}, {12, 45, 115.8}, {12, 30, 179.2}, {32, 20, 95.8}};
    for (const auto& row : table) {
        const NaturalShape shape = lobed(static_cast<int>(row[0]), row[1]);
        double peak = 0;
        for (const MeridianPoint& p : shape.meridian.stations)
            peak = std::max(peak, hoop_tension(shape.meridian.equation, p));
        EXPECT_NEAR(peak, row[2], 0.06) << row[0] << " tapes, " << row[1] << " degrees";
    }
}

TEST(NaturalShape, EverySizeOfTheFleetHasTheKnownFigures) {
    const double table[][7] = {{1600, 13.68, 15.20, 20.93, 659, 1.98, 46.3},
                               {2200, 15.24, 16.89, 23.29, 815, 2.20, 46.2},
                               {3400, 17.66, 19.51, 26.95, 1090, 2.54, 46.0},
                               {4250, 19.04, 21.01, 29.04, 1265, 2.73, 45.9},
                               {6000, 21.39, 23.56, 32.60, 1592, 3.06, 45.7}};
    for (const auto& row : table) {
        SCOPED_TRACE(row[0]);
        NaturalShapeOptions options;
        options.volume = row[0];
        const NaturalShape shape = natural_shape(options);
        EXPECT_NEAR(shape.height, row[1], digits2 * last);
        EXPECT_NEAR(2 * shape.max_radius, row[2], digits2 * last);
        EXPECT_NEAR(shape.length, row[3], digits2 * last);
        EXPECT_NEAR(shape.area, row[4], 0.5 * last);
        EXPECT_NEAR(shape.mouth_radius, row[5], digits2 * last);
        EXPECT_NEAR(shape.theta0 / degree, row[6], 0.05 * last);
    }
}

TEST(NaturalShape, IsTheSameWhicheverSizeIsGiven) {
    const NaturalShape by_volume = natural_shape({});
    NaturalShapeOptions options;
    options.diameter = 2 * by_volume.max_radius;
    const NaturalShape by_diameter = natural_shape(options);
    options.diameter.reset();
    options.load = by_volume.load;
    const NaturalShape by_load = natural_shape(options);
    EXPECT_NEAR(by_diameter.volume, 3000, 1e-5);
    EXPECT_NEAR(by_load.volume, 3000, 1e-5);
    EXPECT_NEAR(by_load.theta0, by_volume.theta0, 1e-9);
}

TEST(NaturalShape, MeridianObeysItsEquationBetweenStationsToo) {
    for (const NaturalShape& shape : {natural_shape({}), lobed(24, 30)}) {
        // Central differences with h = 2 cm have an error of h² / 6 times the third derivative, far below 1e-4.
        constexpr double h = 0.02;
        for (double s = 1; s < shape.length - 1; s += 0.777) {
            const MeridianPoint before = shape.point_at(s - h);
            const MeridianPoint after = shape.point_at(s + h);
            const MeridianPoint slope = shape.meridian.equation.slope(shape.point_at(s));
            EXPECT_NEAR((after.r - before.r) / (2 * h), slope.r, 1e-4);
            EXPECT_NEAR((after.theta - before.theta) / (2 * h), slope.theta, 1e-4);
            EXPECT_NEAR((after.tension - before.tension) / (2 * h), slope.tension, 1e-4 * shape.mouth_tension);
            EXPECT_NEAR((after.volume - before.volume) / (2 * h), slope.volume, 1e-4 * slope.volume + 1e-4);
        }
    }
}

TEST(NaturalShape, TapeWeightCountsAsWeight) {
    NaturalShapeOptions options;
    options.tape_weight = 0.03 * gravity;
    const NaturalShape shape = natural_shape(options);
    EXPECT_LT(std::abs(shape.imbalance), 1e-11);
    EXPECT_NEAR(shape.weight, options.weight * shape.area + 24 * options.tape_weight * shape.length, 1e-9);
    EXPECT_LT(shape.load, natural_shape({}).load);
}

TEST(NaturalShape, SaysSoWhereThereIsNone) {
    NaturalShapeOptions too_small;
    too_small.volume = 1;  // lifts 0.28 kg; its cloth alone weighs 0.31 kg
    const NaturalShape shape = natural_shape(too_small);
    EXPECT_FALSE(shape.summary.usable());
    EXPECT_THAT(shape.summary.text(), HasSubstr("no meridian"));
}

TEST(NaturalShape, RefusesOptionsOutOfRange) {
    NaturalShapeOptions options;
    options.mouth_ratio = 0.9;
    EXPECT_THAT(refusal(options), HasSubstr("mouth ratio is 0.9; it must lie between 0 and 0.8"));
    options = {};
    options.volume = std::nan("");
    EXPECT_THAT(refusal(options), HasSubstr("volume"));
    options = {};
    options.diameter = 18;
    options.load = 7000;
    EXPECT_THAT(refusal(options), HasSubstr("give one size"));
    options = {};
    options.tapes = 2;
    EXPECT_THAT(refusal(options), HasSubstr("number of tapes is 2"));
    options = {};
    options.bulge = -1 * degree;
    EXPECT_THAT(refusal(options), HasSubstr("bulge half-angle"));
}

TEST(Buoyancy, IsThatOfTheStandardAtmosphere) {
    const double table[][2] = {{60, 1.6227}, {80, 2.2111}, {100, 2.7365}, {110, 2.9786}, {120, 3.2084}};
    for (const auto& row : table) EXPECT_NEAR(buoyancy({row[0], 15, 0}), row[1], digits4 * last);
    // ISA: 54 020 Pa at 5000 m, so the same temperatures lift 0.5331 of the load at sea level.
    EXPECT_NEAR(buoyancy({100, 15, 5000}) / buoyancy({100, 15, 0}), 54020.0 / 101325, 1e-5);
    EXPECT_THROW(buoyancy({15, 15, 0}), InputError);
    EXPECT_THROW(buoyancy({100, 15, 20000}), InputError);
}

}  // namespace natural_shape_test
}  // namespace ripstop
