#include "support/golden.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

#include "support/outside.h"

namespace ripstop::testing {

void expect_golden(const std::string& name, const std::string& text) {
    const std::string file = std::string(RIPSTOP_SOURCE_DIR) + "/tests/data/golden/" + name;
    if (std::getenv("RIPSTOP_RENEW_GOLDEN")) write_text(file, text);
    const std::string golden = content(file);
    if (golden == text) return;
    std::istringstream old_lines(golden), new_lines(text);
    int number = 0;
    std::string before, now;
    bool is_same = true;
    while (is_same) {
        ++number;
        const bool has_old = static_cast<bool>(std::getline(old_lines, before));
        const bool has_new = static_cast<bool>(std::getline(new_lines, now));
        is_same = has_old && has_new && before == now;
    }
    ADD_FAILURE() << name << " is another from line " << number << ": was \"" << before << "\", is \"" << now << '"';
}

}  // namespace ripstop::testing
