#pragma once

#include <string>
#include <string_view>

namespace ripstop {

/// The text with A to Z in lower case and all other characters unchanged, whatever the locale.
std::string lower_case(std::string_view text);

}  // namespace ripstop
