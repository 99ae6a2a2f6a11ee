#include "support/shapes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <random>

namespace ripstop::testing {

TriangleMesh rectangle(double width, double height, int nu, int nv) {
    return grid(nu, nv, [=](double u, double v) { return Vec3(width * u, height * v, 0); });
}

TriangleMesh cylinder(double radius, double angle, double height, int nu, int nv) {
    return grid(nu, nv, [=](double u, double v) {
        const double phi = angle * (u - 0.5);
        return Vec3(radius * std::cos(phi), radius * std::sin(phi), height * v);
    });
}

TriangleMesh cone(double half, double angle, double s0, double s1, int nu, int nv) {
    return grid(nu, nv, [=](double u, double v) {
        const double phi = angle * (u - 0.5);
        const double s = s1 + (s0 - s1) * v;
        return Vec3(s * std::sin(half) * std::cos(phi), s * std::sin(half) * std::sin(phi), -s * std::cos(half));
    });
}

TriangleMesh staggered_cone(double half, double angle, double s0, double s1, int nu, int nv) {
    return grid(
        nu, nv,
        [=](double u, double v) {
            const int row = static_cast<int>(std::lround(v * nv));
            const double shift = row % 2 == 1 ? std::min(u * nu, nu - u * nu) >= 0.5 ? 0.5 / nu : 0 : 0;
            const double phi = angle * (u + shift - 0.5);
            const double s = s1 + (s0 - s1) * v;
            return Vec3(s * std::sin(half) * std::cos(phi), s * std::sin(half) * std::sin(phi), -s * std::cos(half));
        },
        true);
}

TriangleMesh tangent_developable(double a, double b, double t1, double v0, double v1, int nu, int nv) {
    const double c = std::hypot(a, b);
    return grid(nu, nv, [=](double u, double w) {
        const double t = t1 * u;
        const double v = v0 + (v1 - v0) * w;
        return Vec3(a * std::cos(t) - v * a / c * std::sin(t), a * std::sin(t) + v * a / c * std::cos(t),
                    b * t + v * b / c);
    });
}

TriangleMesh lune(double angle, int columns, int rows) {
    const auto point = [&](int i, int j) {
        const double latitude = std::numbers::pi * (double(j) / rows - 0.5);
        const double longitude = angle * (double(i) / columns - 0.5);
        return Vec3(std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
                    std::sin(latitude));
    };
    TriangleMesh mesh;
    const int across = columns + 1;
    mesh.positions.resize(across * (rows - 1) + 2, 3);
    mesh.positions.row(0) << 0, 0, -1;
    for (int j = 1; j < rows; ++j)
        for (int i = 0; i <= columns; ++i) mesh.positions.row(1 + (j - 1) * across + i) = point(i, j).transpose();
    const int top = across * (rows - 1) + 1;
    mesh.positions.row(top) << 0, 0, 1;
    mesh.triangles.resize(2 * columns * (rows - 1), 3);
    int t = 0;
    const auto id = [&](int i, int j) { return 1 + (j - 1) * across + i; };
    for (int i = 0; i < columns; ++i) mesh.triangles.row(t++) << 0, id(i + 1, 1), id(i, 1);
    for (int j = 1; j + 1 < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const bool flip = 2 * i >= columns;
            const int a = id(i, j), b = id(i + 1, j), c = id(i + 1, j + 1), d = id(i, j + 1);
            if (flip) {
                mesh.triangles.row(t++) << a, b, c;
                mesh.triangles.row(t++) << a, c, d;
            } else {
                mesh.triangles.row(t++) << a, b, d;
                mesh.triangles.row(t++) << b, c, d;
            }
        }
    for (int i = 0; i < columns; ++i) mesh.triangles.row(t++) << id(i, rows - 1), id(i + 1, rows - 1), top;
    return mesh;
}

TriangleMesh cap(double theta, int rings) {
    std::vector<Vec3> points = {Vec3(0, 0, 1)};
    std::vector<Eigen::Vector3i> faces;
    int previous = 0;
    for (int ring = 1; ring <= rings; ++ring) {
        const int start = static_cast<int>(points.size());
        const double s = theta * ring / rings;
        for (int i = 0; i < 6 * ring; ++i) {
            const double phi = 2 * std::numbers::pi * i / (6 * ring);
            points.emplace_back(std::sin(s) * std::cos(phi), std::sin(s) * std::sin(phi), std::cos(s));
        }
        const int inner = 6 * (ring - 1);
        for (int sector = 0; sector < 6; ++sector)
            for (int i = 0; i < ring; ++i) {
                const int out0 = start + sector * ring + i;
                const int out1 = start + (sector * ring + i + 1) % (6 * ring);
                const auto in = [&](int k) { return ring == 1 ? 0 : previous + (sector * (ring - 1) + k) % inner; };
                faces.emplace_back(in(i), out0, out1);
                if (i + 1 < ring) faces.emplace_back(in(i), out1, in(i + 1));
            }
        previous = start;
    }
    TriangleMesh mesh;
    mesh.positions.resize(static_cast<int>(points.size()), 3);
    for (std::size_t i = 0; i < points.size(); ++i) mesh.positions.row(static_cast<int>(i)) = points[i].transpose();
    mesh.triangles.resize(static_cast<int>(faces.size()), 3);
    for (std::size_t i = 0; i < faces.size(); ++i) mesh.triangles.row(static_cast<int>(i)) = faces[i].transpose();
    return mesh;
}

TriangleMesh octant(int n) {
    TriangleMesh mesh;
    const auto id = [n](int i, int j) { return i * (n + 1) - i * (i - 1) / 2 + j; };
    mesh.positions.resize((n + 1) * (n + 2) / 2, 3);
    for (int i = 0; i <= n; ++i)
        for (int j = 0; i + j <= n; ++j) {
            // divides angles and not chords, so that the three sides have equal edges
            const double a = std::numbers::pi / 2 / n;
            const Vec3 p(std::sin(a * i), std::sin(a * j), std::sin(a * (n - i - j)));
            mesh.positions.row(id(i, j)) = p.normalized().transpose();
        }
    std::vector<Eigen::Vector3i> faces;
    for (int i = 0; i < n; ++i)
        for (int j = 0; i + j < n; ++j) {
            faces.emplace_back(id(i, j), id(i + 1, j), id(i, j + 1));
            if (i + j + 1 < n) faces.emplace_back(id(i + 1, j), id(i + 1, j + 1), id(i, j + 1));
        }
    mesh.triangles.resize(static_cast<int>(faces.size()), 3);
    for (std::size_t f = 0; f < faces.size(); ++f) mesh.triangles.row(static_cast<int>(f)) = faces[f].transpose();
    return mesh;
}

TriangleMesh spherical_square(double a, int n) {
    // Four geodesic sides: the central projection of the square with half side tan(a) in the tangent plane.
    return grid(
        n, n,
        [=](double u, double v) { return Vec3(std::tan(a * (2 * u - 1)), std::tan(a * (2 * v - 1)), 1).normalized(); },
        true);
}

TriangleMesh saddle(double k, double a, int n) {
    return grid(
        n, n,
        [=](double u, double v) {
            const double x = a * (2 * u - 1), y = a * (2 * v - 1);
            return Vec3(x, y, k * (x * x - y * y) / 2);
        },
        true);
}

TriangleMesh torus_patch(double R, double r, double around, double p0, double p1, int nu, int nv) {
    return grid(
        nu, nv,
        [=](double u, double v) {
            const double phi = around * (u - 0.5);
            const double p = p0 + (p1 - p0) * v;
            const double radius = R + r * std::cos(p);
            return Vec3(radius * std::cos(phi), radius * std::sin(phi), r * std::sin(p));
        },
        true);
}

TriangleMesh shuffled(const TriangleMesh& mesh, unsigned seed, std::vector<int>* order) {
    std::vector<int> old(static_cast<std::size_t>(mesh.vertex_count()));
    std::iota(old.begin(), old.end(), 0);
    std::mt19937 random(seed);
    std::shuffle(old.begin(), old.end(), random);
    std::vector<int> renumbered(old.size());
    for (std::size_t i = 0; i < old.size(); ++i) renumbered[static_cast<std::size_t>(old[i])] = static_cast<int>(i);
    TriangleMesh result;
    result.positions = mesh.positions(old, Eigen::all);
    result.triangles = mesh.triangles.unaryExpr([&](int v) { return renumbered[static_cast<std::size_t>(v)]; });
    if (order) *order = old;
    return result;
}

TriangleMesh moved(const TriangleMesh& mesh) {
    const Eigen::Matrix3d turn =
        (Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()) * Eigen::AngleAxisd(-1.3, Vec3(0, 1, 1).normalized()))
            .toRotationMatrix();
    TriangleMesh result = mesh;
    result.positions = (mesh.positions * turn.transpose()).rowwise() + Eigen::RowVector3d(3, -2, 5);
    return result;
}

