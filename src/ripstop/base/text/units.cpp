#include "ripstop/base/text/units.h"

#include <array>
#include <utility>

#include "ripstop/base/error.h"
#include "ripstop/base/text/number_text.h"

namespace ripstop {
namespace {

constexpr std::array<std::pair<std::string_view, double>, 5> known = {
    {{"mm", 1e-3}, {"cm", 1e-2}, {"m", 1.0}, {"in", 0.0254}, {"ft", 0.3048}}};

}  // namespace

double metres_per_unit(std::string_view unit) {
    for (const auto& [name, metres] : known)
        if (name == unit) return metres;
    throw InputError("no unit \"" + std::string(unit) + "\"; known: mm, cm, m, in, ft");
}

double parse_length(std::string_view text, const std::string& what) {
    std::size_t split = text.find_first_not_of("+-.0123456789");
    // In 1e-3m the letter e starts an exponent, since digits follow it; no unit starts with e and a digit.
    if (split != std::string_view::npos && (text[split] == 'e' || text[split] == 'E'))
        if (const std::size_t digits = text.find_first_not_of("+-", split + 1);
            digits != std::string_view::npos && text[digits] >= '0' && text[digits] <= '9')
            split = text.find_first_not_of("0123456789", digits);
    const std::optional<double> number = parse_double(text.substr(0, split));
    if (!number || split == std::string_view::npos)
        throw InputError(what + ": \"" + std::string(text) +
                         "\" is not a length; write a number with its unit, such as 120mm or 0.5m");
    std::string_view unit = text.substr(split);
    while (!unit.empty() && unit.front() == ' ') unit.remove_prefix(1);
    return *number * metres_per_unit(unit);
}

}  // namespace ripstop
