#pragma once

#include <array>
#include <string>
#include <vector>

namespace ripstop::testing {

/// A picture as other programs give it.
struct Raster {
    int width = 0, height = 0;
    std::vector<unsigned char> rgb;  ///< row by row from the top

    std::array<int, 3> at(int x, int y) const;
    bool is_red(int x, int y) const;   ///< more red than anything: a cut line, thin ones half white
    bool is_grey(int x, int y) const;  ///< neither white nor a colour
};

/// A PPM file (P6). No pixel where there is none.
Raster read_ppm(const std::string& path);

}  // namespace ripstop::testing
