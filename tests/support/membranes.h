#pragma once

#include <functional>
#include <vector>

#include "ripstop/inflate/equilibrium.h"
#include "support/shapes.h"

/// Cloth under gas with known shapes: meshes with n subdivisions per side, their supports, and figures from the
/// literature. Used by the tests and by the table of docs/methods/inflation.md.
namespace ripstop::testing {

/// The same stiffness E h in both directions, without weight.
Fabric isotropic(double stiffness, double poisson);

/// One skin of one cloth without seams and supports, cut like `cut` (default: as it lies), with gas on its inner
/// side.
SewnEnvelope skin(const TriangleMesh& mesh, const Fabric& fabric, const Points2& cut = {});
/// Sets the freedom of each node by its place.
void hold(SewnEnvelope& sewn, const std::function<Freedom(const Vec3&)>& freedom);

/// The quarter x, y >= 0 of the unit disk in n rings: row i has i + 1 points, with its ends on the axes.
TriangleMesh quarter_disk(int n);

/// A skin in equilibrium under a gas.
struct AtRest {
    SewnEnvelope sewn;
    Equilibrium found;
    double volume = 0;  ///< above z = 0, of the modelled part [m³]
    /// Green strain and second Piola-Kirchhoff stress of a triangle, without residual stiffness.
    Vec3 strain(int triangle) const;
    Vec3 stress(int triangle) const;
};
AtRest at_rest(SewnEnvelope sewn, const Points3& start, const GasPressure& gas, std::vector<double> residuals,
               double tolerance = 1e-6);

/// The stretch of a sphere of radius 1 m, E h = 10 kN/m, nu 0.3, under 200 Pa; n*n triangles, an eighth of it.
/// Exact, with stretch l: E h / (1 - nu) (l^2 - 1) / 2 = p R l / 2.
double sphere_stretch(int n);
inline constexpr double sphere_stretch_exact = 1.00702450;

/// A cylinder of radius 1 m and fixed length, warp around it, under 1200 Pa; a quarter of it, of n flat strips.
/// Exact: S11 = p R, l = sqrt(1 + 2 p R / c11).
struct Cylinder {
    double stretch = 0;  ///< radius relative to the radius at rest
    double hoop = 0;     ///< S11 [N/m]
};
Cylinder cylinder_under_gas(int n);
/// The cylinder's fabric: 60 and 50 kN/m, nu 0.2, 1.5 kN/m.
Fabric balloon_nylon();

/// A disk clamped at its edge (Hencky 1915), p a = 1e-5 E h; n*n triangles, a quarter of it.
struct Disk {
    double height = 0;            ///< w0 / a (p a / E h)^(-1/3)
    double centre = 0, edge = 0;  ///< radial tension there, over (E h p^2 a^2)^(1/3)
};
Disk clamped_disk(double poisson, int n);
/// Hencky's problem solved by shooting.
struct HenckyRow {
    double poisson, height, centre, edge;
};
inline constexpr HenckyRow hencky[] = {{0, .71832, .40510, .28937},
                                       {.2, .67744, .42068, .31611},
                                       {.3, .65344, .43110, .33296},
                                       {.4, .62626, .44422, .35323},
                                       {.5, .59488, .46133, .37841}};

/// Two unit disks of nearly inextensible cloth (E h = 1000 p a), sewn together at their edges (Paulsen 1994); n*n
/// triangles, an eighth. Inflated radius, half the thickness, volume.
struct Mylar {
    double radius = 0, half = 0, volume = 0;
};
Mylar mylar_balloon(int n, double residual = 1e-5);
inline constexpr Mylar mylar_exact = {.7627597635, .4569465811, 1.2185242161};

/// Two square sheets with a diagonal of 1.2 m sewn together at their edges, E h = 352.8 kN/m, nu 0.4, under 5 kPa;
/// n*n cells, an eighth.
struct Airbag {
    double height = 0;   ///< of the middle above the plane of the edges [m]
    double corner = 0;   ///< inward motion of a corner [m]
    double volume = 0;   ///< divided by the side cubed
    double tension = 0;  ///< in the middle [N/m]
};
Airbag square_airbag(int n, double residual = 1e-4);

}  // namespace ripstop::testing
