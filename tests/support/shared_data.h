#pragma once

#include <filesystem>

/// Skips the test where the folder of real input is absent; otherwise `path` names the file in it.
#define RIPSTOP_REQUIRE_SHARED(path, relative)                                                \
    const std::filesystem::path path = std::filesystem::path(RIPSTOP_SHARED_DATA) / relative; \
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "no real input at " << path
