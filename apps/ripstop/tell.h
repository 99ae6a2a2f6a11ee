#pragma once

#include <cstdio>
#include <string>

#include "colour.h"

namespace ripstop::cli {

/// Prints on stderr. That nobody can read it there is no reason to fail.
inline void tell(const std::string& text) {
    std::fputs(with_colours(text, stderr).c_str(), stderr);
}

/// Prints a result that a person reads on stdout; `main` asks whether it arrived.
inline void show(const std::string& text) {
    const std::string shown = with_colours(text, stdout);
    std::fwrite(shown.data(), 1, shown.size(), stdout);
}

}  // namespace ripstop::cli
