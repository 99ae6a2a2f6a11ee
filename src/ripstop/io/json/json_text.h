#pragma once

#include <initializer_list>
#include <iosfwd>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ripstop/geometry/types.h"

/// Reads JSON that people write by hand. Every fault is an InputError that says where it is and what is expected.
namespace ripstop {

/// The JSON object that a text holds. Throws InputError with `name` and the line if the text is not JSON, has a
/// key twice in one object, is nested more than 64 deep, or is not an object.
nlohmann::json read_json_object(std::istream& in, const std::string& name);

/// Throws InputError unless `object` is a JSON object with known keys only. `place` begins the message.
void require_known_keys(const nlohmann::json& object, std::initializer_list<const char*> known,
                        const std::string& place);

/// The value under `key`; nothing (or an empty list of texts) if the key is absent. Throws InputError with `place`
/// and the key for a value of the wrong type, a number that is not finite, a point that is not three numbers, and
/// a list with an empty text.
std::optional<double> number_at(const nlohmann::json& object, const char* key, const std::string& place);
std::optional<std::string> text_at(const nlohmann::json& object, const char* key, const std::string& place);
std::optional<Vec3> point_at(const nlohmann::json& object, const char* key, const std::string& place);
std::vector<std::string> texts_at(const nlohmann::json& object, const char* key, const std::string& place);

/// The point `[x, y, z]`.
Vec3 point_of(const nlohmann::json& value, const std::string& place);

}  // namespace ripstop
