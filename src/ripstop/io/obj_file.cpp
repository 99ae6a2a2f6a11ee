#include "ripstop/io/obj_file.h"

#include <charconv>
#include <limits>
#include <map>
#include <optional>

#include "ripstop/base/error.h"
#include "ripstop/base/number_text.h"
#include "ripstop/io/text.h"

namespace ripstop {
namespace {

constexpr double largest_coordinate = 1e12;  // beyond it squares and products lose what they are compared with
constexpr int none = -1;

std::string stem_of(const std::string& name) {
    std::string stem = name.substr(name.find_last_of("/\\") + 1);
    const std::size_t dot = stem.rfind('.');
    if (dot != 0 && dot != std::string::npos) {
        std::string ending = stem.substr(dot);
        for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        if (ending == ".obj") stem.resize(dot);
    }
    return stem.empty() ? "surface" : readable_name(stem);
}

/// Reads the records of the file, line by line.
class Parser {
  public:
    Parser(std::string_view text, const std::string& name) : lines_(text) { file_.name = name; }

    ObjFile parse() {
        while (lines_.next()) read_line();
        require_indices();
        return std::move(file_);
    }

  private:
    void read_line() {
        std::string_view rest = lines_.line();
        const std::string_view key = next_word(rest);
        if (key.empty() || key.front() == '#') return;
        if (key == "o" || key == "g") {
            (key == "o" ? object_ : group_) = readable_name(trimmed(rest));
            if (key == "o") group_.clear();
            surface_ = none;
        } else if (key == "v" || key == "vt" || key == "f") {
            rest = lines_.joined();
            next_word(rest);
            if (key == "v") {
                const double x = coordinate(rest), y = coordinate(rest), z = coordinate(rest);
                file_.vertices.emplace_back(x, y, z);
            } else if (key == "vt") {
                const double u = coordinate(rest);
                const std::string_view ahead = trimmed(rest);
                file_.textures.emplace_back(u, ahead.empty() || ahead.front() == '#' ? 0 : coordinate(rest));
            } else {
                read_face(rest);
            }
        }
    }

    double coordinate(std::string_view& rest) const {
        const std::string_view word = next_word(rest);
        const std::optional<double> value = parse_double(word);
        if (!value)
            file_.refuse(lines_.number(), (word.empty() ? "a coordinate is missing" : "found " + shown(word)) +
                                              ", expected a finite number with a decimal point; export the file again");
        if (std::abs(*value) > largest_coordinate)
            file_.refuse(lines_.number(), "the coordinate " + shown(word) +
                                              " is too far out, expected at most 1e12; check the unit and the model");
        return *value;
    }

    void read_face(std::string_view rest) {
        ObjFace face{file_.corners.size(), 0, current_surface(), lines_.number()};
        for (;;) {
            const std::string_view word = next_word(rest);
            if (word.empty() || word.front() == '#') break;
            file_.corners.push_back(corner(word));
            ++face.count;
        }
        if (face.count < 3)
            file_.refuse(face.line, "a face with " + std::to_string(face.count) +
                                        (face.count == 1 ? " corner" : " corners") +
                                        ", expected at least 3; remove it or mesh the surface again");
        file_.faces.push_back(face);
    }

    /// `v`, `v/vt`, `v//vn` or `v/vt/vn`; a slash with nothing behind it is tolerated.
    ObjCorner corner(std::string_view word) const {
        const char* at = word.data();
        const char* const end = at + word.size();
        const auto number = [&](bool required) {
            long value = 0;
            const auto [stop, error] = std::from_chars(at, end, value);
            if ((error != std::errc{} && (required || stop != at)) || (stop != end && *stop != '/'))
                file_.refuse(lines_.number(),
                             "found " + shown(word) +
                                 " as a corner of a face, expected indices such as 12, 12/7 or 12/7/3; "
                                 "export the file again");
            const bool given = stop != at;
            at = stop;
            return given ? std::optional<long>(value) : std::nullopt;
        };
        const long vertex = *number(true);
        std::optional<long> texture;
        if (at != end) {
            ++at;
            texture = number(false);
        }
        if (at != end) {
            ++at;
            number(false);
        }
        if (at != end)
            file_.refuse(lines_.number(), "found " + shown(word) +
                                              " as a corner of a face, expected at most three indices (12/7/3); "
                                              "export the file again");
        return {index(vertex, file_.vertices.size(), "vertex"),
                texture ? index(*texture, file_.textures.size(), "texture coordinate") : none};
    }

    /// From 0. Positive indices are checked at the end, since the vertices may follow.
    int index(long given, std::size_t count, const char* what) const {
        const long from_zero = given > 0 ? given - 1 : given + static_cast<long>(count);
        if (given == 0 || from_zero < 0 || from_zero > std::numeric_limits<int>::max())
            refuse_index(lines_.number(), given, count, what);
        return static_cast<int>(from_zero);
    }

    [[noreturn]] void refuse_index(long line, long given, std::size_t count, const char* what) const {
        file_.refuse(line, std::string("a face names ") + what + " " + std::to_string(given) +
                               ", expected one of the " + std::to_string(count) +
                               " there are, counted from 1 (or from the end, negative); the file "
                               "is cut short or damaged, so export it again");
    }

    int current_surface() {
        if (surface_ != none) return surface_;
        std::string name = object_.empty()                       ? group_
                           : group_.empty() || group_ == object_ ? object_
                                                                 : object_ + "/" + group_;
        if (!name.empty()) file_.named = true;
        if (name.empty()) name = stem_of(file_.name);
        const auto [entry, is_new] = surface_of_name_.try_emplace(name, static_cast<int>(file_.surfaces.size()));
        if (is_new) file_.surfaces.push_back(name);
        return surface_ = entry->second;
    }

    void require_indices() const {
        std::vector<std::size_t> last_face(file_.vertices.size(), file_.faces.size());
        for (std::size_t f = 0; f < file_.faces.size(); ++f) {
            const ObjFace& face = file_.faces[f];
            for (std::size_t c = face.first; c < face.first + static_cast<std::size_t>(face.count); ++c) {
                const auto vertex = static_cast<std::size_t>(file_.corners[c].vertex);
                if (vertex >= file_.vertices.size())
                    refuse_index(face.line, static_cast<long>(vertex) + 1, file_.vertices.size(), "vertex");
                if (file_.corners[c].texture >= static_cast<long>(file_.textures.size()))
                    refuse_index(face.line, file_.corners[c].texture + 1L, file_.textures.size(), "texture coordinate");
                if (last_face[vertex] == f)
                    file_.refuse(face.line, "a face has vertex " + std::to_string(vertex + 1) +
                                                " twice, expected different corners; triangulate the face in the CAD, "
                                                "or remove it if it has no area");
                last_face[vertex] = f;
            }
        }
        if (file_.faces.empty())
            throw InputError(file_.name + ": no face (a line that starts with f) in " +
                             std::to_string(lines_.number()) +
                             " lines, expected a triangulated surface; export the surfaces as meshes");
    }

    Lines lines_;
    ObjFile file_;
    std::string object_;
    std::string group_;
    int surface_ = none;
    std::map<std::string, int> surface_of_name_;
};

}  // namespace

void ObjFile::refuse(long line, const std::string& what) const {
    throw InputError(name + ":" + std::to_string(line) + ": " + what);
}

ObjFile parse_obj(std::string_view text, const std::string& name) {
    return Parser(text, name).parse();
}

}  // namespace ripstop
