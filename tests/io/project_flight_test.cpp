#include "ripstop/io/json/project_flight.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "ripstop/base/error.h"
#include "support/refusal.h"

namespace ripstop {
namespace project_flight_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

Flight read(const char* text, double unit = 1) {
    return read_flight(nlohmann::json::parse(text), unit, "flight");
}

std::string refusal(const char* text) {
    return testing::refusal([&] { read(text); });
}

TEST(ProjectFlight, TakesUnitsFromItsKeys) {
    const Flight flight = read(R"({
        "inside_c": 110, "outside_c": -5, "altitude_m": 1500, "extra_pressure_pa": 15, "mouth_plane_mm": -250,
        "tapes": "meridians", "foreshortening_pct": 1.7, "load_tape": {"stiffness_n": 60000, "mass_g_per_m": 25},
        "wire": {"strength_n": 12000}, "wire_length_mm": 2500, "mouth": "edge", "crown_ring": false,
        "ties": [{"name": "ear", "from": [1, 2, 3], "to": [4, 5, 6], "length_mm": 5000, "stiffness_n": 1000}],
        "diaphragms": ["RIB*"]})",
                               2);
    EXPECT_EQ(flight.load.air.inside, 110);
    EXPECT_EQ(flight.load.extra_pressure, 15);
    EXPECT_DOUBLE_EQ(flight.load.mouth_plane.value(), -0.25);
    EXPECT_EQ(flight.tapes, TapedSeams::meridians);
    EXPECT_DOUBLE_EQ(flight.rigging.foreshortening, 0.017);
    EXPECT_DOUBLE_EQ(flight.rigging.load_tape.mass, 0.025);
    EXPECT_EQ(flight.rigging.load_tape.strength, TapeMaterial{}.strength) << "what is not said stays";
    EXPECT_EQ(flight.rigging.wire.strength, 12000);
    EXPECT_EQ(flight.rigging.mouth, MouthHold::edge);
    EXPECT_FALSE(flight.rigging.crown_ring);
    EXPECT_TRUE(flight.rigging.crown_closed);
    ASSERT_EQ(flight.rigging.ties.size(), 1u);
    EXPECT_EQ(flight.rigging.ties[0].to, Vec3(8, 10, 12)) << "in the unit of the file";
    EXPECT_DOUBLE_EQ(flight.rigging.ties[0].length, 5);
    EXPECT_THAT(flight.rigging.diaphragms, ElementsAre("RIB*"));
}

TEST(ProjectFlight, IsReadBackAsItWasWritten) {
    const Flight flight = read(R"({
        "inside_c": 110, "outside_c": -5, "altitude_m": 1500, "extra_pressure_pa": 15, "mouth_plane_mm": -250,
        "tapes": "meridians", "foreshortening_pct": 1.7, "load_tape": {"stiffness_n": 60000, "mass_g_per_m": 25},
        "wire": {"strength_n": 12000}, "wire_length_mm": 2500, "mouth": "wires", "crown_ring": false,
        "ties": [{"name": "ear", "from": [1, 2, 3], "to": [4, 5, 6], "length_mm": 5000, "stiffness_n": 1000},
                 {"name": "nose", "from": [1, 2, 3], "to": [4, 5, 7]}],
        "diaphragms": ["RIB*"]})",
                               2);
    const std::string written = flight_json(flight).dump();
    EXPECT_EQ(flight_json(read(written.c_str())).dump(), written);
    EXPECT_EQ(read(written.c_str()).rigging.ties[0].to, flight.rigging.ties[0].to);
    EXPECT_EQ(flight_json(read("{}")).dump(), flight_json(Flight{}).dump());
}

TEST(ProjectFlight, RefusesWhatCannotBe) {
    EXPECT_THAT(refusal(R"({"inside": 100})"), HasSubstr("inside"));
    EXPECT_THAT(refusal(R"({"inside_c": 900})"), HasSubstr("between -90 and 300"));
    EXPECT_THAT(refusal(R"({"tapes": "all"})"), HasSubstr("by-type, meridians, none"));
    EXPECT_THAT(refusal(R"({"load_tape": {"stiffness_n": 0}})"), HasSubstr("flight, load_tape"));
    EXPECT_THAT(refusal(R"({"foreshortening_pct": 30})"), HasSubstr("foreshortening_pct"));
    EXPECT_THAT(refusal(R"({"crown_ring": 1})"), HasSubstr("true nor false"));
    EXPECT_THAT(refusal(R"({"ties": [{"name": "a", "from": [0, 0, 0]}]})"), HasSubstr("tie 1"));
}

}  // namespace project_flight_test
}  // namespace ripstop
