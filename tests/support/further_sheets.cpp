#include "support/further_sheets.h"

#include <cmath>
#include <numbers>

#include "support/shapes.h"

namespace ripstop::testing {
namespace {

using std::numbers::pi;

/// A flat sheet that starts on the x axis between `x0` and `x1` and is `width` wide, at `angle` [rad] about the
/// axis from +y towards +z. Its first edge runs along the axis; `up` decides which side is the outside.
NamedMesh flag(const std::string& name, double x0, double x1, double width, double angle, int edges, bool up) {
    const Vec3 way(0, std::cos(angle), std::sin(angle));
    TriangleMesh mesh =
        grid(edges, 3, [&](double u, double v) { return Vec3(Vec3(x0 + (x1 - x0) * u, 0, 0) + v * width * way); });
    if (!up) mesh.triangles.col(1).swap(mesh.triangles.col(2));
    return {name, std::move(mesh), {}};
}

std::string numbered_sheet(const std::string& name, int number) {
    return name + std::to_string(number);
}

/// From the equator (v = 0) to a pole: rows of `columns` edges, and one vertex at the pole.
TriangleMesh polar_sector(double west, double east, int columns, int rows, bool north) {
    TriangleMesh mesh;
    mesh.positions.resize(rows * (columns + 1) + 1, 3);
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i <= columns; ++i) {
            const double latitude = pi / 2 * j / rows, longitude = west + (east - west) * i / columns;
            mesh.positions.row(j * (columns + 1) + i) << std::cos(latitude) * std::cos(longitude),
                std::cos(latitude) * std::sin(longitude), std::sin(latitude);
        }
    const int pole = rows * (columns + 1);
    mesh.positions.row(pole) << 0, 0, 1;
    std::vector<Eigen::Vector3i> triangles;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const int a = j * (columns + 1) + i, d = a + columns + 1;
            if (j + 1 == rows) {
                triangles.emplace_back(a, a + 1, pole);
                continue;
            }
            triangles.emplace_back(a, a + 1, d + 1);
            triangles.emplace_back(a, d + 1, d);
        }
    mesh.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
    for (std::size_t t = 0; t < triangles.size(); ++t)
        mesh.triangles.row(static_cast<Eigen::Index>(t)) = triangles[t].transpose();
    if (!north) {
        mesh.positions.col(2) *= -1;
        mesh.triangles.col(1).swap(mesh.triangles.col(2));
    }
    return mesh;
}

TriangleMesh disc(int edges, int rings) {
    TriangleMesh mesh;
    mesh.positions.resize(rings * edges + 1, 3);
    mesh.positions.row(0).setZero();
    for (int r = 1; r <= rings; ++r)
        for (int i = 0; i < edges; ++i)
            mesh.positions.row((r - 1) * edges + i + 1) << double(r) / rings * std::cos(2 * pi * i / edges),
                double(r) / rings * std::sin(2 * pi * i / edges), 0;
    mesh.triangles.resize(edges * (2 * rings - 1), 3);
    int t = 0;
    for (int i = 0; i < edges; ++i) {
        const int next = (i + 1) % edges;
        mesh.triangles.row(t++) << 0, i + 1, next + 1;
        for (int r = 1; r < rings; ++r) {
            const int a = (r - 1) * edges + i + 1, b = (r - 1) * edges + next + 1;
            mesh.triangles.row(t++) << a, a + edges, b + edges;
            mesh.triangles.row(t++) << a, b + edges, b;
        }
    }
    return mesh;
}

constexpr double chord = 1.2, thickness = 0.2, span = 0.3;  // of a wing's cell [m]

/// Half the thickness of the wing: largest in the middle, and not 0 at the ends.
double half_thickness(double x) {
    return thickness / 2 * (0.4 + 0.6 * std::sin(pi * x / chord));
}

}  // namespace

std::vector<NamedMesh> rib_under_seam(double slope, double lean, const std::vector<int>& edges) {
    return {flag("LEFT", 0, 1, 0.5, pi - slope, edges[0], false), flag("RIGHT", 0, 1, 0.5, slope, edges[1], true),
            flag("RIB", 0, 1, 0.4, -pi / 2 + lean, edges[2], true)};
}

std::vector<NamedMesh> rib_under_junction(double from, double to) {
    return {flag("LEFT", 0, 2, 0.5, pi - 0.1, 6, false), flag("R1", 0, 1, 0.5, 0.1, 5, true),
            flag("R2", 1, 2, 0.5, 0.1, 4, true), flag("RIB", from, to, 0.4, -pi / 2, 7, true)};
}

