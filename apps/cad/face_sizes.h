#pragma once

#include <BRepAdaptor_Surface.hxx>
#include <TopoDS_Face.hxx>

#include "meshing.h"

namespace ripstop::cad {

/// Whether its surface comes to a point on it (a pole), or an edge of it is sewn to itself.
bool comes_together(const TopoDS_Face& face);

/// How long edges are to be here and there on a face, from the bend of its surface at the points of a grid. Where it
/// comes together they are no longer than the radius, lest a tube or a needle become flat.
class FaceSizes {
  public:
    FaceSizes(const TopoDS_Face& face, const EdgeSizes& sizes, double finer);

    double at(const Vec2& uv) const;                  ///< [mm], between the points of the grid
    double triangles() const { return triangles_; }   ///< about as many equilateral ones of these sizes cover the face
    const Vec2& stretch() const { return stretch_; }  ///< of the surface along u and v in the mean [mm]
    const Vec2& low() const { return low_; }          ///< the face lies within, in u and v
    const Vec2& high() const { return high_; }

  private:
    int columns_ = 1, rows_ = 1;
    Vec2 low_, high_, stretch_ = Vec2(1, 1);
    std::vector<double> sizes_;
    double triangles_ = 0;
};

}  // namespace ripstop::cad
