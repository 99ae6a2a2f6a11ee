#include "ripstop/io/mesh/off.h"

#include <algorithm>
#include <charconv>
#include <istream>
#include <limits>
#include <optional>
#include <ostream>

#include "ripstop/base/text/number_text.h"
#include "ripstop/io/mesh/binary.h"
#include "ripstop/io/mesh/mesh_records.h"
#include "ripstop/io/text/text.h"

namespace ripstop {
namespace {

/// What follows x y z in a vertex line, in this order, according to the keyword.
struct OffKind {
    bool normals = false;
    bool colours = false;
    bool textures = false;
};

std::optional<long> whole(std::string_view word) {
    long value = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (word.empty() || error != std::errc{} || stop != word.data() + word.size()) return std::nullopt;
    return value;
}

/// The kind that a keyword names; empty if it names none.
std::optional<OffKind> kind_of(std::string_view word, const MeshRecords& file, long place) {
    if (!word.ends_with("OFF")) return std::nullopt;
    word.remove_suffix(3);
    OffKind kind;
    const auto take = [&word](std::string_view prefix) {
        const bool there = word.starts_with(prefix);
        if (there) word.remove_prefix(prefix.size());
        return there;
    };
    kind.textures = take("ST");
    kind.colours = take("C");
    kind.normals = take("N");
    if (word == "4" || word == "n" || word == "4n")
        file.refuse(place,
                    "points in more than three dimensions, expected OFF with x y z; export the surfaces as OFF or OBJ");
    return word.empty() ? std::optional(kind) : std::nullopt;
}

void add_corner(MeshRecords& file, long index, std::size_t vertices, long place) {
    if (index < 0 || index > std::numeric_limits<int>::max()) file.refuse_index(place, index, vertices);
    const int vertex = static_cast<int>(index);
    file.corners.push_back({vertex, file.textures.empty() ? -1 : vertex});
}

class OffTextReader {
  public:
    OffTextReader(std::string_view text, MeshRecords& file) : lines_(text), size_(text.size()), file_(file) {}

    void read() {
        next_line("the counts of vertices and faces");
        std::string_view rest = rest_;
        OffKind kind;
        if (const auto found = kind_of(next_word(rest), file_, lines_.number())) {
            kind = *found;
            rest_ = rest;
            if (trimmed(rest_).empty()) next_line("the counts of vertices and faces");
        }
        const std::size_t vertices = count("vertices");
        const std::size_t faces = count("faces");
        file_.vertices.reserve(std::min(vertices, size_ / 6));
        file_.faces.reserve(std::min(faces, size_ / 8));
        for (std::size_t i = 0; i < vertices; ++i) read_vertex(kind, vertices);
        for (std::size_t i = 0; i < faces; ++i) read_face(faces, vertices);
    }

  private:
    /// Moves to the next line that is not blank or a comment.
    void next_line(const std::string& expected) {
        do {
            if (!lines_.next())
                file_.refuse(std::max(lines_.number(), 1L), "the file ends here, expected " + expected +
                                                                "; it is cut short or not OFF, export it again");
            const std::string_view line = lines_.line();
            rest_ = trimmed(line.substr(0, line.find('#')));
        } while (rest_.empty());
    }

    std::size_t count(const char* what) {
        const std::string_view word = next_word(rest_);
        const auto value = whole(word);
        if (!value || *value < 0)
            file_.refuse(lines_.number(), "found " + shown(word) + ", expected OFF and the number of " + what +
                                              "; the file is damaged or not an OFF file, export it again");
        return static_cast<std::size_t>(*value);
    }

    void read_vertex(const OffKind& kind, std::size_t vertices) {
        next_line(std::to_string(vertices) + " vertices");
        const long line = lines_.number();
        const std::string_view whole_line = rest_;
        const double x = file_.coordinate(next_word(rest_), line), y = file_.coordinate(next_word(rest_), line);
        file_.vertices.emplace_back(x, y, file_.coordinate(next_word(rest_), line));
        if (!kind.textures) return;
        std::string_view u, v;  // the last two words, because the number of words of a colour varies
        for (std::string_view word = next_word(rest_); !word.empty(); word = next_word(rest_)) {
            u = v;
            v = word;
        }
        if (u.empty())
            file_.refuse(line, "found " + shown(whole_line) +
                                   ", expected a vertex with two texture coordinates as STOFF says; export it again");
        const double first = file_.coordinate(u, line);
        file_.textures.emplace_back(first, file_.coordinate(v, line));
    }

    void read_face(std::size_t faces, std::size_t vertices) {
        next_line(std::to_string(faces) + " faces");
        const long line = lines_.number();
        const std::string_view word = next_word(rest_);
        const auto corners = whole(word);
        if (!corners || *corners < 0 || *corners > static_cast<long>(rest_.size()))
            file_.refuse(line,
                         "found " + shown(word) + ", expected the number of a face's corners; export the file again");
        file_.faces.push_back({file_.corners.size(), static_cast<int>(*corners), 0, -1, line});
        for (long k = 0; k < *corners; ++k) {
            const std::string_view corner = next_word(rest_);
            const auto index = whole(corner);
            if (!index)
                file_.refuse(line, (corner.empty() ? "a corner is missing" : "found " + shown(corner)) +
                                       ", expected the index of a vertex; export the file again");
            add_corner(file_, *index, vertices, line);
        }
    }

