#pragma once

#include <BRepAdaptor_Surface.hxx>
#include <TopoDS_Face.hxx>

#include "meshing.h"

namespace ripstop::cad {

/// True if the surface has a point to which it contracts (a pole), or if an edge of the face is sewn to itself.
bool comes_together(const TopoDS_Face& face);

/// The edge length at each place of a face, from the curvature of its surface at the points of a grid. On a face
/// that comes together, edges are at most as long as the radius, so that a tube or a needle does not become flat.
class FaceSizes {
  public:
    FaceSizes(const TopoDS_Face& face, const EdgeSizes& sizes, double finer);

    double at(const Vec2& uv) const;                  ///< [mm], interpolated in the grid
    double triangles() const { return triangles_; }   ///< about the number of equilateral triangles of these sizes
    const Vec2& stretch() const { return stretch_; }  ///< mean stretch of the surface along u and v [mm]
    const Vec2& low() const { return low_; }          ///< lower corner of the face in u and v
    const Vec2& high() const { return high_; }

  private:
    int columns_ = 1, rows_ = 1;
    Vec2 low_, high_, stretch_ = Vec2(1, 1);
    std::vector<double> sizes_;
    double triangles_ = 0;
};

}  // namespace ripstop::cad
