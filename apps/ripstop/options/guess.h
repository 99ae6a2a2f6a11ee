#pragma once

#include <string>
#include <vector>

namespace ripstop::cli {

/// `; did you mean --unit?` for the nearest of `known`; empty where none is near, or is the word itself.
std::string guess(const std::string& word, const std::vector<std::string>& known);

}  // namespace ripstop::cli
