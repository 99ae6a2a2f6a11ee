#pragma once

#include <string>
#include <vector>

#include "ripstop/mesh/triangle_mesh.h"

/// Surfaces with known flattenings. All are disks, counter-clockwise as seen from outside, in metres.
namespace ripstop::testing {

/// A grid of (nu + 1) x (nv + 1) points of a surface map (u, v) in [0,1]² -> space, two triangles per cell.
/// `staggered`: diagonals alternate in a checkerboard; otherwise all run from (0,0) to (1,1) of the cell.
template <class Map>
TriangleMesh grid(int nu, int nv, Map&& map, bool staggered = false) {
    TriangleMesh mesh;
    mesh.positions.resize((nu + 1) * (nv + 1), 3);
    for (int j = 0; j <= nv; ++j)
        for (int i = 0; i <= nu; ++i)
            mesh.positions.row(j * (nu + 1) + i) = map(double(i) / nu, double(j) / nv).transpose();
    mesh.triangles.resize(2 * nu * nv, 3);
    int t = 0;
    for (int j = 0; j < nv; ++j)
        for (int i = 0; i < nu; ++i) {
            const int a = j * (nu + 1) + i;
            const int b = a + 1;
            const int c = b + nu + 1;
            const int d = c - 1;
            if (staggered && (i + j) % 2 == 1) {
                mesh.triangles.row(t++) << a, b, d;
                mesh.triangles.row(t++) << b, c, d;
            } else {
                mesh.triangles.row(t++) << a, b, c;
                mesh.triangles.row(t++) << a, c, d;
            }
        }
    return mesh;
}

TriangleMesh rectangle(double width, double height, int nu, int nv);
/// Ruled along z: an inscribed prism, exactly developable.
TriangleMesh cylinder(double radius, double angle, double height, int nu, int nv);
/// Edges along the rulings: a polyhedral cone, exactly developable. Half angle `half`, slant height from s0 to s1
/// [m].
TriangleMesh cone(double half, double angle, double s0, double s1, int nu, int nv);
/// The same cone with every second row shifted by half a cell: developable only in the limit, with second order.
TriangleMesh staggered_cone(double half, double angle, double s0, double s1, int nu, int nv);
/// The tangent surface of the helix (a cos t, a sin t, b t), t in [0, t1], v in [v0, v1] along the tangent; ruled.
TriangleMesh tangent_developable(double a, double b, double t1, double v0, double v1, int nu, int nv);
/// A gore of the unit sphere: longitude in [-angle/2, angle/2], pole to pole, with single vertices at the poles.
TriangleMesh lune(double angle, int columns, int rows);
/// A cap of the unit sphere around +z with half opening angle `theta`: rings around a central vertex.
TriangleMesh cap(double theta, int rings);
/// The octant x, y, z >= 0 of the unit sphere, n subdivisions per side.
TriangleMesh octant(int n);
/// A patch of the unit sphere with four geodesic sides, half side `a` [rad] along the axes of the tangent plane; n
/// x n cells.
TriangleMesh spherical_square(double a, int n);
/// z = k (x² - y²) / 2 over [-a, a]²: negative curvature.
TriangleMesh saddle(double k, double a, int n);
/// Part of a torus: major radius R, minor radius r, `around` the axis, the tube from angle p0 to p1 (0 outside, pi
/// inside).
TriangleMesh torus_patch(double R, double r, double around, double p0, double p1, int nu, int nv);

/// The mesh with its vertices renumbered by a seeded shuffle; `order[new] = old`.
TriangleMesh shuffled(const TriangleMesh& mesh, unsigned seed, std::vector<int>* order = nullptr);
/// The mesh rotated and shifted in space.
TriangleMesh moved(const TriangleMesh& mesh);
/// x -> -x with reversed triangles, so that it is still seen from outside.
TriangleMesh mirrored(const TriangleMesh& mesh);
TriangleMesh scaled(const TriangleMesh& mesh, double factor);

struct Shape {
    std::string name;
    TriangleMesh mesh;
};
/// Cylinder, cone, plane, tangent developable: their meshes are exactly developable.
std::vector<Shape> developable_shapes();
/// Slightly and strongly curved tiles, of positive and negative curvature.
std::vector<Shape> curved_shapes();

}  // namespace ripstop::testing
