#include "ripstop/io/json/special_json.h"

#include <cmath>
#include <iterator>

#include "ripstop/base/error.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"
#include "ripstop/io/json/json_text.h"
#include "ripstop/io/text/text.h"

namespace ripstop {
namespace {

using nlohmann::json;

double required_number(const json& object, const char* key, const std::string& place) {
    if (const std::optional<double> value = number_at(object, key, place)) return *value;
    throw InputError(place + ": the key " + key + " is missing, expected a number; add it");
}

double required_length(const json& object, const char* key, const std::string& place) {
    return required_number(object, key, place) * millimetre;
}

int count_at(const json& object, const char* key, const std::string& place) {
    const double value = required_number(object, key, place);
    if (!(value >= 1 && value <= 1000) || value != std::floor(value))
        throw InputError(place + ": " + key + " is " + format_shortest(value) +
                         ", expected a whole number from 1 to 1000");
    return static_cast<int>(value);
}

PrimitiveKind kind_at(const json& object, const std::string& place) {
    const std::optional<std::string> type = text_at(object, "type", place);
    std::string known;
    for (std::size_t k = 0; k < std::size(primitive_kind_names); ++k) {
        if (type == primitive_kind_names[k]) return static_cast<PrimitiveKind>(k);
        known += (known.empty() ? "" : ", ") + std::string(primitive_kind_names[k]);
    }
    throw InputError(place + (type ? ": the type " + shown(*type) + " is unknown" : ": the key type is missing") +
                     ", expected one of " + known);
}

void read_sizes(const json& value, const std::string& place, SpecialPrimitive& p) {
    switch (p.kind) {
        case PrimitiveKind::ellipsoid:
            require_known_keys(value, {"name", "type", "centre_mm", "axis", "turn_deg", "sectors", "rings", "radii_mm"},
                               place);
            if (!value.contains("radii_mm"))
                throw InputError(place + ": the key radii_mm is missing, expected [x, y, z]; add it");
            p.radii = *point_at(value, "radii_mm", place) * millimetre;
            break;
        case PrimitiveKind::torus:
            require_known_keys(
                value,
                {"name", "type", "centre_mm", "axis", "turn_deg", "sectors", "rings", "radius_mm", "tube_radius_mm"},
                place);
            p.radius = required_length(value, "radius_mm", place);
            p.tube_radius = required_length(value, "tube_radius_mm", place);
            break;
        case PrimitiveKind::capsule:
            require_known_keys(
                value, {"name", "type", "centre_mm", "axis", "turn_deg", "sectors", "rings", "radius_mm", "length_mm"},
                place);
            p.radius = required_length(value, "radius_mm", place);
            p.length = required_length(value, "length_mm", place);
            break;
        case PrimitiveKind::cone:
            require_known_keys(value,
                               {"name", "type", "centre_mm", "axis", "turn_deg", "sectors", "rings", "radius_mm",
                                "top_radius_mm", "length_mm"},
                               place);
            p.radius = required_length(value, "radius_mm", place);
            p.length = required_length(value, "length_mm", place);
            p.top_radius = number_at(value, "top_radius_mm", place).value_or(0) * millimetre;
            break;
    }
}

SpecialPrimitive read_primitive(const json& value, std::string place) {
    if (!value.is_object()) throw InputError(place + " is not an object, expected {\"name\": ..., \"type\": ..., ...}");
    SpecialPrimitive p;
    const std::optional<std::string> name = text_at(value, "name", place);
    if (!name) throw InputError(place + ": the key name is missing, from which its tiles get their names; add it");
    p.name = *name;
    if (!p.name.empty()) place += " (" + readable_name(p.name.substr(0, 40)) + ")";
    p.kind = kind_at(value, place);
    read_sizes(value, place, p);
    if (const std::optional<Vec3> centre = point_at(value, "centre_mm", place)) p.centre = *centre * millimetre;
    if (const std::optional<Vec3> axis = point_at(value, "axis", place)) p.axis = *axis;
    const double turn = number_at(value, "turn_deg", place).value_or(0);
    if (!(std::abs(turn) <= 360))
        throw InputError(place + ": turn_deg is " + format_shortest(turn) + ", expected degrees from -360 to 360");
    p.turn = turn * degree;
    p.sectors = count_at(value, "sectors", place);
    p.rings = count_at(value, "rings", place);
    return p;
}

}  // namespace

SpecialShape read_special_shape(std::istream& in, const std::string& name) {
    const json object = read_json_object(in, name);
    require_known_keys(object, {"edge_mm", "joint_radius_mm", "mouth_height_mm", "primitives"}, name);
    SpecialShape shape;
    shape.edge_length = required_length(object, "edge_mm", name);
    shape.joint_radius = number_at(object, "joint_radius_mm", name).value_or(0) * millimetre;
    if (const std::optional<double> mouth = number_at(object, "mouth_height_mm", name))
        shape.mouth = *mouth * millimetre;
    if (!object.contains("primitives") || !object["primitives"].is_array())
        throw InputError(name + ": primitives is not a list, expected [{\"name\": ..., \"type\": ..., ...}, ...]");
    const json& primitives = object["primitives"];
    for (std::size_t i = 0; i < primitives.size(); ++i)
        shape.primitives.push_back(read_primitive(primitives[i], name + ": primitive " + std::to_string(i + 1)));
    require_valid(shape, name);
    return shape;
}

}  // namespace ripstop
