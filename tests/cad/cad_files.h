#pragma once

#include <string>
#include <vector>

#include "ripstop/geometry/types.h"
#include "ripstop/io/cad/convert.h"
#include "ripstop/model/tile/cad_model.h"

/// CAD files written and measured by Open CASCADE, as a reference for `ripstop-cad`. Only if it is installed.
namespace ripstop::testing {

/// What `ripstop-cad` makes of a file.
CadModel read_cad(const std::string& file, MeshingOptions options = {});

/// The area of all surfaces, in the square of their unit.
double area_of(const CadModel& model);

/// The kernel's figures of a face of a STEP file, in file order.
struct CadFace {
    double area = 0;      ///< [m²]
    double boundary = 0;  ///< length of its edges; an edge that is sewn to itself counts twice [m]
};
struct CadFigures {
    std::vector<CadFace> faces;
    Vec3 low, high;  ///< bounding box of all faces [m]
};
CadFigures step_figures(const std::string& file);

/// The largest distance of the midpoints of triangles and of their edges from the faces of a STEP or IGES file
/// [m]. Both are in millimetres, with surfaces in the order of the faces.
double greatest_distance(const std::string& file, const CadModel& model);

/// Writes a cube of 1 m with one corner at the origin, as .step, .iges or .brep. `unit` as the writers call it:
/// MM, INCH, M. BREP is in millimetres.
void write_cube(const std::string& file, const std::string& unit);

/// Writes an envelope of revolution of `count` gores named `G01`, … on the layer `skin`: 17 m high, 15 m wide,
/// open at the mouth and the crown. Each gore is a separate face with its own edges. STEP in millimetres, or IGES.
void write_gores(const std::string& file, int count);

/// Writes an assembly of two instances of the plate `panel` (2 m x 1 m), one of them rotated by 90 degrees about x
/// and moved by 5 m along y.
void write_assembly(const std::string& file);

/// The same with each part in its own file beside `file`: `panel.stp`.
void write_assembly_of_files(const std::string& file);

/// Closed surfaces as rational NURBS in STEP [mm], around the z axis: a cone (radius 500 at z = 0, apex at z =
/// 900), a sphere of 500, a torus of 500 and 150, a wire (radius 2, 3000 long, with lids), a dozen such tori side
/// by side, and an open needle (radius 60 at z = 0, apex at z = 3000, straight).
enum class Solid { cone, sphere, torus, wire, tori, needle };
void write_solid(const std::string& file, Solid solid);

/// Writes a round tube, 1 m wide, of one face sewn to itself; a line and a point without any face.
void write_tube(const std::string& file);
void write_line(const std::string& file);

/// Writes two plates with a common edge and opposite orientations, as separate faces of one shell, in BREP [mm].
void write_opposed(const std::string& file);

}  // namespace ripstop::testing
