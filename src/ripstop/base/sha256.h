#pragma once

#include <iosfwd>
#include <string>
#include <string_view>

namespace ripstop {

/// The SHA-256 digest [FIPS 180-4] of the bytes, as 64 lower-case hexadecimal digits. A stream is read to its end,
/// block by block.
std::string sha256(std::string_view bytes);
std::string sha256(std::istream& in);

}  // namespace ripstop
