#include "ripstop/io/json/project_seams.h"

#include <algorithm>

#include "ripstop/base/error.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"
#include "ripstop/io/json/json_text.h"
#include "ripstop/io/text/text.h"

namespace ripstop {
namespace {

using nlohmann::json;

constexpr double widest_mm = 1000;  // a wider allowance is probably in the wrong unit
constexpr int most_rows = 20;

std::optional<double> allowance_at(const json& value, const char* key, const std::string& place) {
    const std::optional<double> given = number_at(value, key, place);
    if (!given) return std::nullopt;
    if (!(*given >= 0 && *given <= widest_mm))
        throw InputError(place + ": " + key + " is " + format_shortest(*given) +
                         ", expected millimetres of cloth beyond the sew line, 0 to 1000");
    return *given * millimetre;
}

SeamType read_type(const json& value, const std::vector<SeamType>& known, const std::string& place) {
    require_known_keys(value, {"name", "allowance_mm", "rows", "tape"}, place);
    const std::string name = text_at(value, "name", place).value_or("");
    if (name.empty())
        throw InputError(place + ": no name, expected what seams[] calls the type, such as \"welded\"; add \"name\"");
    const auto like = std::find_if(known.begin(), known.end(), [&](const SeamType& type) { return type.name == name; });
    SeamType type = like != known.end() ? *like : SeamType{};
    type.name = name;
    const std::optional<double> allowance = allowance_at(value, "allowance_mm", place);
    if (!allowance)
        throw InputError(place + " (" + shown(name) +
                         "): no allowance_mm, expected the cloth beyond the sew line; add it");
    type.allowance = *allowance;
    if (const std::optional<double> rows = number_at(value, "rows", place)) {
        if (!(*rows >= 0 && *rows <= most_rows) || *rows != static_cast<int>(*rows))
            throw InputError(place + ": rows is " + format_shortest(*rows) + ", expected rows of stitching, 0 to 20");
        type.rows = static_cast<int>(*rows);
    }
    if (value.contains("tape")) {
        if (!value["tape"].is_boolean())
            throw InputError(place + ": tape is " +
                             shown(value["tape"].dump(-1, ' ', false, json::error_handler_t::replace)) +
                             ", expected true or false");
        type.tape = value["tape"].get<bool>();
    }
    return type;
}

/// The seam type with this name.
const SeamType& seam_type_named(const std::string& name, const std::vector<SeamType>& types, const std::string& place) {
    std::string known;
    for (const SeamType& type : types) {
        if (type.name == name) return type;
        known += (known.empty() ? "" : ", ") + type.name;
    }
    throw InputError(place + ": no seam type " + shown(name) + "; known: " + known + "; or add it to \"seam_types\"");
}

EdgeDirection direction_at(const json& value, const std::string& place) {
    const std::optional<std::string> given = text_at(value, "direction", place);
    if (!given) return EdgeDirection::any;
    if (*given == "along-warp") return EdgeDirection::along_warp;
    if (*given == "across-warp") return EdgeDirection::across_warp;
    throw InputError(place + ": direction is " + shown(*given) + ", expected \"along-warp\" or \"across-warp\"");
}

/// Reads which tiles the rule applies to.
void read_place(const json& value, const std::string& place, SeamRule& rule) {
    const bool between = value.contains("between");
    if (between == value.contains("free"))
        throw InputError(place +
                         ": expected either \"between\", for seams, or \"free\", for edges without mate; "
                         "give one of the two");
    if (between) {
        const std::vector<std::string> tiles = texts_at(value, "between", place);
        if (tiles.size() != 2)
            throw InputError(place + ": between has " + std::to_string(tiles.size()) +
                             " names, expected two tiles or patterns: [\"G01*\", \"G02*\"]");
        rule.tile = tiles[0];
        rule.mate = tiles[1];
        return;
    }
    rule.tile = text_at(value, "free", place).value_or("");
    if (rule.tile.empty()) throw InputError(place + ": free is empty, expected a tile or a pattern such as \"G*P01\"");
}

SeamRule read_rule(const json& value, const std::vector<SeamType>& types, const std::string& place) {
    require_known_keys(value, {"between", "free", "direction", "type", "allowance_mm", "mate_allowance_mm"}, place);
    SeamRule rule;
    read_place(value, place, rule);
    rule.direction = direction_at(value, place);
    const std::optional<std::string> type = text_at(value, "type", place);
    const std::optional<double> allowance = allowance_at(value, "allowance_mm", place);
    rule.mate_allowance = allowance_at(value, "mate_allowance_mm", place);
    if (rule.mate_allowance && !rule.mate)
        throw InputError(place + ": mate_allowance_mm is for seams, expected allowance_mm alone for a free edge");
    if (!type && !allowance && !rule.mate_allowance)
        throw InputError(place + ": sets nothing for the " + seam_rule_text(rule) +
                         ", expected \"type\", \"allowance_mm\" or both");
    rule.type = seam_type_named(type ? *type : rule.mate ? SeamType{}.name : default_hem().name, types, place);
    if (allowance) rule.type.allowance = *allowance;
    return rule;
}

}  // namespace

std::vector<SeamType> read_seam_types(const json& value, const std::string& place) {
    std::vector<SeamType> types(seam_types().begin(), seam_types().end());
    if (!value.is_array())
        throw InputError(place + " is not a list, expected [{\"name\": ..., \"allowance_mm\": ...}, ...]");
    std::vector<std::string> own;
    for (std::size_t i = 0; i < value.size(); ++i) {
        const std::string here = place + ": " + std::to_string(i + 1);
        SeamType type = read_type(value[i], types, here);
        if (std::find(own.begin(), own.end(), type.name) != own.end())
            throw InputError(here + ": the type " + shown(type.name) +
                             " occurs twice, expected each name once; merge them");
        own.push_back(type.name);
        const auto like =
            std::find_if(types.begin(), types.end(), [&](const SeamType& known) { return known.name == type.name; });
        if (like != types.end())
            *like = std::move(type);
        else
            types.push_back(std::move(type));
    }
    return types;
}

std::vector<SeamRule> read_seam_rules(const json& value, const std::vector<SeamType>& types, const std::string& place) {
    if (!value.is_array())
        throw InputError(place + " is not a list, expected [{\"between\": [\"G01*\", \"G02*\"], \"type\": ...}, ...]");
    std::vector<SeamRule> rules;
    for (std::size_t i = 0; i < value.size(); ++i)
        rules.push_back(read_rule(value[i], types, place + ": " + std::to_string(i + 1)));
    return rules;
}

std::string seam_rule_text(const SeamRule& rule) {
    return rule.mate ? "seam between " + shown(rule.tile) + " and " + shown(*rule.mate)
                     : "free edge of " + shown(rule.tile);
}

}  // namespace ripstop
