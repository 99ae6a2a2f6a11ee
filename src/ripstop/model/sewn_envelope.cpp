#include "ripstop/model/sewn_envelope.h"

#include <cmath>

namespace ripstop {

Vec3 position(const Place& place, const Points3& nodes, double angle) {
    Vec3 sum = Vec3::Zero();
    for (const PlacePart& part : place) {
        const Vec3 x = nodes.row(part.node);
        if (part.turns == 0) {
            sum += part.weight * x;
            continue;
        }
        const double c = std::cos(part.turns * angle), s = std::sin(part.turns * angle);
        sum += part.weight * Vec3(c * x.x() - s * x.y(), s * x.x() + c * x.y(), x.z());
    }
    return sum;
}

}  // namespace ripstop
