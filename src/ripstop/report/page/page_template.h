#pragma once

#include <string_view>

namespace ripstop {

/// The page built from apps/report. It contains the words `RIPSTOP_TITLE`, `RIPSTOP_SUMMARY`, `RIPSTOP_REPORT`,
/// `RIPSTOP_SHAPES` and `RIPSTOP_ROLL` once each, as slots for a report's own texts. Empty if the program was built
/// without it (no Node.js, -DRIPSTOP_REPORT=OFF).
std::string_view page_template();

}  // namespace ripstop
