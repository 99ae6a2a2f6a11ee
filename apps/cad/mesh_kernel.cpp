#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "face_sizes.h"

namespace ripstop::cad {
namespace {

/// Numbers vertices; those in one place get one number. The kernel divides each edge once and gives its points to
/// both faces.
class Numbering {
  public:
    int of(const gp_Pnt& p) {
        const auto [found, fresh] = number_.try_emplace({p.X(), p.Y(), p.Z()}, static_cast<int>(points_.size()));
        if (fresh) points_.emplace_back(p.X(), p.Y(), p.Z());
        return found->second;
    }
    Points3 positions() const {
        Points3 result(static_cast<Eigen::Index>(points_.size()), 3);
        for (std::size_t i = 0; i < points_.size(); ++i) result.row(static_cast<Eigen::Index>(i)) = points_[i];
        return result;
    }

  private:
    std::map<std::array<double, 3>, int> number_;
    std::vector<Vec3> points_;
};

/// Its time per triangle grows with their number.
constexpr double most_for_gmsh = 50000;
constexpr double coarsest = 8;  // coarsest factor that is tried with the kernel's mesher

Triangles triangles_of(const TopoDS_Face& face, Numbering& numbering) {
    TopLoc_Location place;
    const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face, place);
    if (mesh.IsNull()) return Triangles(0, 3);
    std::vector<std::array<int, 3>> kept;
    for (int t = 1; t <= mesh->NbTriangles(); ++t) {
        std::array<int, 3> corners{};
        for (int k = 0; k < 3; ++k)
            corners[static_cast<std::size_t>(k)] =
                numbering.of(mesh->Node(mesh->Triangle(t).Value(k + 1)).Transformed(place.Transformation()));
        if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0]) kept.push_back(corners);
    }
    Triangles triangles(static_cast<Eigen::Index>(kept.size()), 3);
    for (std::size_t t = 0; t < kept.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            triangles(static_cast<Eigen::Index>(t), static_cast<Eigen::Index>(k)) = kept[t][k];
    return triangles;
}

/// True if gmsh may refine the face without end.
bool is_hard(const TopoDS_Face& face) {
    return !face.IsNull() && comes_together(face);
}

IMeshTools_Parameters parameters_of(const EdgeSizes& sizes, double coarser) {
    IMeshTools_Parameters parameters;
    const double finer = finest(sizes) * coarser;
    parameters.Angle = std::min(sizes.turn * coarser, 0.5);
    parameters.Deflection = std::min(sizes.chord_error, sizes.longest / 8) * finer * finer;
    parameters.MinSize = sizes.shortest * finer;
    return parameters;
}

double triangles_in(const TopoDS_Shape& shape) {
    double sum = 0;
    for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
        TopLoc_Location place;
        const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(TopoDS::Face(faces.Current()), place);
        if (!mesh.IsNull()) sum += mesh->NbTriangles();
    }
    return sum;
}

/// True if no face has more triangles than allowed.
bool is_within(const Meshes& meshes, const EdgeSizes& sizes) {
    for (const Triangles& triangles : meshes.faces)
        if (!sizes.most.empty() && static_cast<double>(triangles.rows()) > most_of_face) return false;
    return true;
}

}  // namespace

Meshes meshed_by_kernel(const std::vector<TopoDS_Face>& faces, const EdgeSizes& sizes) {
    TopoDS_Compound all;
    BRep_Builder builder;
    builder.MakeCompound(all);
    for (const TopoDS_Face& face : faces)
        if (!face.IsNull()) builder.Add(all, face);
    for (double coarser = 1; coarser <= coarsest; coarser *= 2) {
        BRepTools::Clean(all);
        BRepMesh_IncrementalMesh(all, parameters_of(sizes, coarser));
        if (sizes.most.empty() || triangles_in(all) <= most_of_all) break;
    }
    Meshes result;
    result.plain = true;
    Numbering numbering;
    for (const TopoDS_Face& face : faces)
        result.faces.push_back(face.IsNull() ? Triangles(0, 3) : triangles_of(face, numbering));
    result.positions = numbering.positions();
    return result;
}

Meshes meshed(const std::vector<TopoDS_Face>& faces, const EdgeSizes& sizes, double triangles, const Told& told) {
    const bool easy = triangles < most_for_gmsh && std::none_of(faces.begin(), faces.end(), is_hard);
    if (easy)
        if (std::optional<Meshes> meshes = meshed_by_gmsh(faces, sizes, triangles, told);
            meshes && is_within(*meshes, sizes))
            return *meshes;
    if (std::optional<Meshes> meshes = meshed_in_parameters(faces, sizes, told)) return *meshes;
    if (!easy)
        if (std::optional<Meshes> meshes = meshed_by_gmsh(faces, sizes, triangles, told)) return *meshes;
    return meshed_by_kernel(faces, sizes);
}

}  // namespace ripstop::cad
