#include <BRepAdaptor_Curve.hxx>
#include <BRepTools.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_TangentialDeflection.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <cmath>

#include "drawing.h"
#include "ripstop/base/error.h"
#include "ripstop/base/text/number_text.h"

namespace ripstop::cad {
namespace {

constexpr double curve_turn = 0.02;  // [rad] between the points of a polyline

void add_points(const TopoDS_Edge& edge, std::vector<Vec3>& points) {
    if (BRep_Tool::Degenerated(edge)) return;
    const BRepAdaptor_Curve curve(edge);
    const GCPnts_TangentialDeflection samples(curve, curve_turn, 1e6, 2);
    const int count = samples.NbPoints();
    const bool turned = edge.Orientation() == TopAbs_REVERSED;
    for (int i = 1; i <= count; ++i) {
        const gp_Pnt p = samples.Value(turned ? count + 1 - i : i);
        const Vec3 point(p.X(), p.Y(), p.Z());
        if (points.empty() || (points.back() - point).norm() > 1e-9) points.push_back(point);
    }
}

void add_curve(const std::vector<Vec3>& points, const std::string& name, const Attributes& attributes,
               Drawing& drawing) {
    if (points.size() < 2) return;
    NamedCurve curve{name, Points3(static_cast<Eigen::Index>(points.size()), 3), attributes};
    for (std::size_t i = 0; i < points.size(); ++i)
        curve.points.row(static_cast<Eigen::Index>(i)) = points[i] / drawing.millimetres;
    drawing.rest.curves.push_back(std::move(curve));
}

void require_point(const gp_Pnt& p, const std::string& place) {
    for (const double number : {p.X(), p.Y(), p.Z()})
        if (!(std::abs(number) < largest_coordinate)) throw InputError(unbearable(place, format_shortest(number)));
}

}  // namespace

void add_wires(const TopoDS_Shape& shape, const std::string& name, const Attributes& attributes, Drawing& drawing) {
    for (TopExp_Explorer wires(shape, TopAbs_WIRE); wires.More(); wires.Next()) {
        std::vector<Vec3> points;
        for (BRepTools_WireExplorer edges(TopoDS::Wire(wires.Current())); edges.More(); edges.Next())
            add_points(edges.Current(), points);
        add_curve(points, name, attributes, drawing);
    }
    for (TopExp_Explorer edges(shape, TopAbs_EDGE, TopAbs_WIRE); edges.More(); edges.Next()) {
        std::vector<Vec3> points;
        add_points(TopoDS::Edge(edges.Current()), points);
        add_curve(points, name, attributes, drawing);
    }
    if (TopExp_Explorer(shape, TopAbs_VERTEX, TopAbs_EDGE).More())
        drawing.rest.unread.push_back({name, "Point", "points are not a surface", attributes});
}

void require_coordinates(const TopoDS_Shape& shape, const std::string& place) {
    for (TopExp_Explorer vertices(shape, TopAbs_VERTEX); vertices.More(); vertices.Next())
        require_point(BRep_Tool::Pnt(TopoDS::Vertex(vertices.Current())), place);
    for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
        const Handle(Geom_BSplineSurface) surface =
            Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(TopoDS::Face(faces.Current())));
        if (surface.IsNull()) continue;
        for (int i = 1; i <= surface->NbUPoles(); ++i)
            for (int j = 1; j <= surface->NbVPoles(); ++j) require_point(surface->Pole(i, j), place);
    }
}

std::vector<TopoDS_Face> faces_of(const TopoDS_Shape& shape) {
    std::vector<TopoDS_Face> faces;
    for (TopExp_Explorer explorer(shape, TopAbs_FACE); explorer.More(); explorer.Next())
        faces.push_back(TopoDS::Face(explorer.Current()));
    return faces;
}

std::vector<Part> parts_of(const TopoDS_Shape& shape) {
    std::vector<Part> parts;
    for (TopExp_Explorer solids(shape, TopAbs_SOLID); solids.More(); solids.Next())
        parts.push_back({solids.Current(), "Solid"});
    for (TopExp_Explorer shells(shape, TopAbs_SHELL, TopAbs_SOLID); shells.More(); shells.Next())
        parts.push_back({shells.Current(), "Shell"});
    for (TopExp_Explorer faces(shape, TopAbs_FACE, TopAbs_SHELL); faces.More(); faces.Next())
        parts.push_back({faces.Current(), "Face"});
    return parts;
}

void add_shape(const TopoDS_Shape& shape, const std::string& place, Drawing& drawing) {
    if (shape.IsNull()) return;
    require_coordinates(shape, place);
    for (const Part& part : parts_of(shape)) {
        DrawnObject object{.type = part.type};
        for (const TopoDS_Face& face : faces_of(part.shape)) object.faces.push_back({.shape = face});
        drawing.objects.push_back(std::move(object));
    }
    if (drawing.objects.empty()) add_wires(shape, "", {}, drawing);
}

Drawing read_brep(const std::filesystem::path& file) {
    require_whole_brep(file);
    TopoDS_Shape shape;
    try {
        BRepTools::Read(shape, file.c_str(), BRep_Builder());
    } catch (const Standard_Failure&) {  // reported below
    }
    if (shape.IsNull())
        throw InputError(file.string() + ": not a whole BREP file of Open CASCADE; write it again, or export STEP");
    Drawing drawing;
    add_shape(shape, file.string(), drawing);
    return drawing;
}

namespace {

std::string lower_extension(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return extension;
}

}  // namespace

bool has_names(const std::filesystem::path& file) {
    const std::string extension = lower_extension(file);
    return extension == ".step" || extension == ".stp" || extension == ".iges" || extension == ".igs";
}

Drawing read_drawing(const std::filesystem::path& file, Reading reading) {
    const std::string extension = lower_extension(file);
    if (extension == ".step" || extension == ".stp") return read_step(file, reading);
    if (extension == ".iges" || extension == ".igs") return read_iges(file, reading);
    if (extension == ".brep" || extension == ".brp") return read_brep(file);
    return read_nurbs(file);
}

}  // namespace ripstop::cad
