#include "ripstop/model/flight/sewn_envelope.h"

#include <cmath>

namespace ripstop {

Vec3 turned(const Vec3& x, int turns, double angle) {
    if (turns == 0) return x;
    const double c = std::cos(turns * angle), s = std::sin(turns * angle);
    return {c * x.x() - s * x.y(), s * x.x() + c * x.y(), x.z()};
}

Vec3 position(const SewnPoint& place, const Points3& nodes, double angle) {
    Vec3 sum = place.offset;
    for (const NodeShare& part : place.shares) sum += part.weight * turned(nodes.row(part.node), part.turns, angle);
    return sum;
}

}  // namespace ripstop
