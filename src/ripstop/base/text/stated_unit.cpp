#include "ripstop/base/text/stated_unit.h"

#include <algorithm>
#include <string>

#include "ripstop/base/text/lower_case.h"
#include "ripstop/base/text/number_text.h"

namespace ripstop {
namespace {

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
    return text;
}

std::optional<LengthUnit> unit_named(std::string_view name) {
    for (const char* known : {"mm", "cm", "m", "in", "ft"})
        if (name == known) return LengthUnit{known, metres_per_unit(known)};
    if (name == "metric" || name == "millimeters" || name == "millimetres") return unit_named("mm");
    if (name == "english" || name == "imperial" || name == "inch" || name == "inches") return unit_named("in");
    return std::nullopt;
}

}  // namespace

std::optional<LengthUnit> unit_of_insunits(std::string_view value) {
    static constexpr std::string_view units[] = {"", "in", "ft", "", "mm", "cm", "m"};
    if (value.size() != 1 || value[0] < '0' || value[0] > '6') return std::nullopt;
    return unit_named(units[value[0] - '0']);
}

std::optional<LengthUnit> unit_of_text(std::string_view text) {
    const std::string lower = lower_case(trimmed(text));
    constexpr std::string_view key = "units:";
    if (!lower.starts_with(key)) return std::nullopt;
    return unit_named(trimmed(std::string_view(lower).substr(key.size())));
}

std::optional<StatedLength> stated_length(std::string_view text) {
    text = trimmed(text);
    const std::size_t end = text.find_last_of("0123456789.");
    if (end == std::string_view::npos) return std::nullopt;
    const std::optional<double> number = parse_double(text.substr(0, end + 1));
    if (!number) return std::nullopt;
    const std::string unit = lower_case(trimmed(text.substr(end + 1)));
    StatedLength length{*number, unit_named(unit)};
    if (unit == "pt") length = {*number / 72, unit_named("in")};
    if (unit == "pc") length = {*number / 6, unit_named("in")};
    if (!length.unit && !unit.empty() && unit != "px") return std::nullopt;
    return length;
}

}  // namespace ripstop
