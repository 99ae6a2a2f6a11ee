#include "ripstop/report/figures/text_table.h"

#include <algorithm>

#include "ripstop/base/text/utf8.h"

namespace ripstop {
namespace {

std::size_t width(const std::string& utf8) {
    return static_cast<std::size_t>(std::count_if(utf8.begin(), utf8.end(), starts_letter));
}

}  // namespace

std::string aligned_table(const std::vector<TextRow>& rows, std::size_t words) {
    if (rows.empty()) return "";
    std::vector<std::size_t> widths(rows.front().size(), 0);
    for (const TextRow& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width(row[i]));
    std::string text;
    for (const TextRow& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string blanks(widths[i] - width(row[i]), ' ');
            const bool is_last = i + 1 == row.size();
            text += is_last ? row[i] + "\n" : (i < words ? row[i] + blanks : blanks + row[i]) + "  ";
        }
    return text;
}

std::string shortened(const std::string& utf8) {
    constexpr std::size_t longest = 32;
    if (width(utf8) <= longest) return utf8;
    std::string text;
    for (std::size_t i = 0; width(text) < longest || !starts_letter(utf8[i]); ++i) text += utf8[i];
    return text.substr(0, text.find_last_not_of(' ') + 1) + "…";
}

}  // namespace ripstop
