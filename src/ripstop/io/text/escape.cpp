#include "ripstop/io/text/escape.h"

#include <array>
#include <utility>
#include <vector>

#include "ripstop/base/text/lower_case.h"

namespace ripstop {
namespace {

constexpr char32_t replacement = 0xFFFD;

/// Decodes UTF-8. Each byte that starts no valid sequence gives one replacement character.
std::vector<char32_t> decode(std::string_view text) {
    std::vector<char32_t> result;
    for (std::size_t i = 0; i < text.size();) {
        const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
        const unsigned char lead = byte(i);
        const std::size_t length = lead < 0x80 ? 1 : lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
        char32_t code = lead < 0x80 ? lead : lead & (0x7Fu >> length);
        bool valid = (lead < 0x80 || lead >= 0xC2) && lead < 0xF5 && i + length <= text.size();
        for (std::size_t k = 1; valid && k < length; ++k) {
            valid = (byte(i + k) & 0xC0) == 0x80;
            code = code << 6 | (byte(i + k) & 0x3Fu);
        }
        constexpr char32_t smallest[] = {0, 0, 0x80, 0x800, 0x10000};
        valid = valid && code >= smallest[length] && code <= 0x10FFFF && !(code >= 0xD800 && code < 0xE000);
        result.push_back(valid ? code : replacement);
        i += valid ? length : 1;
    }
    return result;
}

void append_utf8(std::string& text, char32_t code) {
    const auto put = [&text](char32_t byte) { text += static_cast<char>(static_cast<unsigned char>(byte)); };
    if (code < 0x80) return put(code);
    if (code < 0x800) {
        put(0xC0 | code >> 6);
    } else {
        if (code < 0x10000) {
            put(0xE0 | code >> 12);
        } else {
            put(0xF0 | code >> 18);
            put(0x80 | (code >> 12 & 0x3F));
        }
        put(0x80 | (code >> 6 & 0x3F));
    }
    put(0x80 | (code & 0x3F));
}

/// The base letters of U+00C0 to U+017F; `?` if there is none.
constexpr std::string_view base_letters =
    "AAAAAAACEEEEIIIIDNOOOOOxOUUUUYTsaaaaaaaceeeeiiiidnooooo/ouuuuyty"
    "AaAaAaCcCcCcCcDdDdEeEeEeEeEeGgGgGgGgHhHhIiIiIiIiIiJjJjKkkLlLlLlLlLl"
    "NnNnNnnNnOoOoOoOoRrRrRrSsSsSsSsTtTtTtUuUuUuUuUuUuWwYyYZzZzZzs";
static_assert(base_letters.size() == 0x180 - 0xC0);

/// U+0391 to U+03C9; a dash if there is no letter.
constexpr std::array<std::string_view, 0x3CA - 0x391> greek = {
    "A", "V",  "G", "D",  "E",  "Z", "I", "Th", "I", "K", "L", "M", "N", "X", "O", "P", "R",  "-",  "S",
    "T", "Y",  "F", "Ch", "Ps", "O", "I", "Y",  "a", "e", "i", "i", "y", "a", "v", "g", "d",  "e",  "z",
    "i", "th", "i", "k",  "l",  "m", "n", "x",  "o", "p", "r", "s", "s", "t", "y", "f", "ch", "ps", "o"};

/// U+0410 to U+042F, the capitals; small letters follow in the same order.
constexpr std::array<std::string_view, 32> cyrillic = {"A", "B",  "V",  "G",    "D", "E", "Zh", "Z", "I",  "J", "K",
                                                       "L", "M",  "N",  "O",    "P", "R", "S",  "T", "U",  "F", "Kh",
                                                       "C", "Ch", "Sh", "Shch", "",  "Y", "",   "E", "Yu", "Ya"};

/// Other letters and marks that occur in names.
constexpr std::array<std::pair<char32_t, std::string_view>, 40> other_letters = {
    {{0xA0, " "},   {0xAB, "\""},  {0xB0, " deg"}, {0xB1, "+-"},    {0xB2, "2"},    {0xB3, "3"},  {0xB5, "u"},
     {0xB7, "."},   {0xB9, "1"},   {0xBB, "\""},   {0xDF, "ss"},    {0x386, "A"},   {0x388, "E"}, {0x389, "I"},
     {0x38A, "I"},  {0x38C, "O"},  {0x38E, "Y"},   {0x38F, "O"},    {0x390, "i"},   {0x3CA, "i"}, {0x3CB, "y"},
     {0x3CC, "o"},  {0x3CD, "y"},  {0x3CE, "o"},   {0x401, "E"},    {0x404, "Ye"},  {0x406, "I"}, {0x407, "Yi"},
     {0x451, "e"},  {0x454, "ye"}, {0x456, "i"},   {0x457, "yi"},   {0x490, "G"},   {0x491, "g"}, {0x1E9E, "SS"},
     {0x2013, "-"}, {0x2014, "-"}, {0x2019, "'"},  {0x2026, "..."}, {0x20AC, "EUR"}}};

/// The code as text, U65E5, so that names in scripts we cannot spell stay distinct.
std::string code_text(char32_t code) {
    constexpr std::string_view digits = "0123456789ABCDEF";
    std::string text = "U";
    for (int shift = code > 0xFFFFF ? 20 : code > 0xFFFF ? 16 : 12; shift >= 0; shift -= 4)
        text += digits[code >> shift & 0xF];
    return text;
}

/// The ASCII spelling of a character beyond ASCII.
std::string spelled(char32_t code) {
    for (const auto& [letter, text] : other_letters)
        if (letter == code) return std::string(text);
    if (code == replacement) return "?";
    if (code < 0xA0) return " ";                   // control characters
    if (code >= 0x300 && code < 0x370) return "";  // combining accents
    if (code >= 0xC0 && code < 0x180) return std::string(1, base_letters[code - 0xC0]);
    if (code >= 0x391 && code < 0x3CA) return std::string(greek[code - 0x391]);
    if (code >= 0x410 && code < 0x430) return std::string(cyrillic[code - 0x410]);
    if (code >= 0x430 && code < 0x450) return lower_case(cyrillic[code - 0x430]);
    return code_text(code);
}

}  // namespace

std::string ascii_text(std::string_view utf8) {
    std::string result;
    for (const char32_t code : decode(utf8)) {
        if (code < 0x20 || code == 0x7F)
            result += ' ';
        else if (code < 0x7F)
            result += static_cast<char>(code);
        else
            result += spelled(code);
    }
    return result;
}

std::string xml_text(std::string_view utf8) {
    std::string result;
    for (const char32_t code : decode(utf8)) {
        switch (code) {
            case U'&':
                result += "&amp;";
                break;
            case U'<':
                result += "&lt;";
                break;
            case U'>':
                result += "&gt;";
                break;
            case U'"':
                result += "&quot;";
                break;
            case U'\'':
                result += "&#39;";
                break;
            default:
                append_utf8(result, code < 0x20 || code == 0xFFFE || code == 0xFFFF ? replacement : code);
        }
    }
    return result;
}

}  // namespace ripstop
