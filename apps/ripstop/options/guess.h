#pragma once

#include <string>
#include <vector>

namespace ripstop::cli {

/// The hint `; did you mean --unit?` for the nearest of `known`; empty if none is near, or if the word is among
/// them.
std::string guess(const std::string& word, const std::vector<std::string>& known);

}  // namespace ripstop::cli
