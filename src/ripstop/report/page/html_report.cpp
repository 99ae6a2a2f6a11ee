#include "ripstop/report/page/html_report.h"

#include <zlib.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "ripstop/io/text/escape.h"
#include "ripstop/report/page/page_shapes.h"
#include "ripstop/report/page/page_template.h"
#include "ripstop/report/tables/tables.h"

namespace ripstop {
namespace {

std::string deflated(const std::string& text) {
    uLongf size = compressBound(static_cast<uLong>(text.size()));
    std::string packed(size, '\0');
    if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(text.data()),
                  static_cast<uLong>(text.size()), Z_BEST_COMPRESSION) != Z_OK)
        throw std::runtime_error("report.html: its data cannot be deflated");
    packed.resize(size);
    return packed;
}

/// What stands there for a reader without scripts: the table's last lines.
std::string summary(const CutPlan& plan) {
    return (plan.manufacturable() ? "Manufacturable.\n" : "Not manufacturable as drawn.\n") + plan_summary(plan) +
           "All figures are in report.json, tiles.csv and seams.csv beside this page.";
}

std::string xml_lines(const std::string& text) {
    std::string result;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) result += xml_text(line) + "\n";
    return result;
}

}  // namespace

std::string base64(std::string_view bytes) {
    constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        unsigned group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += k <= count ? letters[group >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

std::string html_report(const CutPlan& plan, const std::vector<PatternPiece>& pieces,
                        const std::vector<StrainMap>& strains, const std::string& report) {
    const std::string_view page = page_template();
    if (page.empty()) return {};
    const std::pair<std::string_view, std::string> parts[] = {
        {"RIPSTOP_TITLE", xml_text(plan.input_file.empty() ? "Ripstop report" : plan.input_file + ", Ripstop report")},
        {"RIPSTOP_SUMMARY", xml_lines(summary(plan))},
        {"RIPSTOP_REPORT", base64(deflated(report))},
        {"RIPSTOP_SHAPES", base64(deflated(page_shapes(plan, pieces, strains)))}};
    // In the order of the page: what a name says is never taken for one of the words.
    std::string result;
    std::size_t from = 0;
    for (const auto& [word, text] : parts) {
        const std::size_t at = page.find(word, from);
        if (at == std::string_view::npos) throw std::logic_error("the page has no place for " + std::string(word));
        result.append(page.substr(from, at - from)).append(text);
        from = at + word.size();
    }
    return result.append(page.substr(from));
}

std::string with_roll(const std::string& page, const std::string& marker_json) {
    constexpr std::string_view before = "id=\"ripstop-roll\">", after = "</script>";
    const std::size_t at = page.find(before);
    if (at == std::string::npos) return page;
    const std::size_t start = at + before.size();
    return page.substr(0, start) + base64(deflated(marker_json)) + page.substr(page.find(after, start));
}

}  // namespace ripstop
