#pragma once

#include <string_view>

namespace ripstop {

/// Whether `text` as a whole is what `pattern` describes: `*` stands for any run of characters (also none, also `/`),
/// `?` for one character (UTF-8), everything else for itself; upper and lower case differ. O(pattern x text) at worst.
bool glob_match(std::string_view pattern, std::string_view text);

}  // namespace ripstop
