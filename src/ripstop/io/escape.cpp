#include "ripstop/io/escape.h"

#include <vector>

namespace ripstop {
namespace {

constexpr char32_t replacement = 0xFFFD;

/// The code points; a byte that starts no valid sequence gives one replacement character.
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

/// The letter under the accent, U+00C0 to U+017F; `?` where there is none.
constexpr std::string_view base_letters =
    "AAAAAAACEEEEIIIIDNOOOOOxOUUUUYTsaaaaaaaceeeeiiiidnooooo/ouuuuyty"
    "AaAaAaCcCcCcCcDdDdEeEeEeEeEeGgGgGgGgHhHhIiIiIiIiIiJjJjKkkLlLlLlLlLl"
    "NnNnNnnNnOoOoOoOoRrRrRrSsSsSsSsTtTtTtUuUuUuUuUuUuWwYyYZzZzZzs";
static_assert(base_letters.size() == 0x180 - 0xC0);

}  // namespace

std::string ascii_text(std::string_view utf8) {
    std::string result;
    for (const char32_t code : decode(utf8)) {
        if (code < 0x20 || code == 0x7F)
            result += ' ';
        else if (code < 0x7F)
            result += static_cast<char>(code);
        else if (code >= 0xC0 && code < 0x180)
            result += base_letters[code - 0xC0];
        else
            result += '?';
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
