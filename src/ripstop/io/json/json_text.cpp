#include "ripstop/io/json/json_text.h"

#include <cmath>
#include <istream>
#include <set>
#include <vector>

#include "ripstop/base/error.h"
#include "ripstop/io/text/text.h"

namespace ripstop {
namespace {

using nlohmann::json;

constexpr int deepest_value =
    64;  // our files are 5 deep; a value's text, copy and destructor need stack for each level

/// Finds the first duplicate key of an object: the parser would silently take the last value.
class DuplicateKeys {
  public:
    bool see(json::parse_event_t event, const json& value) {
        if (event == json::parse_event_t::object_start) open_.emplace_back();
        if (event == json::parse_event_t::object_end) open_.pop_back();
        if (event == json::parse_event_t::key && first_.empty() &&
            !open_.back().insert(value.get<std::string>()).second)
            first_ = shown(value.get<std::string>());
        return true;
    }
    const std::string& first() const { return first_; }

  private:
    std::vector<std::set<std::string>> open_;
    std::string first_;
};

std::string found(const json& value) {
    return shown(value.dump(-1, ' ', false, json::error_handler_t::replace));
}

}  // namespace

json read_json_object(std::istream& in, const std::string& name) {
    const std::string text = read_text(in, name);
    DuplicateKeys duplicates;
    json object;
    try {
        object = json::parse(text, [&](int depth, json::parse_event_t event, json& value) {
            if (depth > deepest_value)
                throw InputError(name + ": lists and objects are nested more than " + std::to_string(deepest_value) +
                                 " deep, expected a few levels; this is a different kind of file");
            return duplicates.see(event, value);
        });
    } catch (const json::parse_error& error) {
        const std::size_t at = std::min(text.size(), error.byte > 0 ? error.byte - 1 : 0);
        const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
        throw InputError(name + ":" + std::to_string(line) + ": not JSON from " +
                         (at < text.size() ? shown(trimmed(std::string_view(text).substr(at, 20))) : "the end") +
                         " on, expected an object such as {\"key\": 1.5}; check quotes, commas and brackets before it");
    } catch (const json::exception&) {
        throw InputError(name + ": a number is out of range, expected one below 1e308; correct it");
    }
    if (!duplicates.first().empty())
        throw InputError(name + ": the key " + duplicates.first() +
                         " occurs twice in one object, expected once; remove one");
    if (!object.is_object())
        throw InputError(name + ": found " + found(object) + ", expected an object such as {\"key\": 1.5}");
    return object;
}

void require_known_keys(const json& object, std::initializer_list<const char*> known, const std::string& place) {
    std::string list;
    for (const char* key : known) list += (list.empty() ? "" : ", ") + std::string(key);
    if (!object.is_object())
        throw InputError(place + ": found " + found(object) + ", expected an object with the keys " + list);
    for (const auto& [key, value] : object.items()) {
        bool is_known = false;
        for (const char* candidate : known) is_known = is_known || key == candidate;
        if (!is_known)
            throw InputError(place + ": unknown key " + shown(key) + ", expected one of: " + list +
                             "; correct or remove it");
    }
}

std::optional<double> number_at(const json& object, const char* key, const std::string& place) {
    const auto entry = object.find(key);
    if (entry == object.end()) return std::nullopt;
    if (!entry->is_number() || !std::isfinite(entry->get<double>()))
        throw InputError(place + ": " + key + " is " + found(*entry) + ", expected a number without quotes or unit");
    return entry->get<double>();
}

std::optional<std::string> text_at(const json& object, const char* key, const std::string& place) {
    const auto entry = object.find(key);
    if (entry == object.end()) return std::nullopt;
    if (!entry->is_string())
        throw InputError(place + ": " + key + " is " + found(*entry) + ", expected a text in quotes");
    return entry->get<std::string>();
}

std::optional<Vec3> point_at(const json& object, const char* key, const std::string& place) {
    const auto entry = object.find(key);
    if (entry == object.end()) return std::nullopt;
    return point_of(*entry, place + ": " + key);
}

std::vector<std::string> texts_at(const json& object, const char* key, const std::string& place) {
    const auto entry = object.find(key);
    if (entry == object.end()) return {};
    std::vector<std::string> texts;
    bool sound = entry->is_array();
    for (std::size_t i = 0; sound && i < entry->size(); ++i) {
        sound = (*entry)[i].is_string() && !(*entry)[i].get_ref<const std::string&>().empty();
        if (sound) texts.push_back((*entry)[i].get<std::string>());
    }
    if (!sound)
        throw InputError(place + ": " + key + " is " + found(*entry) + ", expected a list of texts: [\"a\", \"b\"]");
    return texts;
}

Vec3 point_of(const json& value, const std::string& place) {
    Vec3 point;
    bool sound = value.is_array() && value.size() == 3;
    for (std::size_t k = 0; sound && k < 3; ++k) {
        sound = value[k].is_number() && std::isfinite(value[k].get<double>());
        if (sound) point[static_cast<Eigen::Index>(k)] = value[k].get<double>();
    }
    if (!sound) throw InputError(place + " is " + found(value) + ", expected three numbers: [x, y, z]");
    return point;
}

}  // namespace ripstop
