#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ripstop/io/json/project_json.h"
#include "ripstop/model/plan/cut_plan.h"

namespace ripstop::cli {

/// How the envelope flies, as the command line has it; what is not given is the project's.
struct FlightArguments {
    std::optional<double> inside, outside, altitude, pressure, tape_stiffness, tape_strength, foreshortening;
    std::string mouth_plane, tapes, mouth;
};

void add_flight_options(CLI::App& command, FlightArguments& given);

/// What the arguments and the project say together; the command line goes before the project. Throws InputError.
Flight flight_of(const FlightArguments& given, Flight flight);

/// Does an inflated plan come to rest, take the drawn shape to 0.3 % of its height and bear what it must?
bool flies_as_drawn(const CutPlan& plan);

}  // namespace ripstop::cli
