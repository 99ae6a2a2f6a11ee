#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>

namespace ripstop {

/// The number stored at `at` in the given byte order.
template <class Number>
Number load(const char* at, std::endian order) {
    char bytes[sizeof(Number)];
    if (order == std::endian::native) {
        std::memcpy(bytes, at, sizeof(Number));
    } else {
        for (std::size_t i = 0; i < sizeof(Number); ++i) bytes[i] = at[sizeof(Number) - 1 - i];
    }
    return std::bit_cast<Number>(bytes);
}

/// Appends the bytes of a number, least significant first.
template <class Number>
void append_little_endian(std::string& text, Number number) {
    char bytes[sizeof(Number)];
    std::memcpy(bytes, &number, sizeof(Number));
    if constexpr (std::endian::native == std::endian::little) {
        text.append(bytes, sizeof(Number));
    } else {
        for (std::size_t i = sizeof(Number); i-- > 0;) text += bytes[i];
    }
}

}  // namespace ripstop
