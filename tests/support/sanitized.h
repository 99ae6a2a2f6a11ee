#pragma once

#include <gtest/gtest.h>

// Defined in a program that is linked with AddressSanitizer.
extern "C" void __asan_init() __attribute__((weak));

/// Skips a test that takes too long under AddressSanitizer, which makes it about five times slower. Use it only if
/// shorter tests call the same code.
#define RIPSTOP_TOO_LONG_SANITIZED() \
    if (&__asan_init != nullptr) GTEST_SKIP() << "too long under AddressSanitizer"
