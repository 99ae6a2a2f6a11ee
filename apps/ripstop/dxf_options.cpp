#include "dxf_options.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <cstdlib>
#include <string_view>

#include "ripstop/base/error.h"
#include "ripstop/io/dxf_dialect.h"

namespace ripstop::cli {
namespace {

/// YYYY-MM-DD of a day that was or will be.
bool is_date(std::string_view text) {
    if (text.size() != 10 || text[4] != '-' || text[7] != '-') return false;
    int part[3] = {};
    const std::string_view digits[] = {text.substr(0, 4), text.substr(5, 2), text.substr(8, 2)};
    for (int i = 0; i < 3; ++i) {
        const char* end = digits[i].data() + digits[i].size();
        const auto [stop, error] = std::from_chars(digits[i].data(), end, part[i]);
        if (error != std::errc() || stop != end || part[i] < 1) return false;
    }
    return std::chrono::year_month_day(std::chrono::year(part[0]), std::chrono::month(static_cast<unsigned>(part[1])),
                                       std::chrono::day(static_cast<unsigned>(part[2])))
        .ok();
}

/// As reproducible-builds.org has it: the seconds since 1970 that a build is to state as its time.
std::string stated_date() {
    const char* text = std::getenv("SOURCE_DATE_EPOCH");
    if (!text || !*text) return "";
    const std::string_view digits(text);
    long long seconds = 0;
    const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), seconds);
    constexpr long long last = 253402300799;  // of the year 9999
    if (error != std::errc() || stop != digits.data() + digits.size() || seconds < 0 || seconds > last)
        throw InputError(fmt::format("SOURCE_DATE_EPOCH is \"{}\", expected the seconds since 1970; unset it", text));
    return fmt::format("{:%Y-%m-%d}", fmt::gmtime(static_cast<std::time_t>(seconds)));
}

}  // namespace

void add_dxf_options(CLI::App& command, PieceFileOptions& given, const char* flag) {
    std::string known;
    for (const DxfDialect& dialect : dxf_dialects())
        known += fmt::format("\n{:<7}{}", dialect.name, dialect.description);
    command.add_option(flag, given.dialect, "Of the DXF files:" + known)->capture_default_str()->group("DXF");
    command
        .add_option("--grain-axis", given.grain_axis,
                    "Along which the warp runs in the DXF: x or y (default: x; in the dialect clo: y)")
        ->check(CLI::IsMember({"x", "y"}))
        ->group("DXF");
    command
        .add_option("--date", given.date,
                    "YYYY-MM-DD, the creation date in dialects that state one (else SOURCE_DATE_EPOCH, else none)")
        ->group("DXF");
}

PieceFileOptions dxf_options(PieceFileOptions given) {
    dxf_dialect_named(given.dialect);
    if (given.date.empty()) given.date = stated_date();
    if (!given.date.empty() && !is_date(given.date))
        throw InputError(fmt::format("--date {}: no date, expected YYYY-MM-DD", given.date));
    return given;
}

}  // namespace ripstop::cli
