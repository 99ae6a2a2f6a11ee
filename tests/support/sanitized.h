#pragma once

#include <gtest/gtest.h>

// Defined in a program that is linked with AddressSanitizer.
extern "C" void __asan_init() __attribute__((weak));

/// Skips a test that takes too long under AddressSanitizer, where a second becomes five. Shorter tests call the same.
#define RIPSTOP_TOO_LONG_SANITIZED() \
    if (&__asan_init != nullptr) GTEST_SKIP() << "too long under AddressSanitizer"
