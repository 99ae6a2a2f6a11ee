#include "ripstop/report/tables/csv.h"

#include <cmath>
#include <string_view>

#include "ripstop/base/text/number_text.h"
#include "ripstop/report/figures/figures.h"

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
    return std::isfinite(value) ? format_shortest(clean(value)) : "";
}

}  // namespace ripstop
