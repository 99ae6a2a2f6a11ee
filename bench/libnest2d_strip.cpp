#include "libnest2d_strip.h"

#define LIBNEST2D_THREADING_std
#define LIBNEST2D_GEOMETRIES_clipper
#define LIBNEST2D_OPTIMIZER_nlopt
#include <algorithm>
#include <chrono>
#include <cmath>
#include <libnest2d/libnest2d.hpp>

using namespace libnest2d;

namespace {

constexpr double steps_per_metre = 1e6;

Item item_of(const PlainOutline& outline) {
    ClipperLib::Path path;
    for (const auto& [x, y] : outline)
        path.push_back({std::llround(x * steps_per_metre), std::llround(y * steps_per_metre)});
    std::reverse(path.begin(), path.end());  // libnest2d expects clockwise, closed outlines
    path.push_back(path.front());
    return Item(path);
}

}  // namespace

StripResult lay_with_libnest2d(const std::vector<PlainOutline>& outlines, double width, double gap, double accuracy) {
    std::vector<Item> items;
    for (const PlainOutline& outline : outlines) items.push_back(item_of(outline));
    const auto across = static_cast<Coord>(width * steps_per_metre), along = static_cast<Coord>(1000 * steps_per_metre);
    NestConfig<> config;
    auto& placer = config.placer_config;
    placer.rotations = {0.0, Pi};
    placer.accuracy = static_cast<float>(accuracy);
    placer.parallel = false;
    placer.alignment = placer.starting_point = std::decay_t<decltype(placer)>::Alignment::BOTTOM_LEFT;
    // Prefers places near the start, then low ones. libnest2d's own objective knows no strip, so leaving the strip
    // must be expensive.
    placer.object_function = [width](const Item& item) {
        const auto box = item.boundingBox();
        const double left = getX(box.minCorner()) / steps_per_metre, right = getX(box.maxCorner()) / steps_per_metre;
        const double low = getY(box.minCorner()) / steps_per_metre, high = getY(box.maxCorner()) / steps_per_metre;
        const double out = std::max(0.0, -left) + std::max(0.0, -low) + std::max(0.0, high - width);
        return right + 0.01 * low + (out > 1e-6 ? 1e3 * (1 + out) : 0);
    };
    const auto start = std::chrono::steady_clock::now();
    const std::size_t bins =
        nest(items, Box(along, across, {along / 2, across / 2}), static_cast<Coord>(gap * steps_per_metre), config);
    StripResult result;
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::vector<double> first(bins, 1e9), last(bins, 0);
    for (const Item& item : items) {
        const auto box = item.boundingBox();
        result.is_laid.push_back(item.binId() >= 0 && getY(box.minCorner()) >= -1 &&
                                 getY(box.maxCorner()) <= across + 1);
        if (!result.is_laid.back()) continue;
        const auto bin = static_cast<std::size_t>(item.binId());
        first[bin] = std::min(first[bin], getX(box.minCorner()) / steps_per_metre);
        last[bin] = std::max(last[bin], getX(box.maxCorner()) / steps_per_metre);
    }
    for (std::size_t bin = 0; bin < bins; ++bin) result.length += std::max(0.0, last[bin] - first[bin]);
    return result;
}
