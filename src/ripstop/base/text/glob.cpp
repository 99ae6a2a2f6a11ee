#include "ripstop/base/text/glob.h"

#include "ripstop/base/text/utf8.h"

namespace ripstop {
namespace {

/// The index of the character after the one at `i` (UTF-8).
std::size_t next_character(std::string_view text, std::size_t i) {
    ++i;
    while (i < text.size() && !starts_letter(text[i])) ++i;
    return i;
}

}  // namespace

bool glob_match(std::string_view pattern, std::string_view text) {
    std::size_t p = 0;
    std::size_t t = 0;
    std::size_t after_star = std::string_view::npos;  // where to resume in the pattern when the last star takes one
                                                      // more character
    std::size_t star_end = 0;
    while (t < text.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            after_star = ++p;
            star_end = t;
        } else if (p < pattern.size() && pattern[p] == '?') {
            ++p;
            t = next_character(text, t);
        } else if (p < pattern.size() && pattern[p] == text[t]) {
            ++p;
            ++t;
        } else if (after_star != std::string_view::npos) {
            p = after_star;
            star_end = next_character(text, star_end);
            t = star_end;
        } else {
            return false;
        }
    }
    while (p < pattern.size() && pattern[p] == '*') ++p;
    return p == pattern.size();
}

}  // namespace ripstop
