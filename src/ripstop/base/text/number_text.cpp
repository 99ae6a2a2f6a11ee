#include "ripstop/base/text/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace ripstop {

std::optional<double> parse_double(std::string_view text) {
    if (!text.empty() && text.front() == '+') text.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::string format_fixed(double value, int decimals) {
    std::array<char, 400> buffer;
    const auto result =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
    std::string text(buffer.data(), result.ptr);
    if (text.find_first_not_of("-0.") == std::string::npos && text.front() == '-') text.erase(0, 1);
    return text;
}

std::string padded(std::size_t number, std::size_t last, std::size_t least_digits) {
    const std::string text = std::to_string(number);
    const std::size_t digits = std::max({least_digits, std::to_string(last).size(), text.size()});
    return std::string(digits - text.size(), '0') + text;
}

std::string format_shortest(double value) {
    std::array<char, 32> buffer;
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), result.ptr};
}

}  // namespace ripstop
