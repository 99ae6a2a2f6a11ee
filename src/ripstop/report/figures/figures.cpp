#include "ripstop/report/figures/figures.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>

#include "ripstop/base/text/lower_case.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/io/text/escape.h"

namespace ripstop {

double clean(double value) {
    if (!std::isfinite(value)) return value;
    if (std::abs(value) < 1e-12) return 0;
    std::array<char, 32> buffer;
    const auto text =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::scientific, 11);
    std::from_chars(buffer.data(), text.ptr, value);
    return value;
}

double worst_chain_error(const Accuracy& accuracy) {
    double worst = 0;
    for (const ChainAccuracy& chain : accuracy.chains) {
        if (std::isnan(chain.error())) return chain.error();
        if (std::abs(chain.error()) > std::abs(worst)) worst = chain.error();
    }
    return worst;
}

std::string failing_codes(const Verdict& verdict) {
    if (!verdict.judged) return "not judged";
    std::vector<std::string> codes;
    for (const Finding& finding : verdict.findings)
        if (std::find(codes.begin(), codes.end(), finding.code) == codes.end()) codes.push_back(finding.code);
    std::string text;
    for (const std::string& code : codes) text += (text.empty() ? "" : ", ") + code;
    return text;
}

namespace {

/// Windows reserves these names for devices, with any extension.
bool is_device(const std::string& name) {
    const std::string small = lower_case(name);
    for (const char* const device : {"con", "prn", "aux", "nul"})
        if (small == device) return true;
    const bool is_port = small.size() == 4 && (small.starts_with("com") || small.starts_with("lpt"));
    return is_port && small[3] >= '0' && small[3] <= '9';
}

}  // namespace

std::vector<std::string> file_stems(const std::vector<std::string>& names) {
    std::vector<std::string> stems;
    std::set<std::string> used{"seams"};  // the name of the picture of the seams
    for (const std::string& name : names) {
        std::string base = ascii_text(name).substr(0, 80);
        for (char& c : base) {
            const bool kept = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
                              c == '_' || c == '-';
            if (!kept) c = '_';
        }
        if (base.empty() || base.front() == '.' || base.front() == '-') base.insert(0, "_");
        const std::size_t name_end = std::min(base.find('.'), base.size());
        if (is_device(base.substr(0, name_end))) base.insert(name_end, "_");
        std::string stem = base;
        for (int n = 2; !used.insert(lower_case(stem)).second; ++n) stem = base + "_" + std::to_string(n);
        stems.push_back(stem);
    }
    return stems;
}

std::vector<std::string> file_stems(const CutPlan& plan) {
    std::vector<std::string> names;
    for (const FlatTile& tile : plan.tiles) names.push_back(tile.tile.name);
    return file_stems(names);
}

std::string shown(double value, int decimals, bool with_sign) {
    if (!std::isfinite(value)) return "-";
    const std::string text = format_fixed(value, decimals);
    const bool is_zero = text.find_first_of("123456789") == std::string::npos;
    return (with_sign && value > 0 && !is_zero ? "+" : "") + text;
}

}  // namespace ripstop
