#pragma once

#include <array>
#include <optional>

#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// CGAL's least-squares conformal map and its as-rigid-as-possible map, both with CGAL's own defaults, sparse systems by
/// Eigen: what ours are timed against, and an oracle for the tests. Conversion of the mesh is not part of the time. False
/// where CGAL reports an error.
class CgalParameterization {
  public:
    explicit CgalParameterization(const TriangleMesh& mesh);
    ~CgalParameterization();
    CgalParameterization(const CgalParameterization&) = delete;
    CgalParameterization& operator=(const CgalParameterization&) = delete;

    /// `pins`: the two vertices that are held; CGAL's own choice if none are given.
    bool lscm(std::optional<std::array<int, 2>> pins = {});
    bool arap();

    Points2 positions() const;  ///< what the last map gave, #V x 2

  private:
    struct Data;
    Data* data_;
};

}  // namespace ripstop
