#pragma once

#include <gtest/gtest.h>

#include "ripstop/pipeline/remesh/remesh_envelope.h"
#include "ripstop/remesh/remesh_disk.h"

namespace ripstop::testing {

/// Tests that remesh; skipped without CGAL.
class RemeshingTest : public ::testing::Test {
  protected:
    void SetUp() override {
        if (!can_remesh()) GTEST_SKIP() << "built without CGAL";
    }
};

inline RemeshOptions by_length(double length) {
    return {.mode = RemeshMode::by_length, .edge_length = length};
}
inline const RemeshOptions automatic{.mode = RemeshMode::automatic};

/// The first vertices of the chains (#chains x 3).
inline Points3 corners_of(const Tile& tile) {
    Points3 corners(std::ssize(tile.chains), 3);
    for (std::size_t c = 0; c < tile.chains.size(); ++c)
        corners.row(static_cast<Eigen::Index>(c)) = tile.mesh.positions.row(tile.chains[c].vertices.front());
    return corners;
}

}  // namespace ripstop::testing
