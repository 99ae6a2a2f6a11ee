#include "ripstop/inflate/joints.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "ripstop/base/index.h"

namespace ripstop {

Joints::Joints(int points, int sectors)
    : sectors_(sectors), angle_(2 * std::numbers::pi / sectors), hangs_on_(static_cast<std::size_t>(points)) {}

SewnPoint Joints::resolved(const SewnPoint& place) const {
    std::map<std::pair<int, int>, double> sum;
    std::vector<NodeShare> open = place.shares;
    SewnPoint result{{}, place.offset};
    while (!open.empty()) {
        const NodeShare part = open.back();
        open.pop_back();
        const SewnPoint& inner = hangs_on_[at(part.node)];
        if (inner.shares.empty()) {
            sum[{part.node, part.turns % sectors_}] += part.weight;
            continue;
        }
        result.offset += part.weight * turned(inner.offset, part.turns, angle_);
        for (const NodeShare& each : inner.shares)
            open.push_back({each.node, part.weight * each.weight, part.turns + each.turns});
    }
    for (const auto& [key, weight] : sum)
        if (std::abs(weight) > 1e-12) result.shares.push_back({key.first, weight, key.second});
    return result;
}

bool Joints::replace(const SewnPoint& one, const SewnPoint& by) {
    const NodeShare& single = one.shares[0];
    if (std::any_of(by.shares.begin(), by.shares.end(),
                    [&](const NodeShare& part) { return part.node == single.node; }))
        return false;
    SewnPoint back = by;
    for (NodeShare& part : back.shares) part.turns = (part.turns + sectors_ - single.turns) % sectors_;
    back.offset = turned(by.offset - one.offset, -single.turns, angle_);
    hangs_on_[at(single.node)] = back;
    return true;
}

bool Joints::join(const SewnPoint& a, const SewnPoint& b) {
    const SewnPoint left = resolved(a), right = resolved(b);
    if (left.is_node() && right.is_node() && left.shares[0].node == right.shares[0].node) {
        if (left.shares[0].turns != right.shares[0].turns) on_axis_.insert(left.shares[0].node);
        return true;
    }
    // The later point depends on the earlier one, so that the choice of free points does not depend on the order of
    // joints.
    const bool swap = left.is_node() && right.is_node() && left.shares[0].node < right.shares[0].node;
    if (!swap && left.is_node() && replace(left, right)) return true;
    if (right.is_node() && replace(right, left)) return true;
    return left.is_node() && replace(left, right);
}

}  // namespace ripstop
