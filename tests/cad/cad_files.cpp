#include "cad/cad_files.h"

#ifdef RIPSTOP_CAD_PROGRAM

#include <BRepAdaptor_Curve.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <GProp_GProps.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <IGESCAFControl_Writer.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Reader.hxx>
#include <Interface_Static.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Reader.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_Reader.hxx>
#include <gp_Ax1.hxx>
#include <gp_Ax3.hxx>
#include <gp_Trsf.hxx>
#include <iostream>
#include <numbers>
#include <sstream>

#include "ripstop/io/mesh/mesh_file.h"

namespace ripstop::testing {
namespace {

/// Silences Open CASCADE, which reports its writing on standard output, among the tests' results.
class Quiet {
  public:
    Quiet() : before_(std::cout.rdbuf(nowhere_.rdbuf())) {}
    ~Quiet() { std::cout.rdbuf(before_); }
    Quiet(const Quiet&) = delete;
    Quiet& operator=(const Quiet&) = delete;

  private:
    std::ostringstream nowhere_;
    std::streambuf* before_;
};

class Document {
  public:
    Document() { XCAFApp_Application::GetApplication()->NewDocument("BinXCAF", document_); }

    Handle(XCAFDoc_ShapeTool) shapes() const { return XCAFDoc_DocumentTool::ShapeTool(document_->Main()); }
    TDF_Label add(const TopoDS_Shape& shape, const std::string& name, const std::string& layer = "") const {
        const TDF_Label label = shapes()->AddShape(shape, false);
        if (!name.empty()) TDataStd_Name::Set(label, name.c_str());
        if (!layer.empty()) XCAFDoc_DocumentTool::LayerTool(document_->Main())->SetLayer(label, layer.c_str());
        return label;
    }
    /// `parts`: writes each part to its own file.
    void write(const std::string& file, const std::string& unit, bool parts = false) const {
        const Quiet quiet;
        if (file.ends_with(".iges")) {
            IGESControl_Controller::Init();
            Interface_Static::SetCVal("write.iges.unit", unit.c_str());
            IGESCAFControl_Writer writer;
            writer.SetNameMode(true);
            writer.SetLayerMode(true);
            writer.Transfer(document_);
            writer.ComputeModel();
            writer.Write(file.c_str());
        } else {
            STEPControl_Controller::Init();
            Interface_Static::SetCVal("write.step.unit", unit.c_str());
            STEPCAFControl_Writer writer;
            writer.SetNameMode(true);
            writer.SetLayerMode(true);
            writer.Transfer(document_, STEPControl_AsIs, parts ? "" : nullptr);
            writer.Write(file.c_str());
        }
    }

  private:
    Handle(TDocStd_Document) document_;
};

TopoDS_Face plate(double x, double y, double width, double height) {
    BRepBuilderAPI_MakePolygon outline({x, y, 0}, {x + width, y, 0}, {x + width, y + height, 0}, {x, y + height, 0},
                                       true);
    return BRepBuilderAPI_MakeFace(outline.Wire());
}

}  // namespace

CadFigures step_figures(const std::string& file) {
    const Quiet quiet;
    STEPControl_Reader reader;
    reader.ReadFile(file.c_str());
    reader.TransferRoots();
    const TopoDS_Shape shape = reader.OneShape();
    CadFigures result;
    for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
        GProp_GProps properties;
        BRepGProp::SurfaceProperties(faces.Current(), properties);
        CadFace face{properties.Mass() * 1e-6, 0};
        for (TopExp_Explorer edges(faces.Current(), TopAbs_EDGE); edges.More(); edges.Next())
            if (!BRep_Tool::Degenerated(TopoDS::Edge(edges.Current())))
                face.boundary += GCPnts_AbscissaPoint::Length(BRepAdaptor_Curve(TopoDS::Edge(edges.Current()))) * 1e-3;
        result.faces.push_back(face);
    }
    Bnd_Box box;
    BRepBndLib::AddOptimal(shape, box, false, false);
    const gp_Pnt low = box.CornerMin(), high = box.CornerMax();
    result.low = Vec3(low.X(), low.Y(), low.Z()) * 1e-3;
    result.high = Vec3(high.X(), high.Y(), high.Z()) * 1e-3;
    return result;
}

double greatest_distance(const std::string& file, const CadModel& model) {
    const Quiet quiet;
    STEPControl_Reader step;
    IGESControl_Reader iges;
    XSControl_Reader& reader = file.ends_with(".iges") ? static_cast<XSControl_Reader&>(iges) : step;
    reader.ReadFile(file.c_str());
    reader.TransferRoots();
    double greatest = 0;
    std::size_t i = 0;
    for (TopExp_Explorer faces(reader.OneShape(), TopAbs_FACE); faces.More(); faces.Next(), ++i) {
        const TriangleMesh& mesh = model.surfaces.at(i).mesh;
        const TopoDS_Face face = TopoDS::Face(faces.Current());
        double u[2], v[2];
        BRepTools::UVBounds(face, u[0], u[1], v[0], v[1]);
        GeomAPI_ProjectPointOnSurf nearest;
        nearest.Init(BRep_Tool::Surface(face), u[0], u[1], v[0], v[1], 1e-6);
        const auto take = [&](const Vec3& p) {
            nearest.Perform({p.x(), p.y(), p.z()});
            if (nearest.NbPoints() > 0) greatest = std::max(greatest, nearest.LowerDistance() * 1e-3);
        };
        for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
            const Vec3 a = mesh.positions.row(mesh.triangles(t, 0)), b = mesh.positions.row(mesh.triangles(t, 1)),
                       c = mesh.positions.row(mesh.triangles(t, 2));
            for (const Vec3& p : {Vec3((a + b) / 2), Vec3((b + c) / 2), Vec3((c + a) / 2), Vec3((a + b + c) / 3)})
                take(p);
        }
    }
    return greatest;
}

