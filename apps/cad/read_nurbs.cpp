#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <ShapeFix_Face.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <fstream>
#include <nlohmann/json.hpp>

#include "drawing.h"
#include "ripstop/base/error.h"

namespace ripstop::cad {
namespace {

using nlohmann::json;

struct Knots {
    TColStd_Array1OfReal values;
    TColStd_Array1OfInteger multiplicities;
};

/// openNURBS omits the first and the last knot, which repeat their neighbours.
Knots knots_of(const json& list) {
    std::vector<double> all = list.get<std::vector<double>>();
    if (all.size() < 2) throw InputError("a NURBS has fewer than two knots");
    all.insert(all.begin(), all.front());
    all.push_back(all.back());
    std::vector<double> values;
    std::vector<int> multiplicities;
    for (const double knot : all) {
        if (!values.empty() && knot == values.back()) {
            ++multiplicities.back();
        } else {
            values.push_back(knot);
            multiplicities.push_back(1);
        }
    }
    const int count = static_cast<int>(values.size());
    Knots result{TColStd_Array1OfReal(1, count), TColStd_Array1OfInteger(1, count)};
    for (int i = 0; i < count; ++i) {
        result.values.SetValue(i + 1, values[static_cast<std::size_t>(i)]);
        result.multiplicities.SetValue(i + 1, multiplicities[static_cast<std::size_t>(i)]);
    }
    return result;
}

gp_Pnt point_at(const json& p, double scale) {
    return {p.at(0).get<double>() * scale, p.at(1).get<double>() * scale, p.at(2).get<double>() * scale};
}

Handle(Geom_BSplineCurve) curve_of(const json& entry, double scale) {
    const json& points = entry.at("points");
    const int count = static_cast<int>(points.size());
    TColgp_Array1OfPnt poles(1, count);
    TColStd_Array1OfReal weights(1, count);
    for (int i = 0; i < count; ++i) {
        poles.SetValue(i + 1, point_at(points[static_cast<std::size_t>(i)], scale));
        weights.SetValue(i + 1, points[static_cast<std::size_t>(i)].at(3).get<double>());
    }
    const Knots knots = knots_of(entry.at("knots"));
    return new Geom_BSplineCurve(poles, weights, knots.values, knots.multiplicities, entry.at("degree").get<int>());
}

Handle(Geom_BSplineSurface) surface_of(const json& entry, double scale) {
    const int rows = entry.at("count_u").get<int>(), columns = entry.at("count_v").get<int>();
    const json& points = entry.at("points");
    if (rows < 2 || columns < 2 || points.size() != static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns))
        throw InputError("a NURBS surface does not have the number of points that it states");
    TColgp_Array2OfPnt poles(1, rows, 1, columns);
    TColStd_Array2OfReal weights(1, rows, 1, columns);
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
            const json& p = points[static_cast<std::size_t>(i * columns + j)];
            poles.SetValue(i + 1, j + 1, point_at(p, scale));
            weights.SetValue(i + 1, j + 1, p.at(3).get<double>());
        }
    const Knots u = knots_of(entry.at("knots_u")), v = knots_of(entry.at("knots_v"));
    return new Geom_BSplineSurface(poles, weights, u.values, v.values, u.multiplicities, v.multiplicities,
                                   entry.at("degree_u").get<int>(), entry.at("degree_v").get<int>());
}

/// Builds a Brep; edges that faces share are made once.
class Brep {
  public:
    Brep(const json& entry, double scale) : entry_(entry), scale_(scale) {
        for (const json& edge : entry.at("edges")) {
            const Handle(Geom_BSplineCurve) curve = curve_of(edge, scale);
            const gp_Pnt a = curve->StartPoint(), b = curve->EndPoint();
            const TopoDS_Vertex from = vertex(edge.at("from").get<int>(), a), to = vertex(edge.at("to").get<int>(), b);
            BRepBuilderAPI_MakeEdge make(curve, from, to, curve->FirstParameter(), curve->LastParameter());
            edges_.push_back(make.IsDone() ? make.Edge() : TopoDS_Edge());
        }
    }

