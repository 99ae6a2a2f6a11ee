#include "support/raster.h"

#include <zlib.h>

#include <cstdint>
#include <cstdlib>
#include <fstream>

namespace ripstop::testing {

std::array<int, 3> Raster::at(int x, int y) const {
    const auto first =
        3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
    return {rgb[first], rgb[first + 1], rgb[first + 2]};
}

bool Raster::is_red(int x, int y) const {
    const auto [red, green, blue] = at(x, y);
    return red > green + 40 && red > blue + 40;
}

bool Raster::is_grey(int x, int y) const {
    const auto [red, green, blue] = at(x, y);
    return red == green && green == blue && red < 230;
}

namespace {

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < 4; ++k) value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
    return value;
}

int paeth(int left, int above, int before) {
    const int guess = left + above - before;
    const int a = std::abs(guess - left), b = std::abs(guess - above), c = std::abs(guess - before);
    return a <= b && a <= c ? left : b <= c ? above : before;
}

/// Undoes the PNG filter of each row; the filter's number precedes the row.
bool unfilter(std::vector<unsigned char>& bytes, std::size_t rows, std::size_t row_length, std::size_t pixel) {
    for (std::size_t y = 0; y < rows; ++y) {
        unsigned char* row = bytes.data() + y * (row_length + 1) + 1;
        const int filter = row[-1];
        if (filter > 4) return false;
        for (std::size_t i = 0; i < row_length; ++i) {
            const unsigned char* previous = row - (row_length + 1);
            const int left = i >= pixel ? row[i - pixel] : 0, above = y > 0 ? previous[i] : 0;
            const int before = y > 0 && i >= pixel ? previous[i - pixel] : 0;
            const int guesses[] = {0, left, above, (left + above) / 2, paeth(left, above, before)};
            row[i] = static_cast<unsigned char>(row[i] + guesses[filter]);
        }
    }
    return true;
}

}  // namespace

Raster read_png(const std::string& bytes) {
    if (bytes.substr(0, 8) != "\x89PNG\r\n\x1a\n") return {};
    Raster raster;
    std::string packed;
    std::size_t pixel = 0;
    for (std::size_t at = 8; at + 12 <= bytes.size();) {
        const std::size_t length = number_at(bytes, at);
        if (at + 12 + length > bytes.size()) return {};
        const std::string kind = bytes.substr(at + 4, 4), data = bytes.substr(at + 8, length);
        const auto* checked = reinterpret_cast<const Bytef*>(bytes.data() + at + 4);
        if (crc32(0, checked, static_cast<uInt>(length + 4)) != number_at(bytes, at + 8 + length)) return {};
        if (kind == "IHDR") {
            raster.width = static_cast<int>(number_at(data, 0));
            raster.height = static_cast<int>(number_at(data, 4));
            if (data[8] != 8 || (data[9] != 2 && data[9] != 6) || data[12] != 0) return {};
            pixel = data[9] == 2 ? 3 : 4;
        }
        if (kind == "IDAT") packed += data;
        at += 12 + length;
    }
    const auto rows = static_cast<std::size_t>(raster.height),
               row_length = pixel * static_cast<std::size_t>(raster.width);
    std::vector<unsigned char> all(rows * (row_length + 1));
    uLongf size = all.size();
    if (uncompress(all.data(), &size, reinterpret_cast<const Bytef*>(packed.data()), packed.size()) != Z_OK ||
        size != all.size() || !unfilter(all, rows, row_length, pixel))
        return {};
    for (std::size_t y = 0; y < rows; ++y)
        for (std::size_t i = 0; i < row_length; ++i)
            if (i % pixel < 3) raster.rgb.push_back(all[y * (row_length + 1) + 1 + i]);
    return raster;
}

Raster read_ppm(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    std::string kind;
    int most = 0;
    Raster raster;
    if (!(in >> kind >> raster.width >> raster.height >> most) || kind != "P6" || most != 255) return {};
    in.get();
    raster.rgb.resize(3 * static_cast<std::size_t>(raster.width) * static_cast<std::size_t>(raster.height));
    in.read(reinterpret_cast<char*>(raster.rgb.data()), static_cast<std::streamsize>(raster.rgb.size()));
    return in ? raster : Raster{};
}

}  // namespace ripstop::testing
