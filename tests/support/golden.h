#pragma once

#include <string>

namespace ripstop::testing {

/// Fails if `text` differs from tests/data/golden/NAME, with the first line that differs. If RIPSTOP_RENEW_GOLDEN
/// is set, writes the file first; look at its drawing before you commit it.
void expect_golden(const std::string& name, const std::string& text);

}  // namespace ripstop::testing
