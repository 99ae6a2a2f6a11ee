#include "ripstop/io/mesh/obj_file.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <map>
#include <optional>

#include "ripstop/base/error.h"
#include "ripstop/io/text/text.h"

namespace ripstop {
namespace {

constexpr int no_index = -1;
constexpr std::size_t shown_objects = 6;

/// Parses the records of the file, line by line.
class Parser {
  public:
    Parser(std::string_view text, const std::string& name) : lines_(text) {
        mesh_.name = name;
        mesh_.stem = stem_of(name, ".obj");
        mesh_.first_index = 1;
        mesh_.apart = true;
    }

    ObjFile parse() {
        while (lines_.next()) read_line();
        end_object();
        name_empty();
        require_curves();
        if (mesh_.faces.empty())
            throw InputError(mesh_.name + ": no face (a line that starts with f) in " +
                             std::to_string(lines_.number()) + " lines, expected a triangulated surface; " +
                             (file_.unread.empty() ? "" : "free-form surfaces and curves (surf, curv) are not read; ") +
                             "export the surfaces as meshes");
        return std::move(file_);
    }

  private:
    void read_line() {
        std::string_view rest = lines_.line();
        const std::string_view key = next_word(rest);
        if (key.empty() || key.front() == '#') return;
        if (key == "o" || key == "g") {
            if (key == "o") end_object();
            (key == "o" ? object_ : group_) = readable_name(trimmed(rest));
            if (key == "o") group_.clear();
            surface_ = no_index;
        } else if (key == "usemtl") {
            material_ = number_of(readable_name(trimmed(rest)), materials_, mesh_.materials);
        } else if (key == "surf" || key == "curv") {
            in_use_ = true;
            file_.unread.push_back({name_or_stem(), key == "surf" ? "Surface" : "Curve",
                                    std::string("it is a free-form element (") + std::string(key) + " in line " +
                                        std::to_string(lines_.number()) +
                                        "), which are not read from OBJ; export it as a " +
                                        (key == "surf" ? "mesh" : "polyline")});
        } else if (key == "v" || key == "vt" || key == "f" || key == "l") {
            rest = lines_.joined();
            next_word(rest);
            if (key == "v") {
                const double x = coordinate(rest), y = coordinate(rest), z = coordinate(rest);
                mesh_.vertices.emplace_back(x, y, z);
            } else if (key == "vt") {
                const double u = coordinate(rest);
                const std::string_view ahead = trimmed(rest);
                mesh_.textures.emplace_back(u, ahead.empty() || ahead.front() == '#' ? 0 : coordinate(rest));
            } else {
                in_use_ = true;
                key == "f" ? read_face(rest) : read_curve(rest);
            }
        }
    }

    void end_object() {
        if (!object_.empty() && !in_use_) empty_.push_back(object_);
        in_use_ = false;
    }

    void name_empty() {
        if (empty_.empty()) return;
        std::string text =
            std::to_string(empty_.size()) + (empty_.size() == 1 ? " object" : " objects") + " without a face or line: ";
        for (std::size_t i = 0; i < std::min(empty_.size(), shown_objects); ++i) text += (i ? ", " : "") + empty_[i];
        mesh_.remarks.push_back(text + (empty_.size() > shown_objects ? ", …" : ""));
    }

    /// The index of a name in `names`; appends it if it is new.
    static int number_of(const std::string& name, std::map<std::string, int>& numbers,
                         std::vector<std::string>& names) {
        if (name.empty()) return no_index;
        const auto [entry, is_new] = numbers.try_emplace(name, static_cast<int>(names.size()));
        if (is_new) names.push_back(name);
        return entry->second;
    }

    double coordinate(std::string_view& rest) const { return mesh_.coordinate(next_word(rest), lines_.number()); }

    void read_face(std::string_view rest) {
        RecordedFace face{mesh_.corners.size(), 0, current_surface(), material_, lines_.number()};
        for (;;) {
            const std::string_view word = next_word(rest);
            if (word.empty() || word.front() == '#') break;
            mesh_.corners.push_back(corner(word, "face"));
            ++face.count;
        }
        mesh_.faces.push_back(face);
    }