TriangleMesh mirrored(const TriangleMesh& mesh) {
    TriangleMesh result = mesh;
    result.positions.col(0) *= -1;
    result.triangles.col(1).swap(result.triangles.col(2));
    return result;
}

TriangleMesh scaled(const TriangleMesh& mesh, double factor) {
    TriangleMesh result = mesh;
    result.positions *= factor;
    return result;
}

std::vector<Shape> developable_shapes() {
    return {{"plane", rectangle(2, 1, 12, 6)},
            {"cylinder", cylinder(1, 1.2, 2, 12, 16)},
            {"cone", cone(0.5, 2, 1, 2.5, 16, 12)},
            {"tangent developable", tangent_developable(1, 0.6, 0.8, 0.6, 1.4, 16, 10)}};
}

std::vector<Shape> curved_shapes() {
    return {{"gore of 24", lune(2 * std::numbers::pi / 24, 6, 48)},
            {"gore of 12", lune(2 * std::numbers::pi / 12, 8, 48)},
            {"spherical square", spherical_square(0.3, 12)},
            {"cap", cap(0.4, 8)},
            {"saddle", saddle(1, 0.4, 12)},
            {"torus inside", torus_patch(3, 1, 0.4, 2.6, 3.7, 12, 12)}};
}

}  // namespace ripstop::testing
