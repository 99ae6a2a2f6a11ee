#include "ripstop/report/csv.h"

#include <cmath>

#include "ripstop/base/number_text.h"
#include "ripstop/report/figures.h"

namespace ripstop {
namespace {

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string result = "\"";
    for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + "\"";
}

}  // namespace

void add_csv_line(std::string& text, const std::vector<std::string>& fields) {
    for (std::size_t i = 0; i < fields.size(); ++i) text += (i > 0 ? "," : "") + quoted(fields[i]);
    text += "\n";
}

std::string csv_figure(double value) {
    return std::isfinite(value) ? format_shortest(clean(value)) : "";
}

}  // namespace ripstop
