#include "help/colour.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace ripstop::cli {
namespace {

bool is_set(const char* name) {
    const char* value = std::getenv(name);
    return value && *value;
}

struct Opening {
    std::string_view words;
    Colour colour;
};

/// Words at the start of a line that get a colour.
constexpr Opening openings[] = {{"ripstop:", Colour::red}, {"Warning:", Colour::yellow},
                                {"WRONG", Colour::red},    {"not laid", Colour::red},
                                {"Sound:", Colour::green}, {"No piece changed", Colour::green}};

/// Parses `72 of 72 tiles manufacturable`: the length of the count, and whether it covers all; 0 if the line has
/// no such count.
std::size_t count_length(const std::string& line, bool& all) {
    int good = 0, of = 0, read = 0;
    if (std::sscanf(line.c_str(), "%d of %d %n", &good, &of, &read) != 2 || read == 0) return 0;
    all = good == of;
    for (const std::string_view end : {" manufacturable", " agree"})
        if (const std::size_t at = line.find(end); at != std::string::npos) return at + end.size();
    return 0;
}

std::string coloured_line(const std::string& line) {
    const auto split = [&line](std::size_t from, std::size_t to, Colour colour) {
        return line.substr(0, from) + coloured(line.substr(from, to - from), colour) + line.substr(to);
    };
    for (const Opening& opening : openings)
        if (line.starts_with(opening.words)) return split(0, opening.words.size(), opening.colour);
    if (line.starts_with("verdict  "))
        return split(line.find_first_not_of(' ', 7), line.size(),
                     line.ends_with("not sound") ? Colour::red : Colour::green);
    if (line.ends_with("wrong with this envelope.")) return split(0, line.size(), Colour::red);
    if (line.ends_with("  ok")) return split(line.size() - 2, line.size(), Colour::green);
    if (const std::size_t no = line.find("  no: "); no != std::string::npos)
        return split(no + 2, line.size(), Colour::red);
    bool all = false;
    if (const std::size_t end = count_length(line, all); end > 0)
        return split(0, end, all ? Colour::green : Colour::red);
    return line;
}

}  // namespace

bool has_colours(std::FILE* stream) {
    if (is_set("NO_COLOR")) return false;
    if (is_set("CLICOLOR_FORCE") && std::string_view(std::getenv("CLICOLOR_FORCE")) != "0") return true;
    return isatty(fileno(stream)) && !(is_set("TERM") && std::string_view(std::getenv("TERM")) == "dumb");
}

std::string coloured(const std::string& text, Colour colour) {
    const char* code = colour == Colour::red      ? "31"
                       : colour == Colour::green  ? "32"
                       : colour == Colour::yellow ? "33"
                                                  : "1";
    return std::string("\033[") + code + "m" + text + "\033[0m";
}

std::string with_colours(const std::string& text, std::FILE* stream) {
    if (!has_colours(stream)) return text;
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        result += coloured_line(text.substr(at, end - at));
        if (end < text.size()) result += '\n';
        at = end + 1;
    }
    return result;
}

}  // namespace ripstop::cli
