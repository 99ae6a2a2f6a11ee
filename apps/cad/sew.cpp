#include <BRepBuilderAPI_Sewing.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Wire.hxx>

#include "meshing.h"

namespace ripstop::cad {

std::vector<TopoDS_Face> sewn(const std::vector<TopoDS_Face>& faces, double tolerance) {
    // Non-manifold, because a baffle is sewn to two tiles along one edge.
    BRepBuilderAPI_Sewing sewing(tolerance, true, true, true, true);
    for (const TopoDS_Face& face : faces)
        if (!face.IsNull()) sewing.Add(face);
    sewing.Perform();
    std::vector<TopoDS_Face> result;
    for (const TopoDS_Face& face : faces) {
        TopoDS_Shape now = face;
        if (!face.IsNull() && sewing.IsModified(face)) now = sewing.Modified(face);
        if (!now.IsNull() && sewing.IsModifiedSubShape(now)) now = sewing.ModifiedSubShape(now);
        TopExp_Explorer first;
        if (!now.IsNull()) first.Init(now, TopAbs_FACE);
        result.push_back(first.More() ? TopoDS::Face(first.Current()) : TopoDS_Face());
    }
    return result;
}

}  // namespace ripstop::cad
