#include "ripstop/io/json/fabric_json.h"

#include <array>
#include <cmath>
#include <fstream>
#include <sstream>

#include "ripstop/base/error.h"
#include "ripstop/base/text/units.h"
#include "ripstop/io/json/json_text.h"
#include "ripstop/io/json/shipped_fabrics.h"
#include "ripstop/io/text/input_file.h"
#include "ripstop/io/text/text.h"

namespace ripstop {
namespace {

struct FabricField {
    const char* key;
    double Fabric::*member;
    double unit;  ///< the key's unit in SI
    bool required;
};

constexpr std::array<FabricField, 9> fields = {{
    {"warp_stiffness_n_per_m", &Fabric::warp_stiffness, 1, true},
    {"weft_stiffness_n_per_m", &Fabric::weft_stiffness, 1, true},
    {"shear_stiffness_n_per_m", &Fabric::shear_stiffness, 1, true},
    {"poisson_warp_weft", &Fabric::poisson, 1, false},
    {"mass_kg_per_m2", &Fabric::mass, 1, false},
    {"strength_n_per_m", &Fabric::strength, 1, false},
    {"roll_width_mm", &Fabric::roll_width, millimetre, false},
    {"strain_limit_pct", &Fabric::strain_limit, percent, false},
    {"shear_limit_deg", &Fabric::shear_limit, degree, false},
}};

/// Rounds to 12 digits, so that 10 degrees come back as 10 and not as 10.000000000000002.
double rounded(double value) {
    if (value == 0 || !std::isfinite(value)) return value;
    const double scale = std::pow(10, 11 - std::floor(std::log10(std::abs(value))));
    const double short_value = std::round(value * scale) / scale;
    return std::isfinite(short_value) ? short_value : value;
}

}  // namespace

Fabric read_fabric(std::istream& in, const std::string& name) {
    const nlohmann::json object = read_json_object(in, name);
    require_known_keys(object,
                       {"name", "description", fields[0].key, fields[1].key, fields[2].key, fields[3].key,
                        fields[4].key, fields[5].key, fields[6].key, fields[7].key, fields[8].key},
                       name);
    const auto require = [&](bool present, const char* key) {
        if (!present) throw InputError(name + ": the key " + key + " is missing, expected it in every fabric; add it");
    };
    Fabric fabric;
    const std::optional<std::string> own_name = text_at(object, "name", name);
    require(own_name && !own_name->empty(), "name");
    fabric.name = *own_name;
    fabric.description = text_at(object, "description", name).value_or("");
    for (const FabricField& field : fields) {
        const std::optional<double> value = number_at(object, field.key, name);
        require(value || !field.required, field.key);
        if (value) fabric.*field.member = *value * field.unit;
    }
    require_valid(fabric, name);
    return fabric;
}

std::string write_fabric(const Fabric& fabric) {
    nlohmann::ordered_json object;
    object["name"] = fabric.name;
    object["description"] = fabric.description;
    for (const FabricField& field : fields) object[field.key] = rounded(fabric.*field.member / field.unit);
    return object.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::vector<std::string> fabric_presets() {
    std::vector<std::string> names;
    for (const ShippedFabric& fabric : shipped_fabrics()) names.emplace_back(fabric.name);
    return names;
}

Fabric fabric_named(const std::string& name_or_file) {
    std::string known;
    for (const ShippedFabric& preset : shipped_fabrics()) {
        if (preset.name == name_or_file) {
            std::istringstream in{std::string(preset.text)};
            return read_fabric(in, name_or_file);
        }
        known.append(known.empty() ? "" : ", ").append(preset.name);
    }
    if (name_or_file.ends_with(".json")) {
        std::ifstream in = open_input(name_or_file, "the fabric file");
        return read_fabric(in, name_or_file);
    }
    throw InputError("no fabric " + shown(name_or_file) + "; known: " + known + "; or give a file that ends in .json");
}

}  // namespace ripstop
