#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <regex>

#include "drawing.h"
#include "ripstop/base/error.h"

namespace ripstop::cad {
namespace {

constexpr std::size_t section = 72;  // column of an IGES line with the letter of its section

/// The last two lines that are not blank, the last one first; empty strings if there are fewer.
std::array<std::string, 2> last_lines(std::istream& in) {
    std::array<std::string, 2> last;
    for (std::string line; std::getline(in, line);)
        if (const std::size_t end = line.find_last_not_of(" \r\t"); end != std::string::npos) {
            last[1] = std::move(last[0]);
            last[0] = line.substr(0, end + 1);
        }
    return last;
}

std::string without_blanks(std::string text) {
    std::erase_if(text, [](unsigned char c) { return std::isspace(c) != 0; });
    return text;
}

bool in_section(const std::string& line, char letter) {
    return line.size() > section && line[section] == letter;
}

/// True if a parameter of an IGES file is a number that cannot be a length. Exponents may begin with D.
bool is_unbearable(std::string parameter) {
    parameter = without_blanks(std::move(parameter));
    std::replace_if(
        parameter.begin(), parameter.end(), [](char c) { return c == 'D' || c == 'd'; }, 'e');
    char* end = nullptr;
    const double number = std::strtod(parameter.c_str(), &end);
    return !parameter.empty() && *end == '\0' && !(std::abs(number) < largest_coordinate);
}

void require_parameters(const std::string& line, int number, const std::string& file) {
    std::size_t begin = 0;
    const std::string data = line.substr(0, 64);
    while (begin < data.size()) {
        const std::size_t end = std::min(data.find_first_of(",;", begin), data.size());
        const std::string parameter = data.substr(begin, end - begin);
        if (is_unbearable(parameter)) throw InputError(unbearable(file + ":" + std::to_string(number), parameter));
        begin = end + 1;
    }
}

}  // namespace

std::string unbearable(const std::string& place, const std::string& number) {
    return place + ": a coordinate is " + without_blanks(number) +
           ", expected a number below 1e12; repair it in the CAD and export again";
}

void require_whole_step(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::string text, last;
    std::getline(in, text, ';');
    if (without_blanks(text).find("ISO-10303-21") == std::string::npos)
        throw InputError(file.string() + ": not a whole STEP file (ISO 10303-21); export it again");
    while (std::getline(in, text, ';'))
        if (!without_blanks(text).empty()) last = without_blanks(text);
    if (last.find("END-ISO-10303-21") == std::string::npos)
        throw InputError(file.string() +
                         ": not a whole STEP file, it is cut short (no END-ISO-10303-21); export it again");
}

void require_whole_iges(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::string last;
    int number = 0;
    for (std::string line; std::getline(in, line);) {
        if (++number == 1 && !in_section(line, 'S'))
            throw InputError(file.string() +
                             ":1: not an IGES file, which begins with an S in column 73; export it again, "
                             "or export STEP");
        if (in_section(line, 'P')) require_parameters(line, number, file.string());
        if (line.find_first_not_of(" \r\t") != std::string::npos) last = std::move(line);
    }
    if (!in_section(last, 'T'))
        throw InputError(file.string() +
                         ": not a whole IGES file, it is cut short (no T in column 73 of its last line); "
                         "export it again, or export STEP");
}

void require_whole_brep(const std::filesystem::path& file) {
    // The reference to the whole shape, `+1 0`, follows the last list of parts, which ends with an asterisk. The
    // kernel reads for ever past the end of a truncated file.
    std::ifstream in(file, std::ios::binary);
    const auto [last, before] = last_lines(in);
    if (!std::regex_match(last, std::regex("[-+ie][0-9]+ [0-9]+")) || !before.ends_with('*'))
        throw InputError(file.string() + ": not a whole BREP file of Open CASCADE; write it again, or export STEP");
}

}  // namespace ripstop::cad