std::vector<NamedMesh> rib_past_seam() {
    return {flag("LEFT", 0, 2, 0.5, pi - 0.1, 7, false), flag("RIGHT", 0, 1, 0.5, 0.1, 4, true),
            flag("RIB", 0, 2, 0.4, -pi / 2, 5, true)};
}

std::vector<NamedMesh> ball_with_disc(int sectors, int columns, int disc_columns) {
    std::vector<NamedMesh> meshes;
    for (const bool north : {true, false})
        for (int k = 0; k < sectors; ++k)
            meshes.push_back({numbered_sheet(north ? "UP" : "DOWN", k),
                              polar_sector(2 * pi * k / sectors, 2 * pi * (k + 1) / sectors, columns,
                                           std::max(3, 2 * columns), north),
                              {}});
    meshes.push_back({"DISC", disc(sectors * disc_columns, 4), {}});
    return meshes;
}

std::vector<NamedMesh> hull_with_fin(bool of_two_sheets) {
    const auto side = [](double from, double to) {
        return grid(24, 40, [&](double u, double v) {
            const double angle = from + (to - from) * v;
            return Vec3(6 * u, std::sin(angle), std::cos(angle));
        });
    };
    std::vector<NamedMesh> meshes{{"PORT", side(-pi, 0), {}}, {"STARBOARD", side(0, pi), {}}};
    const auto fin = [](double foot) {
        return grid(12, 4,
                    [&](double u, double v) { return Vec3(1.5 + 3 * u, foot * std::sin(pi * v) * 0.1, 1 + 0.8 * v); });
    };
    if (!of_two_sheets) {
        meshes.push_back({"FIN", fin(0), {}});
        return meshes;
    }
    meshes.push_back({"FIN-P", fin(-1), {}});
    meshes.push_back(turned_over({"FIN-S", fin(1), {}}));
    return meshes;
}

std::vector<NamedMesh> wing_with_ribs(int cells, double lobe, bool apart) {
    std::vector<NamedMesh> meshes;
    const auto edges = [&](int least, int number) { return apart ? least + number % 3 : least; };
    for (int c = 1; c <= cells; ++c) {
        const double y0 = span * (c - 1);
        const auto skin = [&](bool above, int number) {
            TriangleMesh mesh = grid(edges(16, number), edges(6, number), [&](double u, double v) {
                const double arch = lobe * std::sin(pi * v) * std::sin(pi * u);
                const double z = half_thickness(chord * u) + arch;
                return Vec3(chord * u, y0 + span * v, above ? z : -z);
            });
            if (!above) mesh.triangles.col(1).swap(mesh.triangles.col(2));
            return mesh;
        };
        const auto end = [&](bool tail, int number) {
            const double x = tail ? chord : 0;
            TriangleMesh mesh = grid(edges(6, number), edges(3, number), [&](double u, double v) {
                return Vec3(x, y0 + span * u, half_thickness(x) * (2 * v - 1));
            });
            if (!tail) mesh.triangles.col(1).swap(mesh.triangles.col(2));
            return mesh;
        };
        meshes.push_back({numbered_sheet("U", c), skin(true, c), {}});
        meshes.push_back({numbered_sheet("L", c), skin(false, c + 1), {}});
        meshes.push_back({numbered_sheet("N", c), end(false, c + 2), {}});
        meshes.push_back({numbered_sheet("T", c), end(true, c), {}});
    }
    for (int r = 0; r <= cells; ++r) {
        TriangleMesh mesh = grid(edges(16, 2 * r + 1), edges(3, r), [&](double u, double v) {
            return Vec3(chord * u, span * r, half_thickness(chord * u) * (2 * v - 1));
        });
        if (r == cells) mesh.triangles.col(1).swap(mesh.triangles.col(2));
        meshes.push_back({numbered_sheet("R", r), std::move(mesh), {}});
    }
    return meshes;
}

std::vector<NamedMesh> two_skins_and_rib() {
    return {flag("TOP-L", 0, 1, 0.5, pi - 0.5, 4, false), flag("TOP-R", 0, 1, 0.5, 0.5, 4, true),
            flag("BELOW-L", 0, 1, 0.5, pi + 0.7, 4, true), flag("BELOW-R", 0, 1, 0.5, -0.7, 4, false),
            flag("RIB", 0, 1, 0.4, -pi / 2, 4, true)};
}

NamedMesh turned_over(NamedMesh mesh) {
    mesh.mesh.triangles.col(1).swap(mesh.mesh.triangles.col(2));
    return mesh;
}

}  // namespace ripstop::testing