void write_cube(const std::string& file, const std::string& unit) {
    const TopoDS_Shape cube = BRepPrimAPI_MakeBox(1000, 1000, 1000).Shape();
    if (file.ends_with(".brep")) {
        BRepTools::Write(cube, file.c_str());
        return;
    }
    Document document;
    document.add(cube, "cube");
    document.write(file, unit);
}

void write_gores(const std::string& file, int count) {
    TColgp_Array1OfPnt points(1, 9);
    const double radii[] = {300, 3200, 5800, 7200, 7500, 6800, 5200, 3400, 1800};
    const double heights[] = {17000, 16400, 14600, 12000, 9500, 6500, 3800, 1700, 0};
    for (int i = 0; i < 9; ++i) points.SetValue(i + 1, gp_Pnt(radii[i], 0, heights[i]));
    const Handle(Geom_BSplineCurve) meridian = GeomAPI_PointsToBSpline(points, 3, 5).Curve();
    Document document;
    for (int i = 0; i < count; ++i) {
        gp_Trsf turn;
        turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, -1)), 2 * std::numbers::pi * i / count);
        const TopoDS_Shape edge =
            BRepBuilderAPI_Transform(BRepBuilderAPI_MakeEdge(meridian).Edge(), turn, true).Shape();
        const TopoDS_Shape gore =
            BRepPrimAPI_MakeRevol(edge, gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, -1)), 2 * std::numbers::pi / count)
                .Shape();
        document.add(gore, (i < 9 ? "G0" : "G") + std::to_string(i + 1), "skin");
    }
    document.write(file, "MM");
}

namespace {

void write_panels(const std::string& file, bool parts) {
    Document document;
    const TDF_Label part = document.add(plate(0, 0, 2000, 1000), "panel");
    const TDF_Label assembly = document.shapes()->NewShape();
    TDataStd_Name::Set(assembly, "envelope");
    document.shapes()->AddComponent(assembly, part, TopLoc_Location());
    gp_Trsf turn, move;
    turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0)), std::numbers::pi / 2);
    move.SetTranslation(gp_Vec(0, 5000, 0));
    document.shapes()->AddComponent(assembly, part, TopLoc_Location(move * turn));
    document.shapes()->UpdateAssemblies();
    document.write(file, "MM", parts);
}

TopoDS_Shape needle() {
    TColgp_Array1OfPnt points(1, 2);
    points.SetValue(1, gp_Pnt(0, 0, 3000));
    points.SetValue(2, gp_Pnt(60, 0, 0));
    const Handle(Geom_Curve) meridian = new Geom_BezierCurve(points);
    return BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeEdge(meridian).Edge(), gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)))
        .Shape();
}

TopoDS_Shape tori() {
    TopoDS_Compound all;
    BRep_Builder builder;
    builder.MakeCompound(all);
    for (int i = 0; i < 12; ++i)
        builder.Add(all, BRepPrimAPI_MakeTorus(gp_Ax2(gp_Pnt(1500 * i, 0, 0), gp_Dir(0, 0, 1)), 500, 150).Shape());
    return all;
}

}  // namespace

void write_assembly(const std::string& file) {
    write_panels(file, false);
}

void write_assembly_of_files(const std::string& file) {
    write_panels(file, true);
}

void write_solid(const std::string& file, Solid solid) {
    TopoDS_Shape shape;
    if (solid == Solid::cone) shape = BRepPrimAPI_MakeCone(500, 0, 900).Shape();
    if (solid == Solid::sphere) shape = BRepPrimAPI_MakeSphere(500).Shape();
    if (solid == Solid::torus) shape = BRepPrimAPI_MakeTorus(500, 150).Shape();
    if (solid == Solid::wire) shape = BRepPrimAPI_MakeCylinder(2, 3000).Shape();
    if (solid == Solid::tori) shape = tori();
    if (solid == Solid::needle) shape = needle();
    Document document;
    document.add(BRepBuilderAPI_NurbsConvert(shape, true).Shape(), "solid");
    document.write(file, "MM");
}

void write_tube(const std::string& file) {
    const Handle(Geom_Surface) surface =
        new Geom_CylindricalSurface(gp_Ax3(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1), gp_Dir(1, 0, 0)), 500);
    Document document;
    document.add(BRepBuilderAPI_MakeFace(surface, 0, 2 * std::numbers::pi, 0, 1000, 1e-6).Face(), "tube");
    document.write(file, "MM");
}

void write_line(const std::string& file) {
    Document document;
    document.add(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(1000, 0, 0)).Edge(), "GRAIN");
    document.write(file, "MM");
}

void write_opposed(const std::string& file) {
    TopoDS_Compound both;
    BRep_Builder builder;
    builder.MakeCompound(both);
    builder.Add(both, plate(0, 0, 2000, 1000));
    builder.Add(both, plate(0, 1000, 1000, 1000).Reversed());
    BRepTools::Write(both, file.c_str());
}

CadModel read_cad(const std::string& file, MeshingOptions options) {
    options.mesher = RIPSTOP_CAD_PROGRAM;
    return read_model(file, options);
}

double area_of(const CadModel& model) {
    double sum = 0;
    for (const NamedMesh& surface : model.surfaces) sum += surface_area(surface.mesh);
    return sum;
}

}  // namespace ripstop::testing

#endif
