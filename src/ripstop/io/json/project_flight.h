#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "ripstop/model/flight/flight.h"

namespace ripstop {

/// Reads the key `flight` of a project (docs/project.md): air, tapes, wires, the hold of mouth and crown, ties and
/// diaphragms. Points are in units of `metres_per_unit`. Throws InputError that begins with `place`.
Flight read_flight(const nlohmann::json& value, double metres_per_unit, const std::string& place);

/// Writes the key `flight`, with points in metres. `read_flight` restores the flight.
nlohmann::ordered_json flight_json(const Flight& flight);

}  // namespace ripstop
