#include "ripstop/io/json/project_json.h"

#include <algorithm>

#include "ripstop/base/error.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"
#include "ripstop/io/json/json_text.h"
#include "ripstop/io/json/project_flight.h"
#include "ripstop/io/json/project_seams.h"
#include "ripstop/io/json/project_tiles.h"
#include "ripstop/io/text/text.h"
#include "ripstop/model/plan/envelope_check.h"

namespace ripstop {
namespace {

using nlohmann::json;

void read_tolerances(const json& value, const std::string& place, Project& project) {
    require_known_keys(value, {"area_pct", "length_pct", "strain_pct", "shear_deg"}, place);
    const auto read = [&](const char* key, double unit, std::optional<double>& target) {
        const std::optional<double> given = number_at(value, key, place);
        if (given && !(*given > 0))
            throw InputError(place + ": " + key + " is " + format_shortest(*given) + ", expected a number above 0");
        if (given) target = *given * unit;
    };
    read("area_pct", percent, project.area);
    read("length_pct", percent, project.length);
    read("strain_pct", percent, project.strain);
    read("shear_deg", degree, project.shear);
}

void require_names_once(const Project& project) {
    std::map<std::string, std::size_t> first;
    for (std::size_t i = 0; i < project.tiles.size(); ++i)
        if (const auto [entry, is_new] = first.try_emplace(project.tiles[i].name, i + 1); !is_new)
            throw InputError(project.file + ": tiles " + std::to_string(entry->second) + " and " +
                             std::to_string(i + 1) + " have the same name " + shown(project.tiles[i].name) +
                             ", expected each name once; join them");
}

void require_acceptable(const std::vector<std::string>& codes, const std::string& name) {
    std::string known;
    for (const char* code : acceptable_issues) known += (known.empty() ? "" : ", ") + std::string(code);
    for (const std::string& code : codes)
        if (std::find(acceptable_issues.begin(), acceptable_issues.end(), code) == acceptable_issues.end())
            throw InputError(name + ": accept: " + shown(code) + " cannot be accepted, expected one of: " + known);
}

std::map<std::string, std::string> read_materials(const json& value, const std::string& place) {
    if (!value.is_object())
        throw InputError(place + " is not an object, expected a fabric per material: {\"red_nylon\": \"nylon\"}");
    std::map<std::string, std::string> materials;
    for (const auto& [material, fabric] : value.items()) {
        if (!fabric.is_string())
            throw InputError(place + ": the fabric of " + shown(material) +
                             " is not a text, expected a preset or a .json file; give its name in quotes");
        materials[material] = fabric.get<std::string>();
    }
    return materials;
}

void read_tiles(const json& tiles, const std::string& name, Project& project) {
    if (!tiles.is_array()) throw InputError(name + ": tiles is not a list, expected [{\"name\": ...}, ...]");
    for (std::size_t i = 0; i < tiles.size(); ++i)
        project.tiles.push_back(read_project_tile(tiles[i], name + ": tile " + std::to_string(i + 1)));
    require_names_once(project);
}

}  // namespace

Project read_project(std::istream& in, const std::string& name, const std::string& unit) {
    const json object = read_json_object(in, name);
    require_known_keys(object,
                       {"unit", "fabric", "materials", "layers", "grain_layers", "tolerances", "seam_tolerance_mm",
                        "tiles", "seam_types", "seams", "flight", "size_is_meant", "accept"},
                       name);
    Project project;
    project.file = name;
    project.unit = text_at(object, "unit", name);
    if (project.unit) try {
            metres_per_unit(*project.unit);
        } catch (const InputError& error) {
            throw InputError(name + ": " + error.what());
        }
    if (const auto meant = object.find("size_is_meant"); meant != object.end()) {
        if (!meant->is_boolean()) throw InputError(name + ": size_is_meant is neither true nor false");
        project.size_is_meant = meant->get<bool>();
    }
    project.accept = texts_at(object, "accept", name);
    require_acceptable(project.accept, name);
    project.fabric = text_at(object, "fabric", name);
    if (object.contains("materials")) project.materials = read_materials(object["materials"], name + ": materials");
    project.layers = texts_at(object, "layers", name);
    project.grain_layers = texts_at(object, "grain_layers", name);
    if (object.contains("tolerances")) read_tolerances(object["tolerances"], name + ": tolerances", project);
    if (const std::optional<double> given = number_at(object, "seam_tolerance_mm", name)) {
        if (!(*given > 0))
            throw InputError(name + ": seam_tolerance_mm is " + format_shortest(*given) +
                             ", expected a number above 0");
        project.seam_tolerance = *given * millimetre;
    }
    if (object.contains("tiles")) read_tiles(object["tiles"], name, project);
    if (object.contains("seam_types"))
        project.seam_types = read_seam_types(object["seam_types"], name + ": seam_types");
    if (object.contains("seams"))
        project.seams = read_seam_rules(object["seams"], project.seam_types, name + ": seams");
    if (object.contains("flight"))
        project.flight = read_flight(
            object["flight"], metres_per_unit(unit.empty() ? project.unit.value_or("m") : unit), name + ": flight");
    return project;
}

}  // namespace ripstop
