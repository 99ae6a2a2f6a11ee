#include "ripstop/io/json/project_flight.h"

#include <array>
#include <nlohmann/json.hpp>

#include "ripstop/base/error.h"
#include "ripstop/base/text/range.h"
#include "ripstop/base/text/units.h"
#include "ripstop/io/json/json_text.h"
#include "ripstop/io/text/text.h"

namespace ripstop {
namespace {

using nlohmann::json;

constexpr std::array<std::pair<const char*, TapedSeams>, 3> tape_words{
    {{"by-type", TapedSeams::by_type}, {"meridians", TapedSeams::meridians}, {"none", TapedSeams::none}}};
constexpr std::array<std::pair<const char*, MouthHold>, 3> mouth_words{
    {{"automatic", MouthHold::automatic}, {"edge", MouthHold::edge}, {"wires", MouthHold::wires}}};

template <class Choice>
const char* word_of(const std::array<std::pair<const char*, Choice>, 3>& words, Choice choice) {
    for (const auto& [word, each] : words)
        if (each == choice) return word;
    return "";
}

void take_number(const json& value, const char* key, double unit, double low, double high, const std::string& place,
                 double& target) {
    const std::optional<double> given = number_at(value, key, place);
    if (!given) return;
    try {
        require_range(key, *given, low, high, "");
    } catch (const InputError& error) {
        throw InputError(place + ": " + error.what());
    }
    target = *given * unit;
}

void take_flag(const json& value, const char* key, const std::string& place, bool& target) {
    const auto found = value.find(key);
    if (found == value.end()) return;
    if (!found->is_boolean()) throw InputError(place + ": " + key + " is neither true nor false");
    target = *found;
}

template <class Choice, std::size_t N>
void take_choice(const json& value, const char* key, const std::array<std::pair<const char*, Choice>, N>& choices,
                 const std::string& place, Choice& target) {
    const std::optional<std::string> given = text_at(value, key, place);
    if (!given) return;
    std::string known;
    for (const auto& [name, choice] : choices) {
        if (*given == name) {
            target = choice;
            return;
        }
        known += (known.empty() ? "" : ", ") + std::string(name);
    }
    throw InputError(place + ": " + key + " is " + shown(*given) + ", expected one of " + known);
}

void take_material(const json& value, const std::string& place, TapeMaterial& material) {
    take_number(value, "stiffness_n", 1, 1, 1e9, place, material.stiffness);
    take_number(value, "strength_n", 1, 1, 1e9, place, material.strength);
    take_number(value, "mass_g_per_m", 1e-3, 0, 1e4, place, material.mass);
}

InnerTie tie_of(const json& value, double metres_per_unit, const std::string& place) {
    require_known_keys(value, {"name", "from", "to", "length_mm", "stiffness_n", "strength_n", "mass_g_per_m"}, place);
    const std::optional<std::string> name = text_at(value, "name", place);
    const std::optional<Vec3> from = point_at(value, "from", place), to = point_at(value, "to", place);
    if (!name || !from || !to)
        throw InputError(place + ": expected a name and two points on the envelope, from and to");
    InnerTie tie{*name, *from * metres_per_unit, *to * metres_per_unit};
    take_number(value, "length_mm", millimetre, 1, 1e6, place, tie.length);
    take_material(value, place, tie.material);
    return tie;
}

nlohmann::ordered_json material_json(const TapeMaterial& material) {
    return {
        {"stiffness_n", material.stiffness}, {"strength_n", material.strength}, {"mass_g_per_m", material.mass / 1e-3}};
}

}  // namespace

nlohmann::ordered_json flight_json(const Flight& flight) {
    const Rigging& rigging = flight.rigging;
    nlohmann::ordered_json value = {{"inside_c", flight.load.air.inside},
                                    {"outside_c", flight.load.air.outside},
                                    {"altitude_m", flight.load.air.altitude},
                                    {"extra_pressure_pa", flight.load.extra_pressure}};
    if (flight.load.mouth_plane) value["mouth_plane_mm"] = *flight.load.mouth_plane / millimetre;
    value["tapes"] = word_of(tape_words, flight.tapes);
    value["load_tape"] = material_json(rigging.load_tape);
    value["foreshortening_pct"] = rigging.foreshortening / percent;
    value["wire"] = material_json(rigging.wire);
    value["wire_length_mm"] = rigging.wire_length / millimetre;
    value["mouth"] = word_of(mouth_words, rigging.mouth);
    value["crown_ring"] = rigging.crown_ring;
    value["crown_closed"] = rigging.crown_closed;
    for (const InnerTie& tie : rigging.ties) {
        nlohmann::ordered_json each = {{"name", tie.name},
                                       {"from", {tie.from.x(), tie.from.y(), tie.from.z()}},
                                       {"to", {tie.to.x(), tie.to.y(), tie.to.z()}}};
        if (tie.length > 0) each["length_mm"] = tie.length / millimetre;
        each.update(material_json(tie.material));
        value["ties"].push_back(each);
    }
    if (!rigging.diaphragms.empty()) value["diaphragms"] = rigging.diaphragms;
    return value;
}

Flight read_flight(const json& value, double metres_per_unit, const std::string& place) {
    require_known_keys(
        value,
        {"inside_c", "outside_c", "altitude_m", "extra_pressure_pa", "mouth_plane_mm", "tapes", "load_tape",
         "foreshortening_pct", "wire", "wire_length_mm", "mouth", "crown_ring", "crown_closed", "ties", "diaphragms"},
        place);
    Flight flight;
    Air& air = flight.load.air;
    take_number(value, "inside_c", 1, -90, 300, place, air.inside);
    take_number(value, "outside_c", 1, -90, 300, place, air.outside);
    take_number(value, "altitude_m", 1, 0, 11000, place, air.altitude);
    take_number(value, "extra_pressure_pa", 1, -1e5, 1e5, place, flight.load.extra_pressure);
    if (value.contains("mouth_plane_mm")) {
        flight.load.mouth_plane = 0;
        take_number(value, "mouth_plane_mm", millimetre, -1e6, 1e6, place, *flight.load.mouth_plane);
    }
    take_choice(value, "tapes", tape_words, place, flight.tapes);
    Rigging& rigging = flight.rigging;
    for (const auto& [key, material] : {std::pair{"load_tape", &rigging.load_tape}, std::pair{"wire", &rigging.wire}}) {
        if (!value.contains(key)) continue;
        require_known_keys(value[key], {"stiffness_n", "strength_n", "mass_g_per_m"}, place + ", " + key);
        take_material(value[key], place + ", " + key, *material);
    }
    take_number(value, "foreshortening_pct", percent, 0, 20, place, rigging.foreshortening);
    take_number(value, "wire_length_mm", millimetre, 10, 1e5, place, rigging.wire_length);
    take_choice(value, "mouth", mouth_words, place, rigging.mouth);
    take_flag(value, "crown_ring", place, rigging.crown_ring);
    take_flag(value, "crown_closed", place, rigging.crown_closed);
    if (const auto ties = value.find("ties"); ties != value.end()) {
        if (!ties->is_array()) throw InputError(place + ": ties is not a list, expected [{\"name\": ...}, ...]");
        for (std::size_t i = 0; i < ties->size(); ++i)
            rigging.ties.push_back(tie_of((*ties)[i], metres_per_unit, place + ", tie " + std::to_string(i + 1)));
    }
    rigging.diaphragms = texts_at(value, "diaphragms", place);
    return flight;
}

}  // namespace ripstop
