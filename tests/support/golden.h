#pragma once

#include <string>

namespace ripstop::testing {

/// Fails where `text` is not what tests/data/golden/NAME holds, with the first line that differs. The new text is then in the
/// tests' temporary folder; look at it, drawn, before it takes the old one's place.
void expect_golden(const std::string& name, const std::string& text);

}  // namespace ripstop::testing
