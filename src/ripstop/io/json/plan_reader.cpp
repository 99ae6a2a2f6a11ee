#include "ripstop/io/json/plan_reader.h"

#include <cmath>

#include "ripstop/base/error.h"
#include "ripstop/io/json/json_text.h"

namespace ripstop {

using nlohmann::json;

PlanReader::PlanReader(const json& value, std::string place) : value_(value), place_(std::move(place)) {
    if (!value_.is_object()) refuse("not an object, expected one in braces");
}

void PlanReader::refuse(const std::string& what) const {
    throw InputError(place_ + ": " + what + "; flatten the envelope again");
}

double PlanReader::number(const char* key, double most) const {
    const std::optional<double> value = number_at(value_, key, place_);
    if (value && std::abs(*value) <= most) return *value;
    refuse(std::string(key) + (std::isinf(most) ? " is missing, expected a number"
                                                : " is missing or too large, expected a number within " +
                                                      std::to_string(static_cast<long>(most))));
}

int PlanReader::whole(const char* key, double least, double most) const {
    return whole(number(key), key, least, most);
}

int PlanReader::whole(double value, const char* key, double least, double most) const {
    if (value != std::floor(value) || value < least || value > most)
        refuse(std::string(key) + " is out of range, expected a whole number from " +
               std::to_string(static_cast<long>(least)) + " to " + std::to_string(static_cast<long>(most)));
    return static_cast<int>(value);
}

bool PlanReader::flag(const char* key) const {
    const auto found = value_.find(key);
    if (found == value_.end() || !found->is_boolean()) refuse(std::string(key) + " is missing, expected true or false");
    return *found;
}

std::string PlanReader::text(const char* key) const {
    const std::optional<std::string> value = text_at(value_, key, place_);
    if (!value) refuse(std::string(key) + " is missing, expected a text");
    return *value;
}

std::string PlanReader::text_or_none(const char* key) const {
    return text_at(value_, key, place_).value_or("");
}

Vec3 PlanReader::point(const char* key) const {
    const std::optional<Vec3> value = point_at(value_, key, place_);
    if (!value) refuse(std::string(key) + " is missing, expected three numbers");
    return *value;
}

const json& PlanReader::list(const char* key) const {
    const auto found = value_.find(key);
    if (found == value_.end() || !found->is_array()) refuse(std::string(key) + " is not a list");
    return *found;
}

std::vector<double> PlanReader::numbers(const char* key) const {
    std::vector<double> result;
    for (const json& each : list(key)) {
        if (!each.is_number() || !std::isfinite(each.get<double>()))
            refuse(std::string(key) + " contains an entry that is not a number");
        result.push_back(each.get<double>());
    }
    return result;
}

std::vector<int> PlanReader::wholes(const char* key, double least, double most) const {
    std::vector<int> result;
    for (const double each : numbers(key)) result.push_back(whole(each, key, least, most));
    return result;
}

PlanReader PlanReader::at(const char* key) const {
    if (!has(key)) refuse(std::string(key) + " is missing");
    return PlanReader(value_.at(key), place_ + ", " + key);
}

PlanReader PlanReader::in(const char* key, std::size_t i) const {
    return PlanReader(list(key)[i], place_ + ", " + key + " " + std::to_string(i + 1));
}

}  // namespace ripstop
