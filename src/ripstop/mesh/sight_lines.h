#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// Whether straight lines from a point meet any of many triangles: a tree of boxes over them. Building it is O(#F log
/// #F), a line O(log #F) where few triangles lie in each other's boxes.
class SightLines {
  public:
    explicit SightLines(const std::vector<const TriangleMesh*>& meshes);

    /// Does the half-line from `from` along `direction` (unit length) meet a triangle further than `least` away [m]?
    bool is_blocked(const Vec3& from, const Vec3& direction, double least) const;

  private:
    struct Box {
        Eigen::AlignedBox3d box;
        int first = 0, count = 0;  ///< of a leaf: its triangles
        int second = 0;            ///< of others: the second part; the first part comes next
    };
    int build(int first, int count);

    std::vector<std::array<Vec3, 3>> triangles_;
    std::vector<Box> boxes_;
};

}  // namespace ripstop
