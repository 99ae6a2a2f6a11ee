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

/// The pixels of a PNG of 8 bits a channel, RGB or RGBA, not interlaced, read by the letter of its standard (ISO/IEC
/// 15948) and with nothing of what wrote it but zlib's inflate. No pixel where it is none, or a checksum is wrong.
Raster read_png(const std::string& bytes);

/// A PPM file (P6). No pixel where there is none.
Raster read_ppm(const std::string& path);

}  // namespace ripstop::testing
