#pragma once

#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// Numbers the places of surfaces. Points in exactly the same place of the same surface get the same number; 0 and
/// -0 are equal. A call takes constant time on average.
class PlaceTable {
  public:
    /// The number of this place. A new place gets the number `next`.
    int number_of(const Vec3& place, int surface, int next);

  private:
    struct Entry {
        Vec3 place;
        int surface;
        int number;  ///< -1: free
    };

    void grow();

    std::vector<Entry> entries_;  ///< open addressing; the size is a power of two
    std::size_t used_ = 0;
};

}  // namespace ripstop
