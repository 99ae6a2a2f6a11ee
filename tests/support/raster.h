#pragma once

#include <array>
#include <string>
#include <vector>

namespace ripstop::testing {

/// A picture from another program.
struct Raster {
    int width = 0, height = 0;
    std::vector<unsigned char> rgb;  ///< row by row from the top

    std::array<int, 3> at(int x, int y) const;
    bool is_red(int x, int y) const;   ///< mostly red: a cut line; thin ones are half white
    bool is_grey(int x, int y) const;  ///< neither white nor coloured
};

/// The pixels of a PNG with 8 bits per channel, RGB or RGBA, not interlaced. An independent reader by the standard
/// (ISO/IEC 15948); it shares only zlib's inflate with the writer. Empty if it is no such PNG, or if a checksum is
/// wrong.
Raster read_png(const std::string& bytes);

/// Reads a PPM file (P6); empty if there is none.
Raster read_ppm(const std::string& path);

}  // namespace ripstop::testing
