#pragma once

#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// Numbers for places of a surface: one in exactly the same place of the same surface (0 and -0 are one place) has the
/// same number. A call costs constant time on average.
class PlaceTable {
  public:
    /// The number of the place; `next` where it has none yet.
    int number_of(const Vec3& place, int surface, int next);

  private:
    struct Entry {
        Vec3 place;
        int surface;
        int number;  ///< -1: free
    };

    void grow();

    std::vector<Entry> entries_;  ///< open addressing; as many as a power of two
    std::size_t used_ = 0;
};

}  // namespace ripstop
