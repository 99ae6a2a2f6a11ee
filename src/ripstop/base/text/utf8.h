#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace ripstop {

/// Whether this byte of a UTF-8 text starts a letter: it is none of the bytes 10xxxxxx that continue one (RFC 3629).
inline bool starts_letter(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0) != 0x80;
}

/// The number of letters (code points) of a UTF-8 text.
inline std::size_t letters_in(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), starts_letter));
}

}  // namespace ripstop
