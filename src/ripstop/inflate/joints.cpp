#include "ripstop/inflate/joints.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace ripstop {

Joints::Joints(int points, int sectors)
    : sectors_(sectors), angle_(2 * std::numbers::pi / sectors), hangs_on_(static_cast<std::size_t>(points)) {}

Place Joints::resolved(const Place& place) const {
    std::map<std::pair<int, int>, double> sum;
    Place open = place, result;
    result.offset = place.offset;
    while (!open.empty()) {
        const PlacePart part = open.back();
        open.pop_back();
        const Place& inner = hangs_on_[static_cast<std::size_t>(part.node)];
        if (inner.empty()) {
            sum[{part.node, part.turns % sectors_}] += part.weight;
            continue;
        }
        result.offset += part.weight * turned(inner.offset, part.turns, angle_);
        for (const PlacePart& each : inner)
            open.push_back({each.node, part.weight * each.weight, part.turns + each.turns});
    }
    for (const auto& [key, weight] : sum)
        if (std::abs(weight) > 1e-12) result.push_back({key.first, weight, key.second});
    return result;
}

bool Joints::replace(const Place& one, const Place& by) {
    const PlacePart& single = one[0];
    if (std::any_of(by.begin(), by.end(), [&](const PlacePart& part) { return part.node == single.node; }))
        return false;
    Place back = by;
    for (PlacePart& part : back) part.turns = (part.turns + sectors_ - single.turns) % sectors_;
    back.offset = turned(by.offset - one.offset, -single.turns, angle_);
    hangs_on_[static_cast<std::size_t>(single.node)] = back;
    return true;
}

bool Joints::join(const Place& a, const Place& b) {
    const Place left = resolved(a), right = resolved(b);
    if (left.size() == 1 && right.size() == 1 && left[0].node == right[0].node) {
        if (left[0].turns != right[0].turns) on_axis_.insert(left[0].node);
        return true;
    }
    // The later point depends on the earlier one, so that the choice of free points does not depend on the order of
    // joints.
    const bool swap = left.size() == 1 && right.size() == 1 && left[0].node < right[0].node;
    if (!swap && left.size() == 1 && replace(left, right)) return true;
    if (right.size() == 1 && replace(right, left)) return true;
    return left.size() == 1 && replace(left, right);
}

}  // namespace ripstop
