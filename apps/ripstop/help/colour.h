#pragma once

#include <cstdio>
#include <string>

namespace ripstop::cli {

enum class Colour { red, green, yellow, bold };

/// Whether `stream` shows colours: a terminal that is not dumb, or CLICOLOR_FORCE; never under NO_COLOR.
bool has_colours(std::FILE* stream);

std::string coloured(const std::string& text, Colour colour);

/// Text that is laid out already, so that colours have no width, its verdicts green or red, and the words that errors and
/// warnings begin with red and yellow. As it is where `stream` has no colours.
std::string with_colours(const std::string& text, std::FILE* stream);

}  // namespace ripstop::cli
