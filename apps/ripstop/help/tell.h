#pragma once

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <string>
#include <utility>

#include "help/colour.h"

namespace ripstop::cli {

/// Prints on stderr. A failure to print is ignored.
inline void tell(const std::string& text) {
    std::fputs(with_colours(text, stderr).c_str(), stderr);
}

/// The error number of the last failed write to stdout; 0 if all succeeded.
inline int& output_error() {
    static int error = 0;
    return error;
}

/// Prints a result on stdout as it is. `main` checks whether it was written.
inline void print_text(const std::string& text) {
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) output_error() = errno;
}

/// Prints a result for people, with colours on a terminal.
inline void show(const std::string& text) {
    print_text(with_colours(text, stdout));
}

template <class... Arguments>
void print(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    print_text(fmt::format(format, std::forward<Arguments>(arguments)...));
}

}  // namespace ripstop::cli
