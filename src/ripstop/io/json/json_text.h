#pragma once

#include <initializer_list>
#include <iosfwd>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ripstop/geometry/types.h"

/// Reading JSON that people write by hand: every fault is an InputError that says where it is and what belongs there.
namespace ripstop {

/// The object that a JSON text holds. Throws InputError with `name` and the line where the text is not JSON, has a key
/// twice in one object, is nested more than 64 deep, or is something else than an object.
nlohmann::json read_json_object(std::istream& in, const std::string& name);

/// Throws InputError unless `object` is an object in which every key is a known one. `place` begins the message.
void require_known_keys(const nlohmann::json& object, std::initializer_list<const char*> known,
                        const std::string& place);

/// The value under `key`, nothing (no texts) where the key is absent. Throws InputError naming `place` and the key for
/// a value of another kind, a number that is not finite, a point that is not three numbers, a list with an empty text.
std::optional<double> number_at(const nlohmann::json& object, const char* key, const std::string& place);
std::optional<std::string> text_at(const nlohmann::json& object, const char* key, const std::string& place);
std::optional<Vec3> point_at(const nlohmann::json& object, const char* key, const std::string& place);
std::vector<std::string> texts_at(const nlohmann::json& object, const char* key, const std::string& place);

/// `[x, y, z]` as a point.
Vec3 point_of(const nlohmann::json& value, const std::string& place);

}  // namespace ripstop
