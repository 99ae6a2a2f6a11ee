#include <fmt/format.h>

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>
#include <utility>

#include "field/families.h"
#include "ripstop/base/text/units.h"
#include "support/shapes.h"

namespace ripstop::field {
namespace {

using std::numbers::pi;
using testing::grid;

TriangleMesh turned(TriangleMesh mesh, double angle) {
    mesh.positions *= Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix().transpose();
    return mesh;
}

/// Duplicates the first and the last vertex for each of their triangles, as some exporters do.
TriangleMesh with_unwelded_tips(TriangleMesh mesh) {
    for (const int tip : {0, mesh.vertex_count() - 1}) {
        bool is_first = true;
        for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f)
            for (int k = 0; k < 3; ++k) {
                if (mesh.triangles(f, k) != tip || std::exchange(is_first, false)) continue;
                mesh.positions.conservativeResize(mesh.positions.rows() + 1, 3);
                mesh.positions.row(mesh.positions.rows() - 1) = mesh.positions.row(tip);
                mesh.triangles(f, k) = mesh.vertex_count() - 1;
            }
    }
    return mesh;
}

/// A gore of the unit sphere whose tips are points, or edges with a width of `tip` [rad of longitude at the
/// equator].
TriangleMesh blunt_gore(double angle, int columns, int rows, double tip) {
    return grid(columns, rows, [=](double u, double v) {
        const double most = pi / 2 - std::asin(std::min(1.0, tip / angle));
        const double latitude = most * (2 * v - 1), longitude = angle * (u - 0.5);
        return Vec3(std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
                    std::sin(latitude));
    });
}

/// Half the thickness of a wing section at x in [0, 1] of the chord: a parabola that is closed at both ends.
double section(double x, double height) {
    return 4 * height * x * (1 - x);
}

/// A skin between two ribs, ruled across and therefore developable. Counter-clockwise as seen from outside.
TriangleMesh wing_skin(double y0, double y1, double chord, double height, int along, int across, bool is_upper) {
    return grid(across, along, [=](double u, double v) {
        const double x = is_upper ? 1 - v : v;
        const double z = section(x, height) * (is_upper ? 1 : -0.5);
        return Vec3(chord * x, y0 + (y1 - y0) * u, chord * z);
    });
}

TriangleMesh wing_rib(double y, double chord, double height, int along, int across) {
    return grid(along, across, [=](double u, double v) {
        const double low = -0.5 * section(u, height), high = section(u, height);
        return Vec3(chord * u, y, chord * (low + (high - low) * v));
    });
}

/// Removes triangles without area, which come from degenerate cells at both ends.
TriangleMesh without_empty(const TriangleMesh& mesh) {
    std::vector<int> kept;
    std::vector<int> same(static_cast<std::size_t>(mesh.vertex_count()));
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        same[static_cast<std::size_t>(v)] = v;
        for (int w = 0; w < v; ++w)
            if ((mesh.positions.row(v) - mesh.positions.row(w)).norm() < 1e-12) {
                same[static_cast<std::size_t>(v)] = w;
                break;
            }
    }
    std::vector<int> number(static_cast<std::size_t>(mesh.vertex_count()), -1);
    for (int v = 0; v < mesh.vertex_count(); ++v)
        if (same[static_cast<std::size_t>(v)] == v) {
            number[static_cast<std::size_t>(v)] = static_cast<int>(kept.size());
            kept.push_back(v);
        }
    TriangleMesh result;
    result.positions = mesh.positions(kept, Eigen::all);
    for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
        Eigen::RowVector3i t = mesh.triangles.row(f).unaryExpr(
            [&](int v) { return number[static_cast<std::size_t>(same[static_cast<std::size_t>(v)])]; });
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
        result.triangles.conservativeResize(result.triangles.rows() + 1, 3);
        result.triangles.row(result.triangles.rows() - 1) = t;
    }
    return result;
}

Case wing(int cells, int along) {
    Case wing{"ribs", fmt::format("{} cells, {} edges along", cells, along), {}, {}};
    const double chord = 2.4, height = 0.08, width = 0.35;
    for (int i = 0; i < cells; ++i) {
        wing.tiles.push_back(
            {fmt::format("U{:02d}", i), wing_skin(width * i, width * (i + 1), chord, height, along, 2, true)});
        wing.tiles.push_back(
            {fmt::format("L{:02d}", i), wing_skin(width * i, width * (i + 1), chord, height, along, 2, false)});
    }
    for (int i = 0; i <= cells; ++i) {
        TriangleMesh rib = without_empty(wing_rib(width * i, chord, height, along, 2));
        // Ribs at the tips close the wing, so their outside is that of the skin. Other ribs may have either side
        // up.
        if (i == cells || i % 2 == 1) rib.triangles.col(1).swap(rib.triangles.col(2));
        wing.tiles.push_back({fmt::format("R{:02d}", i), std::move(rib)});
    }
    wing.expected.is_isometric = true;
    // At nose and tail of each cell; above and below each rib: one of two sheets at the tips, one of three
    // elsewhere.
    wing.expected.seams = 2 * cells + 4 + 4 * (cells - 1);
    return wing;
}

