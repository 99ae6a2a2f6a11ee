#include "options/dxf_options.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <cstdlib>
#include <string_view>

#include "commands/known.h"
#include "ripstop/base/error.h"
#include "ripstop/io/dxf/dxf_dialect.h"

namespace ripstop::cli {
namespace {

/// True for a calendar date, YYYY-MM-DD.
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

/// The date of SOURCE_DATE_EPOCH (reproducible-builds.org): the seconds since 1970 that a build states as its
/// time.
std::string stated_date() {
    const char* text = std::getenv("SOURCE_DATE_EPOCH");
    if (!text || !*text) return "";
    const std::string_view digits(text);
    long long seconds = 0;
    const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), seconds);
    constexpr long long last = 253402300799;  // end of the year 9999
    if (error != std::errc() || stop != digits.data() + digits.size() || seconds < 0 || seconds > last)
        throw InputError(fmt::format("SOURCE_DATE_EPOCH is \"{}\", expected the seconds since 1970; unset it", text));
    return fmt::format("{:%Y-%m-%d}", fmt::gmtime(static_cast<std::time_t>(seconds)));
}

}  // namespace

DxfFlags add_dxf_options(CLI::App& command, PieceFileOptions& given, const char* flag) {
    std::string dialects;
    std::vector<std::string> names;
    for (const DxfDialect& dialect : dxf_dialects()) {
        names.emplace_back(dialect.name);
        dialects += fmt::format("\n{:<7}{}", dialect.name, dialect.description);
    }
    DxfFlags flags;
    flags.dialect = command.add_option(flag, given.dialect, "Whose DXF it is:" + dialects)
                        ->capture_default_str()
                        ->type_name("NAME")
                        ->check(known([](const std::string& name) { dxf_dialect_named(name); }, names))
                        ->group("DXF");
    flags.grain_axis = command
                           .add_option("--grain-axis", given.grain_axis,
                                       "Axis along which the warp runs (default: x, in the dialect clo y)")
                           ->type_name("WORD")
                           ->check(one_of({"x", "y"}))
                           ->group("DXF");
    const auto read_date = [](const std::string& text) {
        if (!is_date(text)) throw InputError(fmt::format("\"{}\" is not a date, expected YYYY-MM-DD", text));
    };
    flags.date = command
                     .add_option("--date", given.date,
                                 "Creation date in PDF files and in dialects that state one (default: "
                                 "SOURCE_DATE_EPOCH, then none)")
                     ->type_name("YYYY-MM-DD")
                     ->check(known(read_date))
                     ->group("DXF");
    return flags;
}

PieceFileOptions with_date(PieceFileOptions given) {
    if (given.date.empty()) given.date = stated_date();
    return given;
}

}  // namespace ripstop::cli
