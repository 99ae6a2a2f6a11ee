#include "ripstop/report/page/html_report.h"

#include <zlib.h>

#include <algorithm>
#include <array>
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

/// The text for a reader without scripts: the last lines of the table.
std::string summary(const CutPlan& plan) {
    return (plan.manufacturable() ? "Manufacturable.\n" : "Not manufacturable as drawn.\n") + plan_summary(plan) +
           "All figures are in report.json, tiles.csv and seams.csv beside this page.";
}

std::string packed(const std::string& text) {
    return base64(deflated(text));
}

/// The parts of a page with their slots, in the order of the template.
struct Slot {
    std::string_view word;
    std::string PageParts::*part;
};
constexpr std::array<Slot, 5> slots{{{"RIPSTOP_TITLE", &PageParts::title},
                                     {"RIPSTOP_SUMMARY", &PageParts::summary},
                                     {"RIPSTOP_REPORT", &PageParts::report},
                                     {"RIPSTOP_SHAPES", &PageParts::shapes},
                                     {"RIPSTOP_ROLL", &PageParts::roll}}};

/// The template's text between the slots: one piece before each, and one after the last.
std::array<std::string_view, slots.size() + 1> fixed_texts(std::string_view page) {
    std::array<std::string_view, slots.size() + 1> texts;
    std::size_t from = 0;
    for (std::size_t i = 0; i < slots.size(); ++i) {
        const std::size_t at = page.find(slots[i].word, from);
        if (at == std::string_view::npos)
            throw std::logic_error("the page has no place for " + std::string(slots[i].word));
        texts[i] = page.substr(from, at - from);
        from = at + slots[i].word.size();
    }
    texts.back() = page.substr(from);
    return texts;
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

PageParts page_parts(const CutPlan& plan, const std::vector<PatternPiece>& pieces,
                     const std::vector<StrainMap>& strains, const std::string& report) {
    return {xml_text(plan.input_file.empty() ? "Ripstop report" : plan.input_file + ", Ripstop report"),
            xml_lines(summary(plan)),
            packed(report),
            packed(page_shapes(plan, pieces, strains)),
            {}};
}

void set_roll(PageParts& page, const std::string& marker_json) {
    page.roll = packed(marker_json);
}

std::string write_page(const PageParts& page) {
    const std::string_view whole = page_template();
    if (whole.empty()) return {};
    const auto texts = fixed_texts(whole);
    std::string result(texts.front());
    for (std::size_t i = 0; i < slots.size(); ++i) result.append(page.*slots[i].part).append(texts[i + 1]);
    return result;
}

std::optional<PageParts> read_page(std::string_view text) {
    const std::string_view whole = page_template();
    if (whole.empty()) return std::nullopt;
    const auto texts = fixed_texts(whole);
    if (!text.starts_with(texts.front()) || !text.ends_with(texts.back())) return std::nullopt;
    PageParts page;
    std::size_t from = texts.front().size();
    for (std::size_t i = 0; i < slots.size(); ++i) {
        const bool is_last = i + 1 == slots.size();
        const std::size_t to = is_last ? text.size() - texts.back().size() : text.find(texts[i + 1], from);
        if (to == std::string_view::npos || to < from) return std::nullopt;
        page.*slots[i].part = text.substr(from, to - from);
        from = to + texts[i + 1].size();
    }
    return page;
}

std::string html_report(const CutPlan& plan, const std::vector<PatternPiece>& pieces,
                        const std::vector<StrainMap>& strains, const std::string& report) {
    return write_page(page_parts(plan, pieces, strains, report));
}

}  // namespace ripstop
