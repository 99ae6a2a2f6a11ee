#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// Tests whether rays hit any of many triangles, by a bounding volume hierarchy. Building takes O(#F log #F), a ray
/// O(log #F) if few triangles overlap each other's boxes.
class SightLines {
  public:
    explicit SightLines(const std::vector<const TriangleMesh*>& meshes);

    /// Whether the ray from `from` along `direction` (unit length) hits a triangle further than `least` away [m].
    bool is_blocked(const Vec3& from, const Vec3& direction, double least) const;

  private:
    struct Box {
        Eigen::AlignedBox3d box;
        int first = 0, count = 0;  ///< of a leaf: its range of triangles
        int second = 0;            ///< of an inner node: its second child; the first child follows directly
    };
    int build(int first, int count);

    std::vector<std::array<Vec3, 3>> triangles_;
    std::vector<Box> boxes_;
};

}  // namespace ripstop
