#pragma once

#include <string>
#include <vector>

#include "ripstop/geometry/types.h"
#include "ripstop/model/tile/cad_model.h"

/// CAD files written and measured by Open CASCADE, for what `ripstop-cad` makes of them. Only where it is installed.
namespace ripstop::testing {

/// What a kernel says of the faces of a STEP file, in its order.
struct CadFace {
    double area = 0;      ///< [m²]
    double boundary = 0;  ///< length of its edges, an edge sewn to itself counted twice [m]
};
struct CadFigures {
    std::vector<CadFace> faces;
    Vec3 low, high;  ///< the box around all [m]
};
CadFigures step_figures(const std::string& file);

/// How far the triangles' middles and those of their edges lie off the faces of a STEP or IGES file at most [m]; both
/// in millimetres, the surfaces in the order of the faces.
double greatest_distance(const std::string& file, const CadModel& model);

/// A cube of 1 m with one corner in the origin, as .step, .iges or .brep; `unit` as the writers call it: MM, INCH, M.
/// BREP is in millimetres.
void write_cube(const std::string& file, const std::string& unit);

/// An envelope of revolution of this many gores named `G01`, … on the layer `skin`: 17 m high, 15 m wide, open at the
/// mouth and the crown. Each gore is a face by itself with edges of its own. STEP in millimetres, or IGES.
void write_gores(const std::string& file, int count);

/// Two of the same plate `panel` (2 m x 1 m), one of them turned by 90 degrees about x and moved by 5 m along y, in an
/// assembly.
void write_assembly(const std::string& file);

/// The same with each part in a file of its own beside `file`: `panel.stp`.
void write_assembly_of_files(const std::string& file);

/// Closed surfaces as NURBS that are rational, in STEP [mm], around the z axis: a cone (radius 500 in z = 0, its point
/// in z = 900), a sphere of 500, a torus of 500 and 150, a wire (radius 2, 3000 long, with lids), a dozen such tori
/// side by side, and an open needle (radius 60 in z = 0, its point in z = 3000, straight).
enum class Solid { cone, sphere, torus, wire, tori, needle };
void write_solid(const std::string& file, Solid solid);

/// A round tube, 1 m wide, of one face sewn to itself; a line and a point without any face.
void write_tube(const std::string& file);
void write_line(const std::string& file);

/// Two plates with a common edge that face opposite ways, as one shell's faces left apart, in BREP [mm].
void write_opposed(const std::string& file);

}  // namespace ripstop::testing
