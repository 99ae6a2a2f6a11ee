#pragma once

#include <string_view>

namespace ripstop {

/// The page that apps/report is built to, with the words `RIPSTOP_TITLE`, `RIPSTOP_SUMMARY`, `RIPSTOP_REPORT`,
/// `RIPSTOP_SHAPES` and `RIPSTOP_ROLL` once each where a report's own go. Empty where the program was built without it (no Node.js,
/// -DRIPSTOP_REPORT=OFF).
std::string_view page_template();

}  // namespace ripstop
