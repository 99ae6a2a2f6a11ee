#include "ripstop/report/tables/csv.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "ripstop/base/text/number_text.h"

namespace ripstop {
namespace {

/// Spreadsheets evaluate a cell that begins like a formula, quoted or not, unless it is a number. An apostrophe
/// makes it text.
std::string as_text(const std::string& field) {
    const bool is_formula =
        !field.empty() && std::string_view("=+-@\t\r").find(field.front()) != std::string_view::npos;
    return is_formula && !parse_double(field) ? "'" + field : field;
}

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string result = "\"";
    for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + "\"";
}

}  // namespace

void add_csv_line(std::string& text, const std::vector<std::string>& fields) {
    for (std::size_t i = 0; i < fields.size(); ++i) text += (i > 0 ? "," : "") + quoted(as_text(fields[i]));
    text += "\n";
}

std::string csv_figure(double value) {
    if (!std::isfinite(value)) return "";
    constexpr int decimals = 6, digits = 7;
    const double size = std::abs(value);
    const int before_point = size >= 10 ? static_cast<int>(std::log10(size)) : 0;
    const int shown = std::clamp(digits - 1 - before_point, 0, decimals);
    std::string text = format_fixed(value, shown);
    if (text.find('.') == std::string::npos) return text;
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

}  // namespace ripstop
