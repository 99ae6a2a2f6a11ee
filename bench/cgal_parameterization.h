#pragma once

#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// CGAL's least-squares conformal map and its as-rigid-as-possible map, both with CGAL's own defaults, sparse systems by
/// Eigen. Conversion of the mesh is not part of the time. False where CGAL reports an error.
class CgalParameterization {
  public:
    explicit CgalParameterization(const TriangleMesh& mesh);
    ~CgalParameterization();
    CgalParameterization(const CgalParameterization&) = delete;
    CgalParameterization& operator=(const CgalParameterization&) = delete;

    bool lscm();
    bool arap();

  private:
    struct Data;
    Data* data_;
};

}  // namespace ripstop
