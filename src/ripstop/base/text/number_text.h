#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace ripstop {

/// The finite number that `text` spells in full, with a decimal point whatever the locale; nothing for anything else
/// (empty, trailing characters, nan, inf, out of range). A leading '+' is accepted.
std::optional<double> parse_double(std::string_view text);

/// `value` with `decimals` digits after the point, locale-free, never "-0.000".
std::string format_fixed(double value, int decimals);

/// The shortest text that reads back as exactly `value`.
std::string format_shortest(double value);

}  // namespace ripstop