    Lines lines_;
    std::size_t size_;
    std::string_view rest_;
    MeshRecords& file_;
};

class BinaryReader {
  public:
    BinaryReader(std::string_view bytes, std::size_t at, MeshRecords& file) : bytes_(bytes), at_(at), file_(file) {}

    void read(const OffKind& kind) {
        const std::uint32_t vertices = next<std::uint32_t>();
        const std::uint32_t faces = next<std::uint32_t>();
        next<std::uint32_t>();  // edges
        file_.vertices.reserve(std::min<std::size_t>(vertices, left() / 12));
        file_.faces.reserve(std::min<std::size_t>(faces, left() / 8));
        for (std::uint32_t i = 0; i < vertices; ++i) {
            const double x = coordinate(), y = coordinate();
            file_.vertices.emplace_back(x, y, coordinate());
            for (int skipped = (kind.normals ? 3 : 0) + (kind.colours ? 4 : 0); skipped > 0; --skipped) next<float>();
            if (!kind.textures) continue;
            const double u = coordinate();
            file_.textures.emplace_back(u, coordinate());
        }
        for (std::uint32_t i = 0; i < faces; ++i) {
            const long start = place();
            const std::uint32_t corners = next<std::uint32_t>();
            require(corners, start);
            file_.faces.push_back({file_.corners.size(), static_cast<int>(corners), 0, -1, start});
            for (std::uint32_t k = 0; k < corners; ++k) add_corner(file_, next<std::int32_t>(), vertices, start);
            const std::uint32_t colours = next<std::uint32_t>();
            require(colours, start);
            at_ += 4 * std::size_t{colours};
        }
    }

  private:
    long place() const { return static_cast<long>(at_); }
    std::size_t left() const { return bytes_.size() - at_; }

    void require(std::uint32_t numbers, long start) const {
        if (left() / 4 < numbers)
            file_.refuse(start, "a face with " + std::to_string(numbers) + " numbers, but " + std::to_string(left()) +
                                    " bytes are left; the file is cut short or damaged, export it again");
    }

    template <class Number>
    Number next() {
        if (left() < sizeof(Number))
            file_.refuse(place(), "the file ends before all the vertices and faces that it announces; export it again");
        at_ += sizeof(Number);
        return load<Number>(bytes_.data() + at_ - sizeof(Number), std::endian::big);
    }

    double coordinate() {
        const long start = place();
        return file_.coordinate(static_cast<double>(next<float>()), start);
    }

    std::string_view bytes_;
    std::size_t at_;
    MeshRecords& file_;
};

/// The offset of the numbers in a binary file, which follow the line `OFF BINARY`; empty for a text file.
std::optional<std::size_t> binary_start(std::string_view bytes, const MeshRecords& file, OffKind& kind) {
    const std::size_t end = bytes.substr(0, 64).find('\n');
    if (end == std::string_view::npos) return std::nullopt;
    std::string_view rest = bytes.substr(0, end);
    const std::string_view keyword = next_word(rest);
    if (trimmed(rest) != "BINARY") return std::nullopt;
    const auto found = kind_of(keyword, file, 1);
    if (!found) return std::nullopt;
    kind = *found;
    return end + 1;
}

}  // namespace

CadModel read_off(std::istream& in, const std::string& name) {
    std::string bytes = read_bytes(in, name);
    MeshRecords file{.name = name, .stem = stem_of(name, ".off"), .apart = true};
    file.surfaces = {file.stem};
    OffKind kind;
    if (const auto start = binary_start(bytes, file, kind)) {
        file.binary = file.single_precision = true;
        BinaryReader(bytes, *start, file).read(kind);
    } else {
        bytes = text_of(std::move(bytes), name);
        OffTextReader(bytes, file).read();
    }
    CadModel model;
    make_surfaces(std::move(file), model);
    return model;
}

void write_off(std::ostream& out, const std::vector<NamedMesh>& meshes) {
    const bool drawn =
        std::all_of(meshes.begin(), meshes.end(), [](const NamedMesh& m) { return m.drawn.has_value(); });
    Eigen::Index vertices = 0, faces = 0;
    for (const NamedMesh& surface : meshes) {
        vertices += surface.mesh.positions.rows();
        faces += surface.mesh.triangles.rows();
    }
    out << (drawn ? "STOFF\n" : "OFF\n") + std::to_string(vertices) + " " + std::to_string(faces) + " 0\n";
    for (const NamedMesh& surface : meshes) {
        std::string text;
        for (Eigen::Index v = 0; v < surface.mesh.positions.rows(); ++v) {
            for (Eigen::Index k = 0; k < 3; ++k) text += (k ? " " : "") + format_shortest(surface.mesh.positions(v, k));
            for (Eigen::Index k = 0; drawn && k < 2; ++k) text += " " + format_shortest((*surface.drawn)(v, k));
            text += "\n";
        }
        out << text;
    }
    Eigen::Index first = 0;
    for (const NamedMesh& surface : meshes) {
        std::string text;
        for (Eigen::Index t = 0; t < surface.mesh.triangles.rows(); ++t) {
            text += "3";
            for (Eigen::Index k = 0; k < 3; ++k) text += " " + std::to_string(first + surface.mesh.triangles(t, k));
            text += "\n";
        }
        out << text;
        first += surface.mesh.positions.rows();
    }
}

}  // namespace ripstop