/// A tube of `panels` with flat fins on its seams.
Case finned(int panels, int fins, int edges) {
    Case hull{"fins", fmt::format("{} panels, {} fins, {} edges", panels, fins, edges), {}, {}};
    const double length = 3, angle = 2 * pi / panels;
    for (int i = 0; i < panels; ++i)
        hull.tiles.push_back(
            {fmt::format("H{:02d}", i), turned(testing::cylinder(1, angle, length, edges, 6), angle * i)});
    for (int i = 0; i < fins; ++i) {
        const double at = angle * (i * (panels / fins) + 0.5);
        hull.tiles.push_back({fmt::format("F{:02d}", i), grid(3, 6, [=](double u, double v) {
                                  const double r = 1 + 0.8 * u;
                                  return Vec3(r * std::cos(at), r * std::sin(at), length * v);
                              })});
    }
    hull.expected.is_isometric = true;
    return hull;
}

}  // namespace

std::vector<Case> gores() {
    std::vector<Case> cases;
    const double radius = 5, area = 4 * pi * radius * radius;
    for (const int count : {16, 24, 32}) {
        const double angle = 2 * pi / count;
        std::vector<std::pair<std::string, TriangleMesh>> kinds{
            {"points", testing::lune(angle, 4, 24)},
            {"unwelded points", with_unwelded_tips(testing::lune(angle, 4, 24))}};
        for (const double tip : {1e-6, 1e-5, 1e-4, 4e-4, 0.02})
            kinds.emplace_back(fmt::format("tips of {:.4g} mm", tip * radius * 1000), blunt_gore(angle, 4, 24, tip));
        for (auto& [name, mesh] : kinds) {
            mesh.positions *= radius;
            // The sphere's circle loses what a chord of 7.5 degrees loses; flat cloth loses up to 1 % more.
            Case one{"gore", fmt::format("of {}, {}, alone", count, name), {{"G01", mesh}}, {}};
            one.expected = {true, false, area / count * 0.98, area / count * 1.01, 0, 1};
            Case all{"gore", fmt::format("{} with {}", count, name), {}, {}};
            for (int i = 0; i < count; ++i)
                all.tiles.push_back({fmt::format("G{:02d}", i + 1), turned(mesh, angle * i)});
            all.expected = {true, false, area * 0.98, area * 1.01, count, 1};
            cases.push_back(one);
            cases.push_back(all);
        }
    }
    return cases;
}

std::vector<Case> ribs() {
    std::vector<Case> cases;
    for (const int cells : {2, 5, 12})
        for (const int along : {8, 16}) cases.push_back(wing(cells, along));
    return cases;
}

std::vector<Case> fins() {
    std::vector<Case> cases;
    for (const int panels : {4, 8, 12})
        for (const int count : {1, 2, 4})
            for (const int edges : {2, 5}) cases.push_back(finned(panels, count, edges));
    return cases;
}

std::vector<Case> pools() {
    std::vector<Case> cases;
    for (const int sides : {16, 24, 32, 48, 96})
        for (const double height : {0.5, 1.2}) {
            const TriangleMesh floor = grid(sides, 1, [=](double u, double v) {
                return Vec3(2 * (1 - v) * std::cos(2 * pi * u), 2 * (1 - v) * std::sin(2 * pi * u), 0);
            });
            // Seen from outside, that is from below.
            TriangleMesh disc = without_empty(floor);
            disc.triangles.col(1).swap(disc.triangles.col(2));
            // `grid` closes the circle with a copy of its first point, which `without_empty` merges.
            TriangleMesh wall = testing::cylinder(2, 2 * pi, height, sides, 1);
            wall = turned(wall, pi);
            const double smooth = 4 * pi + 4 * pi * height;
            cases.push_back({"pool",
                             fmt::format("{} sides, {} m high", sides, height),
                             {{"FLOOR", disc}, {"WALL", wall}},
                             {{}, true, smooth * 0.97, smooth * 1.001, 2, 2}});
        }
    return cases;
}

std::vector<Case> tents() {
    std::vector<Case> cases;
    // Equal segments of a pyramid with a kink; flat above and below it.
    for (const int count : {5, 6, 8, 10})
        for (const int rows : {2, 6}) {
            Case tent{"tent", fmt::format("{} segments, {} rows", count, rows), {}, {}};
            const double angle = 2 * pi / count;
            for (int i = 0; i < count; ++i)
                tent.tiles.push_back({fmt::format("T{:02d}", i + 1),
                                      turned(grid(3, rows,
                                                  [=](double u, double v) {
                                                      const double r = v < 0.5 ? 3 - 0.8 * v : 2.6 - 4.4 * (v - 0.5);
                                                      const double z = v < 0.5 ? 3.2 * v : 1.6 + 2.4 * (v - 0.5);
                                                      const double half = r * std::tan(angle / 2);
                                                      return Vec3(r, half * (2 * u - 1), z);
                                                  }),
                                             angle * i)});
            tent.expected = {true, true, 0, 1e30, count, 1};
            cases.push_back(tent);
        }
    return cases;
}

std::vector<Case> covers() {
    std::vector<Case> cases;
    // A boat cover: strips across a shallow saddle along the keel.
    for (const int strips : {3, 6})
        for (const double sag : {0.05, 0.15})
            for (const int edges : {4, 10}) {
                Case cover{"cover", fmt::format("{} strips, sag {} m, {} edges", strips, sag, edges), {}, {}};
                for (int i = 0; i < strips; ++i)
                    cover.tiles.push_back({fmt::format("C{:02d}", i + 1), grid(edges, edges, [=](double u, double v) {
                                               const double x = 6 * ((i + u) / strips - 0.5), y = 2.4 * (v - 0.5);
                                               return Vec3(x, y, sag * x * x / 9 - 0.3 * y * y / 1.44);
                                           })});
                cover.expected.seams = strips - 1;
                cover.expected.manufacturable.reset();
                cases.push_back(cover);
            }
    return cases;
}

}  // namespace ripstop::field
