#pragma once

#include <nlohmann/json.hpp>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// A figure of the reports, in the unit that its key names: 12 significant digits, null if it is not finite
/// (`clean`).
nlohmann::ordered_json figure(double value);
nlohmann::ordered_json in_percent(double ratio);
nlohmann::ordered_json in_millimetres(double length);  ///< from metres
nlohmann::ordered_json in_degrees(double angle);       ///< from radians

/// A place in millimetres: [x, y, z].
nlohmann::ordered_json point_json(const Vec3& at);

}  // namespace ripstop
