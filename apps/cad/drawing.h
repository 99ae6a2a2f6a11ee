#pragma once

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ripstop/io/cad/converted.h"

/// ripstop-cad: exact surfaces in, meshes out. It works in millimetres, the unit of its geometry kernel.
namespace ripstop::cad {

/// How far the area of a face rebuilt from NURBS may be from that of the mesh its CAD had stored.
inline constexpr double area_agreement = 0.03;

/// Relative; without it the kernel integrates a rational surface by a few points, and is 0.2 % off on a sphere.
inline constexpr double area_precision = 1e-5;

struct DrawnFace {
    std::string name = {};
    Attributes attributes = {};
    TopoDS_Face shape;          ///< where the object stands, oriented as in the file; null: only `stored` is known
    ConvertedFace stored = {};  ///< as the CAD had meshed it [file's unit]; without triangles: it had not
};

struct DrawnObject {
    std::string name = {}, type = {};
    Attributes attributes = {};
    std::vector<DrawnFace> faces = {};
};

/// What a file holds before it is meshed.
struct Drawing {
    std::vector<DrawnObject> objects;
    ConvertedModel rest;     ///< all but the objects
    double millimetres = 1;  ///< in one unit of the file; 1 where it says none
};

/// How STEP and IGES are read: with the names, layers and colours in them, or the shapes alone, where the kernel
/// breaks down on
/// the rest; a remark says so then.
enum class Reading { with_names, plain };

/// Reads a file by its extension: .step .stp .iges .igs .brep .brp, or .converted, whose objects carry NURBS faces beside
/// their stored meshes. Throws InputError.
Drawing read_drawing(const std::filesystem::path& file, Reading reading = Reading::with_names);

/// Whether `reading` matters to a file.
bool has_names(const std::filesystem::path& file);

/// The parts of `read_drawing`.
Drawing read_step(const std::filesystem::path& file, Reading reading);
Drawing read_iges(const std::filesystem::path& file, Reading reading);
Drawing read_brep(const std::filesystem::path& file);
Drawing read_nurbs(const std::filesystem::path& file);

/// Throw InputError where a file does not begin and end as its format has it: the kernels crash on files cut short, or read
/// what is there as the whole. That of IGES names numbers that are no coordinates, too.
void require_whole_step(const std::filesystem::path& file);
void require_whole_iges(const std::filesystem::path& file);
void require_whole_brep(const std::filesystem::path& file);

/// No coordinate reaches it [mm]: the kernels never end on what is not finite or is far off.
inline constexpr double largest_coordinate = 1e12;

/// The sentence on one that does.
std::string unbearable(const std::string& place, const std::string& number);

/// Throws InputError where a vertex or pole of a shape is beyond it; `place` says whose.
void require_coordinates(const TopoDS_Shape& shape, const std::string& place);

/// The edges of a shape without faces as polylines; its free points are named as left out.
void add_wires(const TopoDS_Shape& shape, const std::string& name, const Attributes& attributes, Drawing& drawing);

/// All of a shape without names; a null shape adds nothing. `place` names it in messages.
void add_shape(const TopoDS_Shape& shape, const std::string& place, Drawing& drawing);

/// Solids, shells and faces of a shape, each an object.
struct Part {
    TopoDS_Shape shape;
    std::string type;
};
std::vector<Part> parts_of(const TopoDS_Shape& shape);
std::vector<TopoDS_Face> faces_of(const TopoDS_Shape& shape);

}  // namespace ripstop::cad
