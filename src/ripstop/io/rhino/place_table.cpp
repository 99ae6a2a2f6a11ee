#include "ripstop/io/rhino/place_table.h"

#include <bit>
#include <cstdint>

namespace ripstop {
namespace {

std::uint64_t mixed(std::uint64_t hash, std::uint64_t bits) {
    hash = (hash ^ bits) * 0x9E3779B97F4A7C15U;
    return hash ^ hash >> 29;
}

std::size_t hash_of(const Vec3& place, int surface) {
    std::uint64_t hash = static_cast<std::uint64_t>(surface);
    for (const double x : place) hash = mixed(hash, std::bit_cast<std::uint64_t>(x + 0.0));  // -0 + 0 is 0
    return static_cast<std::size_t>(mixed(hash, 0));
}

}  // namespace

int PlaceTable::number_of(const Vec3& place, int surface, int next) {
    if (2 * used_ >= entries_.size()) grow();
    const std::size_t mask = entries_.size() - 1;
    std::size_t at = hash_of(place, surface) & mask;
    while (entries_[at].number >= 0 && (entries_[at].surface != surface || entries_[at].place != place))
        at = (at + 1) & mask;
    if (entries_[at].number < 0) {
        entries_[at] = {place, surface, next};
        ++used_;
    }
    return entries_[at].number;
}

void PlaceTable::grow() {
    std::vector<Entry> before(entries_.empty() ? 64 : 2 * entries_.size(), Entry{Vec3::Zero(), 0, -1});
    before.swap(entries_);
    const std::size_t mask = entries_.size() - 1;
    for (const Entry& entry : before) {
        if (entry.number < 0) continue;
        std::size_t at = hash_of(entry.place, entry.surface) & mask;
        while (entries_[at].number >= 0) at = (at + 1) & mask;
        entries_[at] = entry;
    }
}

}  // namespace ripstop
