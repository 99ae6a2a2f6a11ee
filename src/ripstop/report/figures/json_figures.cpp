#include "ripstop/report/figures/json_figures.h"

#include <cmath>

#include "ripstop/base/text/units.h"
#include "ripstop/report/figures/figures.h"

namespace ripstop {

using Json = nlohmann::ordered_json;

Json figure(double value) {
    return std::isfinite(value) ? Json(clean(value)) : Json(nullptr);
}
Json in_percent(double ratio) {
    return figure(ratio / percent);
}
Json in_millimetres(double length) {
    return figure(length / millimetre);
}
Json in_degrees(double angle) {
    return figure(angle / degree);
}

Json point_json(const Vec3& at) {
    return {in_millimetres(at.x()), in_millimetres(at.y()), in_millimetres(at.z())};
}

}  // namespace ripstop
