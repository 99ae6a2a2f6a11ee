#pragma once

#include <string_view>

namespace ripstop {

/// Whether `pattern` matches the whole `text`: `*` matches any run of characters (also none, also `/`), `?` matches
/// one character (UTF-8), everything else matches itself. Case matters. O(pattern x text) at worst.
bool glob_match(std::string_view pattern, std::string_view text);

}  // namespace ripstop
