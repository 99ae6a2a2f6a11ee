#include "ripstop/io/mesh/ply_header.h"

#include <array>
#include <charconv>
#include <utility>

#include "ripstop/base/error.h"
#include "ripstop/io/text/text.h"

namespace ripstop {
namespace {

constexpr std::array<std::pair<std::string_view, PlyType>, 16> types = {{
    {"char", PlyType::int8},
    {"int8", PlyType::int8},
    {"uchar", PlyType::uint8},
    {"uint8", PlyType::uint8},
    {"short", PlyType::int16},
    {"int16", PlyType::int16},
    {"ushort", PlyType::uint16},
    {"uint16", PlyType::uint16},
    {"int", PlyType::int32},
    {"int32", PlyType::int32},
    {"uint", PlyType::uint32},
    {"uint32", PlyType::uint32},
    {"float", PlyType::float32},
    {"float32", PlyType::float32},
    {"double", PlyType::float64},
    {"float64", PlyType::float64},
}};

template <class Integer>
std::optional<Integer> integer_of(std::string_view word) {
    Integer value = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (word.empty() || error != std::errc{} || stop != word.data() + word.size()) return std::nullopt;
    return value;
}

class HeaderParser {
  public:
    HeaderParser(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

    PlyHeader parse() {
        if (!bytes_.starts_with("ply") || !find_line_end())
            throw InputError(name_ + ":1: found " + shown(bytes_.substr(0, 12)) +
                             ", expected the line ply; the file is damaged or not a PLY file, export it again");
        next_line();
        bool has_form = false;
        for (;;) {
            if (!next_line())
                refuse("the header stops here, expected end_header; the file is cut short, export it again");
            std::string_view rest = line_;
            const std::string_view key = next_word(rest);
            if (key == "end_header") break;
            if (key == "format") {
                read_form(rest);
                has_form = true;
            } else if (key == "comment") {
                read_comment(rest);
            } else if (key == "element") {
                read_element(rest);
            } else if (key == "property") {
                read_property(rest);
            } else if (!key.empty() && key != "obj_info") {
                refuse("found " + shown(key) +
                       ", expected format, comment, element, property or end_header; "
                       "the header is damaged, export the file again");
            }
        }
        if (!has_form)
            refuse("no format line in the header, expected one such as format ascii 1.0; export the file again");
        header_.size = at_;
        return std::move(header_);
    }

  private:
    [[noreturn]] void refuse(const std::string& what) const {
        throw InputError(name_ + ":" + std::to_string(header_.lines) + ": " + what);
    }

    /// The end of the first line shows how all lines end. The body begins right after the end of the last header
    /// line.
    bool find_line_end() {
        const std::size_t end = bytes_.find_first_of("\r\n");
        if (end == std::string_view::npos || !trimmed(bytes_.substr(3, end - 3)).empty()) return false;
        end_ = bytes_[end] == '\n' ? "\n" : bytes_.substr(end, 2) == "\r\n" ? "\r\n" : "\r";
        return true;
    }

    bool next_line() {
        const std::size_t end = bytes_.find(end_, at_);
        if (end == std::string_view::npos) return false;
        line_ = bytes_.substr(at_, end - at_);
        at_ = end + end_.size();
        ++header_.lines;
        return true;
    }

    void read_form(std::string_view rest) {
        const std::string_view form = next_word(rest);
        const std::string_view version = next_word(rest);
        if (form == "ascii") {
            header_.form = PlyForm::ascii;
        } else if (form == "binary_little_endian") {
            header_.form = PlyForm::little_endian;
        } else if (form == "binary_big_endian") {
            header_.form = PlyForm::big_endian;
        } else {
            refuse("found the format " + shown(form) +
                   ", expected ascii, binary_little_endian or binary_big_endian; export the file again");
        }
        if (version != "1.0") refuse("found the version " + shown(version) + ", expected 1.0; export the file again");
    }

    /// Reads `comment unit mm` and `comment tile 3 G01P02`; ignores other comments.
    void read_comment(std::string_view rest) {
        const std::string_view key = next_word(rest);
        if (key == "unit" || key == "units") {
            const std::string unit(trimmed(rest));
            try {
                header_.unit = LengthUnit{unit, metres_per_unit(unit)};
            } catch (const InputError& error) {
                header_.remarks.push_back(name_ + ":" + std::to_string(header_.lines) +
                                          ": the file's unit is ignored: " + error.what());
            }
        } else if (key == "tile") {
            const auto number = integer_of<std::int64_t>(next_word(rest));
            const std::string name = readable_name(trimmed(rest));
            if (number && !name.empty()) header_.names.emplace(*number, name);
        }
    }

    void read_element(std::string_view rest) {
        const std::string_view name = next_word(rest);
        const std::string_view count = next_word(rest);
        const auto number = integer_of<std::uint64_t>(count);
        if (name.empty() || !number)
            refuse("found the count " + shown(count) + " of the element " + shown(name) +
                   ", expected a number from 0; export the file again");
        header_.elements.push_back({std::string(name), *number});
    }

    PlyType type_of(std::string_view word) const {
        for (const auto& [name, type] : types)
            if (name == word) return type;
        refuse("found the type " + shown(word) +
               ", expected char, uchar, short, ushort, int, uint, float or double; export the file again");
    }

    void read_property(std::string_view rest) {
        if (header_.elements.empty())
            refuse("a property before the first element; the header is damaged, export the file again");
        PlyProperty property;
        std::string_view type = next_word(rest);
        if (type == "list") {
            property.count = type_of(next_word(rest));
            if (*property.count == PlyType::float32 || *property.count == PlyType::float64)
                refuse("a list length of floating-point type, expected an integer type; export the file again");
            type = next_word(rest);
        }
        property.type = type_of(type);
        property.name = next_word(rest);
        if (property.name.empty()) refuse("a property without a name, expected one; export the file again");
        header_.elements.back().properties.push_back(std::move(property));
    }

    std::string_view bytes_;
    const std::string& name_;
    PlyHeader header_;
    std::string_view end_;
    std::string_view line_;
    std::size_t at_ = 0;
};

}  // namespace

std::size_t size_of(PlyType type) {
    switch (type) {
        case PlyType::int8:
        case PlyType::uint8:
            return 1;
        case PlyType::int16:
        case PlyType::uint16:
            return 2;
        case PlyType::int32:
        case PlyType::uint32:
        case PlyType::float32:
            return 4;
        case PlyType::float64:
            break;
    }
    return 8;
}

PlyHeader read_ply_header(std::string_view bytes, const std::string& name) {
    return HeaderParser(bytes, name).parse();
}

}  // namespace ripstop