    TopoDS_Face face(const json& face) const {
        const Handle(Geom_BSplineSurface) surface = surface_of(face.at("surface"), scale_);
        TopoDS_Face bare;
        BRep_Builder builder;
        builder.MakeFace(bare, surface, 1e-3);
        for (const json& loop : face.at("loops")) {
            TopoDS_Wire wire;
            builder.MakeWire(wire);
            for (const json& trim : loop) {
                const int index = trim.at("edge").get<int>();
                if (index < 0) continue;  // at a point to which the surface contracts
                const TopoDS_Edge edge = edges_.at(static_cast<std::size_t>(index));
                if (edge.IsNull()) return {};
                builder.Add(wire, trim.at("reversed").get<bool>() ? TopoDS::Edge(edge.Reversed()) : edge);
            }
            builder.Add(bare, wire);
        }
        ShapeFix_Face fix(bare);
        fix.FixAddNaturalBoundMode() = 0;
        fix.FixSmallAreaWireMode() = 0;
        fix.Perform();
        fix.FixOrientation();
        TopoDS_Face result = fix.Face();
        if (result.IsNull() || !BRepCheck_Analyzer(result).IsValid()) return {};
        if (face.at("reversed").get<bool>()) result.Reverse();
        return result;
    }

  private:
    TopoDS_Vertex vertex(int number, const gp_Pnt& at) {
        BRep_Builder builder;
        TopoDS_Vertex& known = vertices_[number];
        if (known.IsNull()) builder.MakeVertex(known, at, 1e-5);
        const double away = BRep_Tool::Pnt(known).Distance(at);
        if (away > BRep_Tool::Tolerance(known)) builder.UpdateVertex(known, away * 1.01);
        return known;
    }

    const json& entry_;
    double scale_;
    std::map<int, TopoDS_Vertex> vertices_;
    std::vector<TopoDS_Edge> edges_;
};

TopoDS_Face face_of(const Brep& brep, const json& face) {
    try {
        return brep.face(face);
    } catch (const Standard_Failure&) {  // the kernel refuses it: its stored mesh is used, or it is listed as unread
        return {};
    }
}

/// Rhino stores one mesh for all faces of an extrusion. The faces replace it if they have its area.
void take_faces_of_one_mesh(std::vector<DrawnFace> faces, double millimetres, DrawnObject& object) {
    double area = 0;
    for (const DrawnFace& face : faces) {
        if (face.shape.IsNull()) return;
        GProp_GProps properties;
        BRepGProp::SurfaceProperties(face.shape, properties, area_precision);
        area += std::abs(properties.Mass()) / (millimetres * millimetres);
    }
    const double stored = surface_area(object.faces.front().stored.mesh);
    if (stored == 0 || std::abs(area / stored - 1) <= area_agreement) object.faces = std::move(faces);
}

void add_shapes(const json& entry, double millimetres, DrawnObject& object) {
    if (!entry.contains("brep") || entry["brep"].is_null()) return;
    try {
        const Brep brep(entry["brep"], millimetres);
        const json& faces = entry["brep"].at("faces");
        if (object.faces.size() == faces.size()) {
            for (std::size_t f = 0; f < faces.size(); ++f) object.faces[f].shape = face_of(brep, faces[f]);
        } else if (object.faces.size() == 1) {
            std::vector<DrawnFace> drawn;
            for (const json& face : faces) drawn.push_back({.shape = face_of(brep, face)});
            take_faces_of_one_mesh(std::move(drawn), millimetres, object);
        }
    } catch (const Standard_Failure&) {  // as for a single face
    }
}

}  // namespace

Drawing read_nurbs(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) throw InputError(file.string() + ": the file cannot be opened");
    std::string line;
    std::getline(in, line);
    in.seekg(0);
    ConvertedModel model = read_converted(in, file.string());
    const json header = json::parse(line);
    Drawing drawing;
    if (model.unit) drawing.millimetres = model.unit->metres / 0.001;
    for (std::size_t o = 0; o < model.objects.size(); ++o) {
        DrawnObject object{model.objects[o].name, model.objects[o].type, model.objects[o].attributes, {}};
        for (ConvertedFace& face : model.objects[o].faces)
            object.faces.push_back({.name = face.name, .attributes = face.attributes, .shape = {}, .stored = face});
        add_shapes(header["objects"][o], drawing.millimetres, object);
        drawing.objects.push_back(std::move(object));
    }
    model.objects.clear();
    drawing.rest = std::move(model);
    return drawing;
}

}  // namespace ripstop::cad
