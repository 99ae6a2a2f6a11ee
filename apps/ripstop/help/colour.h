#pragma once

#include <cstdio>
#include <string>

namespace ripstop::cli {

enum class Colour { red, green, yellow, bold };

/// True if `stream` shows colours: it is a terminal that is not dumb, or CLICOLOR_FORCE is set; never if NO_COLOR
/// is set.
bool has_colours(std::FILE* stream);

std::string coloured(const std::string& text, Colour colour);

/// Colours a text: verdicts become green or red; the first words of errors and warnings become red and yellow.
/// Call it after layout, because colour codes have no width. Returns the text unchanged if `stream` has no
/// colours.
std::string with_colours(const std::string& text, std::FILE* stream);

}  // namespace ripstop::cli
