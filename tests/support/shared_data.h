#pragma once

#include <filesystem>

/// Skips the test if the folder of real input is absent; otherwise `variable` names the file in it.
#define RIPSTOP_REQUIRE_SHARED(variable, relative)                                                  \
    const std::filesystem::path variable = std::filesystem::path(RIPSTOP_SHARED_DATA) / (relative); \
    if (!std::filesystem::exists(variable)) GTEST_SKIP() << "no real input at " << variable
