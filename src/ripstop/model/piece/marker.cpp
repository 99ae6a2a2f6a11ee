#include "ripstop/model/piece/marker.h"

#include <cmath>

namespace ripstop {

Points2 Placement::placed(const Points2& points) const {
    const double cosine = std::cos(turn), sine = std::sin(turn), sign = is_drawn_mirrored() ? -1 : 1;
    Points2 result(points.rows(), 2);
    result.col(0) = cosine * points.col(0) - sign * sine * points.col(1);
    result.col(1) = sine * points.col(0) + sign * cosine * points.col(1);
    result.rowwise() += shift.transpose();
    return result;
}

}  // namespace ripstop
