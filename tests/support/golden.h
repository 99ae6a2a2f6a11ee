#pragma once

#include <string>

namespace ripstop::testing {

/// Fails where `text` is not what tests/data/golden/NAME holds, with the first line that differs. With RIPSTOP_RENEW_GOLDEN in
/// the environment the file is written first; look at what it draws before it is committed.
void expect_golden(const std::string& name, const std::string& text);

}  // namespace ripstop::testing
