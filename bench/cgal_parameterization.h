#pragma once

#include <array>
#include <optional>

#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// CGAL's least-squares conformal map and its as-rigid-as-possible map, both with CGAL's defaults and Eigen's
/// sparse solvers. They are a reference for run times and an oracle for tests. Converting the mesh is not part of
/// the time. Returns false if CGAL reports an error.
class CgalParameterization {
  public:
    explicit CgalParameterization(const TriangleMesh& mesh);
    ~CgalParameterization();
    CgalParameterization(const CgalParameterization&) = delete;
    CgalParameterization& operator=(const CgalParameterization&) = delete;

    /// `pins` are the two vertices that are held; without them CGAL chooses.
    bool lscm(std::optional<std::array<int, 2>> pins = {});
    bool arap();

    Points2 positions() const;  ///< of the last map, #V x 2

  private:
    struct Data;
    Data* data_;
};

}  // namespace ripstop
