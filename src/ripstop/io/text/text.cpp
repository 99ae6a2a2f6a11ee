#include "ripstop/io/text/text.h"

#include <algorithm>
#include <cstdint>
#include <istream>

#include "ripstop/base/error.h"

namespace ripstop {
namespace {

constexpr std::string_view line_blanks = " \t\r\f\v";
constexpr bool is_blank_in_line(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v';
}

constexpr std::size_t largest_file = std::size_t{1} << 31;

/// The length of the UTF-8 character at the start of `text`; 0 if there is none [RFC 3629].
std::size_t utf8_length(std::string_view text) {
    const auto byte = [text](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
    const unsigned lead = byte(0);
    if (lead < 0x80) return 1;
    const std::size_t length = lead >= 0xC2 && lead < 0xE0 ? 2 : lead >= 0xE0 && lead < 0xF0 ? 3 : lead >= 0xF0 ? 4 : 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xC0) != 0x80) return 0;
    if ((lead == 0xE0 && byte(1) < 0xA0) || (lead == 0xED && byte(1) >= 0xA0) || (lead == 0xF0 && byte(1) < 0x90) ||
        (lead == 0xF4 && byte(1) >= 0x90) || lead > 0xF4)
        return 0;
    return length;
}

bool is_utf8(std::string_view text) {
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        if (length == 0) return false;
        text.remove_prefix(length);
    }
    return true;
}

/// The number of bytes left in the stream, if it can tell; else a first guess.
std::size_t rest_of(std::istream& in) {
    const auto here = in.tellg();
    if (here < 0) return 1 << 16;
    in.seekg(0, std::ios::end);
    const auto end = in.tellg();
    in.clear();
    if (end < here) return 1 << 16;
    in.seekg(here);
    return static_cast<std::size_t>(end - here);
}

}  // namespace

std::string read_bytes(std::istream& in, const std::string& name) {
    std::string text;
    std::size_t size = 0;
    while (in) {
        text.resize(size == 0 ? std::min(rest_of(in), largest_file) + 1 : 2 * size);
        in.read(text.data() + size, static_cast<std::streamsize>(text.size() - size));
        size += static_cast<std::size_t>(in.gcount());
        if (size > largest_file)
            throw InputError(name + ": the file is larger than 2 GiB, expected less; split it into several");
    }
    if (in.bad()) throw InputError(name + ": the file cannot be read to its end; check that it is a file and complete");
    text.resize(size);
    return text;
}

std::string text_of(std::string text, const std::string& name) {
    if (text.starts_with("\xFE\xFF") || text.starts_with("\xFF\xFE"))
        throw InputError(name + ":1: the text is UTF-16, expected UTF-8 or ASCII; save it as UTF-8");
    if (const std::size_t zero = text.find('\0'); zero != std::string::npos) {
        long line = 1;
        for (std::size_t i = 0; i < zero; ++i) line += text[i] == '\n';
        throw InputError(
            name + ":" + std::to_string(line) +
            ": a zero byte, expected text; the file is damaged, binary or UTF-16, so export it again as text");
    }
    if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
    return text;
}

std::string read_text(std::istream& in, const std::string& name) {
    return text_of(read_bytes(in, name), name);
}

Lines::Lines(std::string_view text) : rest_(text), end_(text.find('\n') == std::string_view::npos ? '\r' : '\n') {}

std::string_view Lines::take() {
    const std::size_t end = rest_.find(end_);
    const std::string_view line = rest_.substr(0, end);
    rest_ = end == std::string_view::npos ? std::string_view{} : rest_.substr(end + 1);
    ++taken_;
    return line;
}

bool Lines::next() {
    if (rest_.empty()) return false;
    line_ = take();
    number_ = taken_;
    return true;
}

std::string_view Lines::joined() {
    const auto continued = [](std::string_view line) {
        const std::size_t last = line.find_last_not_of(line_blanks);
        return last != std::string_view::npos && line[last] == '\\';
    };
    std::string_view part = line_;
    if (!continued(part)) return line_;
    joined_.clear();
    while (continued(part)) {
        joined_.append(part.substr(0, part.find_last_of('\\'))).append(" ");
        part = rest_.empty() ? std::string_view{} : take();
    }
    joined_.append(part);
    line_ = joined_;
    return line_;
}

std::string_view next_word(std::string_view& rest) {
    const char* const end = rest.data() + rest.size();
    const char* start = rest.data();
    while (start != end && is_blank_in_line(*start)) ++start;
    const char* stop = start;
    while (stop != end && !is_blank_in_line(*stop)) ++stop;
    rest = {stop, static_cast<std::size_t>(end - stop)};
    return {start, static_cast<std::size_t>(stop - start)};
}

std::string_view trimmed(std::string_view text) {
    const std::size_t start = text.find_first_not_of(line_blanks);
    if (start == std::string_view::npos) return {};
    return text.substr(start, text.find_last_not_of(line_blanks) - start + 1);
}

std::string readable_name(std::string_view bytes) {
    const bool utf8 = is_utf8(bytes);
    std::string name;
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte == 0x7F) {
            name += '_';
        } else if (utf8 || byte < 0x80) {
            name += c;
        } else {
            name += static_cast<char>(0xC0 | byte >> 6);
            name += static_cast<char>(0x80 | (byte & 0x3F));
        }
    }
    return name;
}

std::string shown(std::string_view found) {
    const bool whole = found.size() <= 40;
    if (!whole) {
        found = found.substr(0, 37);
        while (!found.empty() && (static_cast<unsigned char>(found.back()) & 0xC0) == 0x80) found.remove_suffix(1);
        if (!found.empty() && static_cast<unsigned char>(found.back()) >= 0xC0) found.remove_suffix(1);
    }
    return "\"" + readable_name(found) + (whole ? "\"" : "...\"");
}

}  // namespace ripstop
