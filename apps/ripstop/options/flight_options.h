#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ripstop/io/json/project_json.h"
#include "ripstop/model/plan/cut_plan.h"

namespace ripstop::cli {

/// The flight options on the command line; the project fills in what is not given.
struct FlightArguments {
    std::optional<double> inside, outside, altitude, pressure, tape_stiffness, tape_strength, foreshortening;
    std::string mouth_plane, tapes, mouth;
};

void add_flight_options(CLI::App& command, FlightArguments& given);

/// The project's flight, overridden by the command line. Throws InputError.
Flight flight_of(const FlightArguments& given, Flight flight);

}  // namespace ripstop::cli
