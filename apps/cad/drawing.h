#pragma once

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ripstop/io/cad/converted.h"

/// ripstop-cad turns exact surfaces into meshes. It works in millimetres, the unit of its geometry kernel.
namespace ripstop::cad {

/// Largest relative difference between the area of a face rebuilt from NURBS and that of the mesh its CAD stored.
inline constexpr double area_agreement = 0.03;

/// Relative precision of areas. By default the kernel integrates a rational surface with few points and is 0.2 %
/// off on a sphere.
inline constexpr double area_precision = 1e-5;

struct DrawnFace {
    std::string name = {};
    Attributes attributes = {};
    TopoDS_Face shape;          ///< in the object's place, oriented as in the file; null: only `stored` is known
    ConvertedFace stored = {};  ///< the mesh that the CAD stored [file's unit]; without triangles if it stored none
};

struct DrawnObject {
    std::string name = {}, type = {};
    Attributes attributes = {};
    std::vector<DrawnFace> faces = {};
};

/// The contents of a file before meshing.
struct Drawing {
    std::vector<DrawnObject> objects;
    ConvertedModel rest;     ///< everything but the objects
    double millimetres = 1;  ///< per unit of the file; 1 if it states none
};

/// How STEP and IGES files are read: with names, layers and colours; or the shapes alone, if the kernel crashes on
/// the rest, which a remark then says.
enum class Reading { with_names, plain };

/// Reads a file by its extension: .step .stp .iges .igs .brep .brp, or .converted, whose objects have NURBS faces
/// and stored meshes. Throws InputError.
Drawing read_drawing(const std::filesystem::path& file, Reading reading = Reading::with_names);

/// True if `reading` makes a difference for the file.
bool has_names(const std::filesystem::path& file);

/// The parts of `read_drawing`.
Drawing read_step(const std::filesystem::path& file, Reading reading);
Drawing read_iges(const std::filesystem::path& file, Reading reading);
Drawing read_brep(const std::filesystem::path& file);
Drawing read_nurbs(const std::filesystem::path& file);

/// Throw InputError unless a file begins and ends as its format requires, because the kernels crash on truncated
/// files or take them for complete. The one for IGES also refuses numbers that cannot be coordinates.
void require_whole_step(const std::filesystem::path& file);
void require_whole_iges(const std::filesystem::path& file);
void require_whole_brep(const std::filesystem::path& file);

/// Upper bound of coordinates [mm]: the kernels hang on numbers that are not finite or too large.
inline constexpr double largest_coordinate = 1e12;

/// The message about a coordinate beyond it.
std::string unbearable(const std::string& place, const std::string& number);

/// Throws InputError if a vertex or pole of a shape is beyond it; `place` names the shape.
void require_coordinates(const TopoDS_Shape& shape, const std::string& place);

/// Adds the edges of a shape without faces as polylines. Lists its free points as left out.
void add_wires(const TopoDS_Shape& shape, const std::string& name, const Attributes& attributes, Drawing& drawing);

/// Adds everything in a shape without names; nothing for a null shape. `place` names it in messages.
void add_shape(const TopoDS_Shape& shape, const std::string& place, Drawing& drawing);

/// The solids, shells and faces of a shape, each as an object.
struct Part {
    TopoDS_Shape shape;
    std::string type;
};
std::vector<Part> parts_of(const TopoDS_Shape& shape);
std::vector<TopoDS_Face> faces_of(const TopoDS_Shape& shape);

}  // namespace ripstop::cad
