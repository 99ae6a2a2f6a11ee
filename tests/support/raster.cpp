#include "support/raster.h"

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
