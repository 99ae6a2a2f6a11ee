#include <fmt/format.h>

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

#include "field/families.h"
#include "ripstop/base/text/units.h"
#include "support/shapes.h"

namespace ripstop::field {
namespace {

using std::numbers::pi;
using testing::grid;

/// The ratio of a polyline of `count` chords to its circular arc.
double chord_ratio(double angle, int count) {
    const double half = angle / count / 2;
    return std::sin(half) / half;
}

/// A strip around a cylinder: flat quads between rulings.
TriangleMesh strap(double radius, double angle, double width, double slant, int quads) {
    return grid(quads, 1, [=](double u, double v) {
        const double phi = angle * u;
        return Vec3(radius * std::cos(phi), radius * std::sin(phi), radius * phi * std::tan(slant) + width * v);
    });
}

TriangleMesh flat_ring(double inner, double outer, double angle, int around, int across) {
    return grid(around, across, [=](double u, double v) {
        const double r = outer + (inner - outer) * v;
        return Vec3(r * std::cos(angle * u), r * std::sin(angle * u), 0);
    });
}

double flat_ring_area(double inner, double outer, double angle, int around) {
    return (outer * outer - inner * inner) / 2 * around * std::sin(angle / around);
}

}  // namespace

std::vector<Case> straps() {
    std::vector<Case> cases;
    for (const int quads : {5, 8, 10, 14, 20})
        for (const double width : {0.02, 0.05, 0.1})
            for (const double slant : {0.0, 20.0, 45.0}) {
                const double radius = 0.1, smooth = radius * pi * width;
                cases.push_back({"strap",
                                 fmt::format("{} quads, {:.0f} mm, {:.0f} degrees", quads, width * 1000, slant),
                                 {{"STRAP", strap(radius, pi, width, slant * degree, quads)}},
                                 {true, true, smooth * chord_ratio(pi, quads) * (1 - 1e-6), smooth * 1.001, 0, 1}});
            }
    return cases;
}

std::vector<Case> belts() {
    std::vector<Case> cases;
    for (const double length : {0.5, 2.0, 12.0})
        for (const double width : {0.005, 0.02, 0.1, 0.25})
            for (const int edges : {1, 7}) {
                const double area = length * width;
                cases.push_back({"belt",
                                 fmt::format("{} x {} m, {} edges", length, width, edges),
                                 {{"BELT", testing::rectangle(length, width, edges, 1)}},
                                 {true, true, area * (1 - 1e-6), area * (1 + 1e-6), 0, 1}});
            }
    for (const double width : {0.02, 0.08})
        for (const double angle : {45.0, 170.0, 300.0})
            for (const int around : {24, 90}) {
                const double inner = 1.5, area = flat_ring_area(inner, inner + width, angle * degree, around);
                cases.push_back({"belt",
                                 fmt::format("curved by {} degrees, {} m wide, {} edges", angle, width, around),
                                 {{"HEM", flat_ring(inner, inner + width, angle * degree, around, 1)}},
                                 {true, true, area * (1 - 1e-6), area * (1 + 1e-6), 0, 1}});
            }
    return cases;
}

std::vector<Case> sleeves() {
    std::vector<Case> cases;
    for (const int sides : {4, 6, 8, 12, 16, 24, 48})
        for (const int rows : {1, 2, 4, 8})
            for (const double height : {0.5, 1.0, 2.0}) {
                const double smooth = 2 * pi * height;
                cases.push_back({"sleeve",
                                 fmt::format("{} sides, {} rows, {} m high", sides, rows, height),
                                 {{"SLEEVE", testing::cylinder(1, 2 * pi, height, sides, rows)}},
                                 {true, true, smooth * chord_ratio(2 * pi, sides) * (1 - 1e-6), smooth * 1.001, 1, 1}});
            }
    for (const double half : {10.0, 25.0, 45.0})
        for (const int sides : {8, 16, 32})
            for (const int rows : {1, 3}) {
                const double s0 = 1, s1 = 2, turn = 2 * pi * std::sin(half * degree);
                const double smooth = turn * (s1 * s1 - s0 * s0) / 2;
                cases.push_back({"sleeve",
                                 fmt::format("cone of {} degrees, {} sides, {} rows", half, sides, rows),
                                 {{"CONE", testing::cone(half * degree, 2 * pi, s0, s1, sides, rows)}},
                                 {true, true, smooth * 0.9 * chord_ratio(2 * pi, sides), smooth * 1.001, 1, 1}});
            }
    return cases;
}

std::vector<Case> rings() {
    std::vector<Case> cases;
    // A frustum whose flat angle is `turn`, sewn to itself: near 360, the gap at its inner edge is too narrow for
    // two allowances.
    for (const double turn : {300.0, 340.0, 352.0, 356.0, 359.0})
        for (const double inner : {0.1, 0.3, 1.0}) {
            const double half = std::asin(turn / 360), outer = inner + 0.5;
            const double smooth = turn * degree * (outer * outer - inner * inner) / 2;
            cases.push_back({"ring",
                             fmt::format("flat angle {} degrees, inside {} m", turn, inner),
                             {{"RING", testing::cone(half, 2 * pi, inner, outer, 72, 1)}},
                             {{}, true, smooth * 0.99, smooth * 1.001, 1, 1}});
        }
    return cases;
}

std::vector<Case> skirts() {
    std::vector<Case> cases;
    for (const int gores : {4, 8, 12})
        for (const int columns : {2, 4})
            for (const int rows : {1, 4}) {
                Case skirt{"skirt", fmt::format("{} gores, {} x {} quads", gores, columns, rows), {}, {}};
                const double half = 20 * degree, s0 = 4, s1 = 8, angle = 2 * pi / gores;
                for (int i = 0; i < gores; ++i) {
                    TriangleMesh mesh = testing::cone(half, angle, s0, s1, columns, rows);
                    const Eigen::AngleAxisd turn(i * angle, Vec3::UnitZ());
                    mesh.positions *= turn.toRotationMatrix().transpose();
                    skirt.tiles.push_back({fmt::format("S{:02d}", i + 1), mesh});
                }
                const double smooth = 2 * pi * std::sin(half) * (s1 * s1 - s0 * s0) / 2;
                skirt.expected = {true, true, smooth * 0.94, smooth * 1.001, gores, 1};
                cases.push_back(skirt);
            }
    return cases;
}

std::vector<Case> keyholes() {
    std::vector<Case> cases;
    for (const double opening : {0.1, 0.2, 0.5})
        for (const double slit : {0.01, 0.03, 0.06, 0.12}) {
            if (slit >= 2 * opening) continue;
            const double outer = 1;
            const double a0 = std::asin(slit / 2 / opening), a1 = std::asin(slit / 2 / outer);
            const int around = 36, across = 6;
            const TriangleMesh mesh = grid(around, across, [=](double u, double v) {
                const double r = outer + (opening - outer) * v;
                const double start = std::asin(slit / 2 / r);
                const double phi = start + (2 * pi - 2 * start) * u;
                return Vec3(r * std::cos(phi), r * std::sin(phi), 0);
            });
            const auto sector = [](double r, double start) { return r * r / 2 * (2 * pi - 2 * start); };
            const double smooth = sector(outer, a1) - sector(opening, a0);
            cases.push_back({"keyhole",
                             fmt::format("{} m across, slit of {:.0f} mm", 2 * opening, slit * 1000),
                             {{"PANEL", mesh}},
                             {{}, true, smooth * 0.97, smooth * 1.01, 0, 1}});
        }
    return cases;
}

}  // namespace ripstop::field
