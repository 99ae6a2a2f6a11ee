#include "ripstop/io/dxf_tags.h"

#include <charconv>
#include <cmath>

#include "ripstop/base/error.h"
#include "ripstop/base/number_text.h"
#include "ripstop/io/text.h"

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

}  // namespace

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
                       " where a group code belongs, expected a whole number; the file is no DXF or damaged, "
                       "so export it again");
        if (!lines.next()) refuse(name, line, "the file ends after a group code, expected its value; export it again");
        tags.push_back({*code, line, trimmed(lines.line())});
        if (*code == 0 && tags.back().value == "EOF") return tags;
    }
    refuse(name, lines.number(), "the file ends without EOF, so a part of it is missing; export it again");
}

const DxfTag* DxfEntity::find(int code) const {
    for (const DxfTag& tag : tags_.subspan(1))
        if (tag.code == code) return &tag;
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
