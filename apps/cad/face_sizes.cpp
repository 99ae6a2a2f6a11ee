#include "face_sizes.h"

#include <BRepGProp.hxx>
#include <BRepLProp_SLProps.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <algorithm>
#include <cmath>

namespace ripstop::cad {
namespace {

constexpr int points_a_span = 4, fewest_points = 12, most_points = 64;
constexpr double least_of_radius = 1.0 / 8;  // of the shortest edges
constexpr double equilateral = 0.433;        // ratio of the area to the square of the edge

/// The number of grid points, so that every span of a spline is sampled.
int points_for(int spans) {
    return std::clamp(points_a_span * spans, fewest_points, most_points);
}

double largest_bend(const BRepAdaptor_Surface& surface, double u, double v) {
    BRepLProp_SLProps properties(surface, u, v, 2, 1e-9);
    if (!properties.IsCurvatureDefined()) return 0;
    return std::max(std::abs(properties.MaxCurvature()), std::abs(properties.MinCurvature()));
}

}  // namespace

bool comes_together(const TopoDS_Face& face) {
    for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next()) {
        const TopoDS_Edge edge = TopoDS::Edge(edges.Current());
        if (BRep_Tool::Degenerated(edge) || BRep_Tool::IsClosed(edge, face)) return true;
    }
    return false;
}

FaceSizes::FaceSizes(const TopoDS_Face& face, const EdgeSizes& sizes, double finer) {
    const BRepAdaptor_Surface surface(face);
    BRepTools::UVBounds(face, low_[0], high_[0], low_[1], high_[1]);
    if (surface.GetType() != GeomAbs_Plane) {
        columns_ = points_for(surface.NbUIntervals(GeomAbs_CN));
        rows_ = points_for(surface.NbVIntervals(GeomAbs_CN));
    }
    const bool round = comes_together(face);
    double area = 0, along_u = 0, along_v = 0;
    for (int i = 0; i < columns_; ++i)
        for (int j = 0; j < rows_; ++j) {
            // In the middle of each cell, because at its ends a pole has infinite curvature.
            const double u = low_[0] + (high_[0] - low_[0]) * (i + 0.5) / columns_;
            const double v = low_[1] + (high_[1] - low_[1]) * (j + 0.5) / rows_;
            gp_Pnt p;
            gp_Vec du, dv;
            surface.D1(u, v, p, du, dv);
            const double bend = largest_bend(surface, u, v);
            double size = std::min(sizes.longest, finer * sizes.at(bend));
            if (round && bend * size > 1) size = std::min(size, std::max(1 / bend, least_of_radius * sizes.shortest));
            sizes_.push_back(size);
            const double cell = du.Crossed(dv).Magnitude();
            area += cell;
            triangles_ += cell / (equilateral * size * size);
            along_u += du.Magnitude();
            along_v += dv.Magnitude();
        }
    const double count = columns_ * rows_;
    if (along_u > 0 && along_v > 0) stretch_ = Vec2(along_u / count, along_v / count);
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(face, properties);
    if (area > 0) triangles_ *= std::abs(properties.Mass()) / area;
}

double FaceSizes::at(const Vec2& uv) const {
    const auto place = [](double at, double low, double high, int count) {
        return std::clamp(high > low ? (at - low) / (high - low) * count - 0.5 : 0, 0.0, count - 1.0);
    };
    const double x = place(uv[0], low_[0], high_[0], columns_), y = place(uv[1], low_[1], high_[1], rows_);
    const int i = std::min(static_cast<int>(x), std::max(0, columns_ - 2));
    const int j = std::min(static_cast<int>(y), std::max(0, rows_ - 2));
    const int i1 = std::min(i + 1, columns_ - 1), j1 = std::min(j + 1, rows_ - 1);
    const auto size = [this](int column, int row) { return sizes_[static_cast<std::size_t>(column * rows_ + row)]; };
    const double s = x - i, t = y - j;
    return (1 - s) * ((1 - t) * size(i, j) + t * size(i, j1)) + s * ((1 - t) * size(i1, j) + t * size(i1, j1));
}

}  // namespace ripstop::cad
