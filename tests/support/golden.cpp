#include "support/golden.h"

#include <gtest/gtest.h>

#include <sstream>

#include "support/outside.h"

namespace ripstop::testing {

void expect_golden(const std::string& name, const std::string& text) {
    const std::string golden = content(std::string(RIPSTOP_SOURCE_DIR) + "/tests/data/golden/" + name);
    if (golden == text) return;
    const std::string written = ::testing::TempDir() + name;
    write_text(written, text);
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
    ADD_FAILURE() << name << " is another from line " << number << ": was \"" << before << "\", is \"" << now
                  << "\"; see " << written;
}

}  // namespace ripstop::testing