    /// Blender writes a polyline as one record for each segment, so a record that starts where the curve before it
    /// ends continues that curve.
    void read_curve(std::string_view rest) {
        ObjCurve curve{name_or_stem(), object_, {}, lines_.number()};
        if (!group_.empty() && group_ != object_) curve.layer += (curve.layer.empty() ? "" : "::") + group_;
        for (;;) {
            const std::string_view word = next_word(rest);
            if (word.empty() || word.front() == '#') break;
            curve.vertices.push_back(corner(word, "polyline").vertex);
        }
        if (curve.vertices.size() < 2) {
            file_.remarks.push_back("the polyline in line " + std::to_string(curve.line) + " of " + mesh_.name +
                                    " left out: it has fewer than two points");
            return;
        }
        if (!file_.curves.empty()) {
            ObjCurve& last = file_.curves.back();
            if (last.name == curve.name && last.layer == curve.layer &&
                last.vertices.back() == curve.vertices.front()) {
                last.vertices.insert(last.vertices.end(), curve.vertices.begin() + 1, curve.vertices.end());
                return;
            }
        }
        file_.curves.push_back(std::move(curve));
    }

    /// Parses `v`, `v/vt`, `v//vn` or `v/vt/vn`. Tolerates a slash with nothing after it.
    RecordedCorner corner(std::string_view word, const char* what) const {
        const char* at = word.data();
        const char* const end = at + word.size();
        const auto number = [&](bool required) {
            long value = 0;
            const auto [stop, error] = std::from_chars(at, end, value);
            if ((error != std::errc{} && (required || stop != at)) || (stop != end && *stop != '/'))
                mesh_.refuse(lines_.number(), "found " + shown(word) + " as a corner of a " + what +
                                                  ", expected indices such as 12, 12/7 or 12/7/3; "
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
            mesh_.refuse(lines_.number(), "found " + shown(word) + " as a corner of a " + what +
                                              ", expected at most three indices (12/7/3); export the file again");
        return {index(vertex, mesh_.vertices.size(), "vertex"),
                texture ? index(*texture, mesh_.textures.size(), "texture coordinate") : no_index};
    }

    /// The index from 0. Positive indices are checked at the end, because the vertices may follow.
    int index(long given, std::size_t count, const char* what) const {
        const long from_zero = given > 0 ? given - 1 : given + static_cast<long>(count);
        if (given == 0 || from_zero < 0 || from_zero > std::numeric_limits<int>::max())
            mesh_.refuse_index(lines_.number(), given, count, what);
        return static_cast<int>(from_zero);
    }

    std::string current_name() const {
        return object_.empty() ? group_ : group_.empty() || group_ == object_ ? object_ : object_ + "/" + group_;
    }

    std::string name_or_stem() const {
        const std::string name = current_name();
        return name.empty() ? mesh_.stem : name;
    }

    int current_surface() {
        if (surface_ != no_index) return surface_;
        const std::string name = current_name();
        if (!name.empty()) mesh_.apart = false;
        return surface_ = number_of(name.empty() ? mesh_.stem : name, surfaces_, mesh_.surfaces);
    }

    void require_curves() const {
        for (const ObjCurve& curve : file_.curves)
            for (const int vertex : curve.vertices)
                if (static_cast<std::size_t>(vertex) >= mesh_.vertices.size())
                    mesh_.refuse(curve.line, "a polyline names vertex " + std::to_string(vertex + 1L) +
                                                 ", expected one of the " + std::to_string(mesh_.vertices.size()) +
                                                 " there are; the file is cut short or damaged, so export it again");
    }

    Lines lines_;
    ObjFile file_;
    MeshRecords& mesh_ = file_.mesh;
    std::string object_;
    std::string group_;
    std::vector<std::string> empty_;  ///< objects without faces
    bool in_use_ = false;             ///< whether the object has any face or curve
    int surface_ = no_index;
    int material_ = no_index;
    std::map<std::string, int> surfaces_;
    std::map<std::string, int> materials_;
};

}  // namespace

ObjFile parse_obj(std::string_view text, const std::string& name) {
    return Parser(text, name).parse();
}

}  // namespace ripstop
