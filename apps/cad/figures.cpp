#include <BRepAdaptor_Curve.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <GCPnts_AbscissaPoint.hxx>
#include <GProp_GProps.hxx>
#include <Geom_Surface.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "meshing.h"

namespace ripstop::cad {
namespace {

constexpr Eigen::Index samples = 80;

/// The exact length of the face's border. Nothing if one of its edges is sewn to itself, because that is no edge
/// of the mesh.
std::optional<double> exact_boundary(const TopoDS_Face& face) {
    double length = 0;
    for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next()) {
        const TopoDS_Edge edge = TopoDS::Edge(edges.Current());
        if (BRep_Tool::Degenerated(edge)) continue;
        if (BRep_Tool::IsClosed(edge, face)) return {};
        length += GCPnts_AbscissaPoint::Length(BRepAdaptor_Curve(edge));
    }
    return length;
}

double mesh_boundary(const Points3& positions, const Triangles& triangles) {
    std::set<std::pair<int, int>> open;
    for (Eigen::Index t = 0; t < triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k) {
            const std::pair<int, int> edge(triangles(t, k), triangles(t, (k + 1) % 3));
            if (open.erase({edge.second, edge.first}) == 0) open.insert(edge);
        }
    double length = 0;
    for (const auto& [a, b] : open) length += (positions.row(a) - positions.row(b)).norm();
    return length;
}

gp_Pnt point(const Vec3& p) {
    return {p[0], p[1], p[2]};
}

/// The distance of a surface from points that follow each other closely.
class Distances {
  public:
    explicit Distances(const Handle(Geom_Surface) & surface) : analysis_(surface) {}

    double to(const Vec3& p) {
        last_ = known_ ? analysis_.NextValueOfUV(last_, point(p), precision) : analysis_.ValueOfUV(point(p), precision);
        known_ = true;
        return analysis_.Gap();
    }
    /// The distance from p. A search that starts at the last point may find only a local minimum, so distances
    /// above `borne` are searched again.
    double surely_to(const Vec3& p, double borne) {
        const double near = to(p);
        if (near <= borne) return near;
        known_ = false;
        return std::min(near, to(p));
    }
    gp_Pnt2d place() const { return last_; }

  private:
    static constexpr double precision = 1e-6;
    ShapeAnalysis_Surface analysis_;
    gp_Pnt2d last_;
    bool known_ = false;
};

}  // namespace

FaceFigures figures_of(const TopoDS_Face& face, const Points3& positions, const Triangles& triangles,
                       std::optional<double> asked) {
    FaceFigures figures;
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(face, properties, area_precision);
    figures.area = std::abs(properties.Mass());
    if (const std::optional<double> length = exact_boundary(face); length && *length > 0)
        figures.shortfall = 1 - mesh_boundary(positions, triangles) / *length;
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
    Distances distances(surface);
    double with = 0, against = 0;
    const Eigen::Index step = asked ? 1 : std::max<Eigen::Index>(1, triangles.rows() / samples);
    for (Eigen::Index t = 0; t < triangles.rows(); t += step) {
        const Vec3 a = positions.row(triangles(t, 0)), b = positions.row(triangles(t, 1)),
                   c = positions.row(triangles(t, 2));
        double& error = figures.chord_error;
        if (asked)
            for (const Vec3& middle : {Vec3((a + b) / 2), Vec3((b + c) / 2), Vec3((c + a) / 2)})
                error = std::max(error, distances.surely_to(middle, std::max(error, *asked)));
        error = std::max(error, distances.surely_to((a + b + c) / 3, std::max(error, asked.value_or(0))));
        const gp_Pnt2d uv = distances.place();
        gp_Pnt on;
        gp_Vec du, dv;
        surface->D1(uv.X(), uv.Y(), on, du, dv);
        const gp_Vec outward = du.Crossed(dv);
        const Vec3 area = (b - a).cross(c - a);
        if (outward.Magnitude() < 1e-12) continue;
        const double along = area.dot(Vec3(outward.X(), outward.Y(), outward.Z())) / outward.Magnitude();
        (along > 0 ? with : against) += std::abs(along);
    }
    figures.turned = (against > with) != (face.Orientation() == TopAbs_REVERSED);
    return figures;
}

}  // namespace ripstop::cad
