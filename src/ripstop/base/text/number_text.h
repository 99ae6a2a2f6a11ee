#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace ripstop {

/// Parses the whole text as a finite number with a decimal point, whatever the locale. A leading '+' is accepted.
/// Empty for anything else: no text, trailing characters, nan, inf, out of range.
std::optional<double> parse_double(std::string_view text);

/// Formats `value` with `decimals` digits after the point, independent of the locale; never returns "-0.000".
std::string format_fixed(double value, int decimals);

/// A number padded with zeros to as many digits as the last one has, at least two: `03` of 12, `003` of 120. So names
/// sorted as text are in the order of their numbers.
std::string padded(std::size_t number, std::size_t last, std::size_t least_digits = 2);

/// The shortest text that reads back as exactly `value`.
std::string format_shortest(double value);

}  // namespace ripstop
