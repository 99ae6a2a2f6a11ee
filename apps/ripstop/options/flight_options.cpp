#include "options/flight_options.h"

#include "commands/known.h"
#include "ripstop/base/text/units.h"
#include "ripstop/report/words/inflated_says.h"

namespace ripstop::cli {

void add_flight_options(CLI::App& command, FlightArguments& given) {
    const std::string group = "Flight";
    command.add_option("--inside", given.inside, "Temperature of the hot air, Celsius (default 100)")
        ->type_name("C")
        ->check(within(-90.0, 300.0))
        ->group(group);
    command.add_option("--outside", given.outside, "Temperature outside, Celsius (default 15)")
        ->type_name("C")
        ->check(within(-90.0, 300.0))
        ->group(group);
    command.add_option("--altitude", given.altitude, "Pressure altitude, metres (default 0)")
        ->type_name("M")
        ->check(within(0.0, 11000.0))
        ->group(group);
    command
        .add_option("--pressure", given.pressure, "Uniform pressure added to that of the hot air, pascals (default 0)")
        ->type_name("PA")
        ->check(within(-1e5, 1e5))
        ->group(group);
    command
        .add_option("--mouth-plane", given.mouth_plane,
                    "Height at which the gauge pressure is zero, such as 0m (default: the mouth's)")
        ->type_name("LENGTH")
        ->group(group);
    command
        .add_option("--tapes", given.tapes,
                    "Seams that take a load tape: by-type (those whose type has one), meridians (also all seams that "
                    "run up the envelope), none")
        ->type_name("WORD")
        ->check(one_of({"by-type", "meridians", "none"}))
        ->group(group);
    command.add_option("--tape-stiffness", given.tape_stiffness, "EA of the load tapes, newtons (default 80000)")
        ->type_name("N")
        ->check(within(1.0, 1e9))
        ->group(group);
    command.add_option("--tape-strength", given.tape_strength, "Strength of the load tapes, newtons (default 10000)")
        ->type_name("N")
        ->check(within(1.0, 1e9))
        ->group(group);
    command
        .add_option("--foreshorten", given.foreshortening,
                    "How much shorter load tapes are than their seams, % (default 0)")
        ->type_name("PCT")
        ->check(within(0.0, 20.0))
        ->group(group);
    command
        .add_option("--mouth-hold", given.mouth,
                    "What holds the mouth: automatic (wires if load tapes end at it, else its edge), edge, wires")
        ->type_name("WORD")
        ->check(one_of({"automatic", "edge", "wires"}))
        ->group(group);
}

Flight flight_of(const FlightArguments& given, Flight flight) {
    const auto take = [](const std::optional<double>& value, double unit, double& target) {
        if (value) target = *value * unit;
    };
    take(given.inside, 1, flight.load.air.inside);
    take(given.outside, 1, flight.load.air.outside);
    take(given.altitude, 1, flight.load.air.altitude);
    take(given.pressure, 1, flight.load.extra_pressure);
    take(given.tape_stiffness, 1, flight.rigging.load_tape.stiffness);
    take(given.tape_strength, 1, flight.rigging.load_tape.strength);
    take(given.foreshortening, percent, flight.rigging.foreshortening);
    if (!given.mouth_plane.empty()) flight.load.mouth_plane = parse_length(given.mouth_plane, "--mouth-plane");
    if (given.tapes == "by-type") flight.tapes = TapedSeams::by_type;
    if (given.tapes == "meridians") flight.tapes = TapedSeams::meridians;
    if (given.tapes == "none") flight.tapes = TapedSeams::none;
    if (given.mouth == "automatic") flight.rigging.mouth = MouthHold::automatic;
    if (given.mouth == "edge") flight.rigging.mouth = MouthHold::edge;
    if (given.mouth == "wires") flight.rigging.mouth = MouthHold::wires;
    return flight;
}

}  // namespace ripstop::cli
