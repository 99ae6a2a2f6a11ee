#include "ripstop/io/dxf/dxf_tags.h"

#include <iconv.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "ripstop/base/error.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/io/text/text.h"

namespace ripstop {
namespace {

constexpr double largest_group_value = 1e9;

[[noreturn]] void refuse(const std::string& name, long line, const std::string& what) {
    throw InputError(name + ":" + std::to_string(line) + ": " + what);
}

std::optional<int> parse_code(std::string_view text) {
    int code = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), code);
    if (error != std::errc() || stop != text.data() + text.size() || code < -5 || code > 1071) return std::nullopt;
    return code;
}

/// Returns nothing if the bytes are invalid in this code page.
std::optional<std::string> converted_to_utf8(std::string bytes, const std::string& code_page) {
    const iconv_t converter = iconv_open("UTF-8", code_page.c_str());
    // NOLINTNEXTLINE: POSIX defines the error value this way
    if (converter == reinterpret_cast<iconv_t>(-1)) return std::nullopt;
    const std::size_t growth = code_page == "UTF-8" ? 1 : 3;
    std::string text(growth * bytes.size() + 4, '\0');
    char *from = bytes.data(), *to = text.data();
    std::size_t left = bytes.size(), room = text.size();
    const bool is_done = iconv(converter, &from, &left, &to, &room) != static_cast<std::size_t>(-1) && left == 0;
    iconv_close(converter);
    if (!is_done) return std::nullopt;
    text.resize(text.size() - room);
    return text;
}

/// The iconv name of $DWGCODEPAGE: `ANSI_1252` gives CP1252, `dos850` CP850; empty if the file names none.
std::string code_page_of(std::string_view text) {
    const std::size_t at = text.find("$DWGCODEPAGE");
    if (at == std::string_view::npos) return {};
    Lines lines(text.substr(at, 100));
    for (int i = 0; i < 3; ++i)
        if (!lines.next()) return {};
    const std::string_view value = trimmed(lines.line());
    const std::size_t digits = value.find_first_of("0123456789");
    return digits == std::string_view::npos ? std::string() : "CP" + std::string(value.substr(digits));
}

void append_utf8(std::string& text, unsigned code) {
    if (code < 0x80) {
        text += static_cast<char>(code);
    } else if (code < 0x800) {
        text += static_cast<char>(0xC0 | code >> 6);
        text += static_cast<char>(0x80 | (code & 0x3F));
    } else {
        text += static_cast<char>(0xE0 | code >> 12);
        text += static_cast<char>(0x80 | (code >> 6 & 0x3F));
        text += static_cast<char>(0x80 | (code & 0x3F));
    }
}

std::string with_letters_of_codes(const std::string& text) {
    std::string found;
    std::size_t done = 0;
    for (std::size_t at; (at = text.find("\\U+", done)) != std::string::npos;) {
        unsigned code = 0;
        const char* const digits = text.data() + at + 3;
        const char* const end = digits + std::min<std::size_t>(4, text.size() - at - 3);
        const bool is_code = std::from_chars(digits, end, code, 16).ptr == digits + 4;
        const bool is_letter = is_code && code > 0x20 && (code < 0xD800 || code > 0xDFFF);
        found.append(text, done, at - done + (is_letter ? 0 : 3));
        if (is_letter) append_utf8(found, code);
        done = at + (is_letter ? 7 : 3);
    }
    return found.append(text, done);
}

unsigned capital_of(unsigned code) {
    const auto is_in = [code](unsigned first, unsigned last) { return code >= first && code <= last; };
    if (is_in('a', 'z') || (is_in(0xE0, 0xFE) && code != 0xF7) || (is_in(0x3B1, 0x3C9) && code != 0x3C2) ||
        is_in(0x430, 0x44F))
        return code - 0x20;
    if (is_in(0x450, 0x45F)) return code - 0x50;
    // Accented Greek letters.
    if (code == 0x3AC) return 0x386;
    if (is_in(0x3AD, 0x3AF)) return code - 0x25;
    if (code == 0x3CC) return 0x38C;
    if (is_in(0x3CD, 0x3CE)) return code - 0x3F;
    const bool is_second = code % 2 == 1;  // capitals and small letters alternate
    if ((is_in(0x100, 0x137) || is_in(0x14A, 0x177)) && is_second) return code - 1;
    if ((is_in(0x139, 0x148) || is_in(0x179, 0x17E)) && !is_second) return code - 1;
    return code;
}

}  // namespace

