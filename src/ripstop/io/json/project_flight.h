#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "ripstop/model/flight/flight.h"

namespace ripstop {

/// The key `flight` of a project (docs/project.md): air, tapes, wires, how mouth and crown are held, ties and
/// diaphragms. Points are in units of `metres_per_unit`. Throws InputError that begins with `place`.
Flight read_flight(const nlohmann::json& value, double metres_per_unit, const std::string& place);

/// The same key, for points in metres: `read_flight` gives the flight back.
nlohmann::ordered_json flight_json(const Flight& flight);

}  // namespace ripstop