std::string dxf_text(std::string bytes, const std::string& name) {
    std::string text = text_of(std::move(bytes), name);
    const bool is_ascii =
        std::all_of(text.begin(), text.end(), [](char c) { return static_cast<signed char>(c) >= 0; });
    if (!is_ascii && !converted_to_utf8(text, "UTF-8"))
        if (std::optional<std::string> converted = converted_to_utf8(text, code_page_of(text)))
            text = std::move(*converted);
    return text.find("\\U+") == std::string::npos ? text : with_letters_of_codes(text);
}

std::string dxf_key(std::string_view symbol) {
    const std::string name = readable_name(symbol);
    std::string key;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const auto byte = static_cast<unsigned char>(name[i]);
        const bool is_of_two = (byte & 0xE0) == 0xC0 && i + 1 < name.size();
        if (is_of_two)
            append_utf8(key, capital_of((byte & 0x1Fu) << 6 | (static_cast<unsigned char>(name[++i]) & 0x3Fu)));
        else
            key += static_cast<char>(byte < 0x80 ? capital_of(byte) : byte);
    }
    return key;
}

void require_ascii_dxf(std::string_view bytes, const std::string& name) {
    if (bytes.starts_with("AutoCAD Binary DXF")) refuse(name, 1, "a binary DXF, expected ASCII; save it as ASCII DXF");
    if (bytes.starts_with("AC10")) refuse(name, 1, "a DWG, expected a DXF; save it as ASCII DXF");
}

std::vector<DxfTag> read_dxf_tags(std::string_view text, const std::string& name) {
    std::vector<DxfTag> tags;
    Lines lines(text);
    while (lines.next()) {
        const std::string_view word = trimmed(lines.line());
        const long line = lines.number();
        const std::optional<int> code = parse_code(word);
        if (!code)
            refuse(name, line,
                   shown(word) +
                       " in place of a group code, expected a whole number; the file is damaged or not a DXF file, "
                       "export it again");
        if (!lines.next()) refuse(name, line, "the file ends after a group code, expected its value; export it again");
        const bool is_late_comment = *code == 999 && !tags.empty() && tags.back().code != 999;
        if (is_late_comment) continue;
        tags.push_back({*code, line, trimmed(lines.line())});
        if (*code == 0 && tags.back().value == "EOF") return tags;
    }
    refuse(name, lines.number(), "the file ends without EOF, so a part of it is missing; export it again");
}

const DxfTag* DxfEntity::find(int code) const {
    for (const DxfTag& tag : tags_.subspan(1)) {
        if (tag.code == code) return &tag;
        if (tag.code == 101) break;
    }
    return nullptr;
}

std::string_view DxfEntity::text(int code) const {
    const DxfTag* tag = find(code);
    return tag ? tag->value : std::string_view();
}

std::string DxfEntity::layer() const {
    const std::string_view layer = text(8);
    return layer.empty() ? "0" : readable_name(layer);
}

double DxfEntity::number(const DxfTag& tag) const {
    const std::optional<double> value = parse_double(tag.value);
    if (!value || std::abs(*value) > largest_group_value)
        refuse(name_, tag.line + 1,
               shown(tag.value) + " in a " + std::string(type().substr(0, 20)) +
                   ", expected a number within 1e9; export the drawing again");
    return *value;
}

double DxfEntity::number(int code, double otherwise) const {
    const DxfTag* tag = find(code);
    return tag ? number(*tag) : otherwise;
}

int DxfEntity::flags(int code) const {
    return static_cast<int>(number(code));
}

DxfEntity first_entity(DxfTagSpan tags, const std::string& name) {
    std::size_t count = 1;
    while (count < tags.size() && tags[count].code != 0) ++count;
    return {tags.first(count), name};
}

}  // namespace ripstop
