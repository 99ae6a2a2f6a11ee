#include "ripstop/io/mesh/stl.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <istream>
#include <ostream>
#include <unordered_map>

#include "ripstop/base/error.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/io/mesh/binary.h"
#include "ripstop/io/mesh/mesh_records.h"
#include "ripstop/io/rhino/place_table.h"
#include "ripstop/io/text/text.h"

namespace ripstop {
namespace {

constexpr std::size_t head_size = 80;
constexpr std::size_t count_end = head_size + 4;
constexpr std::size_t triangle_size = 50;

std::uint32_t stated_count(std::string_view bytes) {
    return load<std::uint32_t>(bytes.data() + head_size, std::endian::little);
}

/// True if `word` is `keyword` in any case; `keyword` is in lower case.
bool is(std::string_view word, std::string_view keyword) {
    const auto same = [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; };
    return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(), same);
}

/// A binary file may also start with `solid`. Its length then reveals it, or a zero byte in its first triangle.
bool is_binary(std::string_view bytes) {
    if (bytes.size() >= count_end && count_end + triangle_size * std::uint64_t{stated_count(bytes)} == bytes.size())
        return true;
    std::string_view rest = bytes.substr(bytes.starts_with("\xEF\xBB\xBF") ? 3 : 0, 512);
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t\r\n"), rest.size()));
    std::string_view line = rest.substr(0, rest.find_first_of("\r\n"));
    if (!is(next_word(line), "solid")) return bytes.size() >= count_end || rest.find('\0') != rest.npos;
    return rest.find('\0') != std::string_view::npos;
}

/// Makes faces from triangles that share no vertices, by merging equal corners.
class Welder {
  public:
    explicit Welder(MeshRecords& file) : file_(file) {}

    void reserve(std::size_t triangles) {
        file_.faces.reserve(triangles);
        file_.corners.reserve(3 * triangles);
        file_.vertices.reserve(triangles / 2);
    }

    /// Moves to the solid with this name.
    void enter(const std::string& name) {
        const auto [entry, is_new] = surfaces_.try_emplace(name, static_cast<int>(file_.surfaces.size()));
        surface_ = entry->second;
        if (is_new) file_.surfaces.push_back(name);
    }

    void add(const std::array<Vec3, 3>& triangle, long place) {
        int v[3];
        for (std::size_t k = 0; k < 3; ++k) {
            v[k] = table_.number_of(triangle[k], surface_, static_cast<int>(file_.vertices.size()));
            if (static_cast<std::size_t>(v[k]) == file_.vertices.size()) file_.vertices.push_back(triangle[k]);
        }
        if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) {
            ++left_out_;
            return;
        }
        file_.faces.push_back({file_.corners.size(), 3, surface_, -1, place});
        for (const int vertex : v) file_.corners.push_back({vertex, -1});
    }

    std::vector<std::string> remarks() const {
        if (left_out_ == 0) return {};
        return {file_.name + ": " + std::to_string(left_out_) + (left_out_ == 1 ? " triangle" : " triangles") +
                " left out: two corners in one place"};
    }

  private:
    MeshRecords& file_;
    PlaceTable table_;
    std::unordered_map<std::string, int> surfaces_;
    int surface_ = 0;
    std::size_t left_out_ = 0;
};

void read_binary(std::string_view bytes, MeshRecords& file, Welder& welder) {
    if (bytes.size() < count_end)
        file.refuse(
            static_cast<long>(bytes.size()),
            "the file ends here, expected solid, or 84 bytes before the first triangle; export it again as STL");
    const std::uint64_t count = stated_count(bytes);
    if ((bytes.size() - count_end) / triangle_size < count)
        file.refuse(head_size, "the file says it has " + std::to_string(count) +
                                   " triangles, but there are bytes for " +
                                   std::to_string((bytes.size() - count_end) / triangle_size) +
                                   "; it is cut short or not an STL file, export it again");
    welder.reserve(count);
    welder.enter(file.stem);
    for (std::size_t at = count_end; at < count_end + triangle_size * count; at += triangle_size) {
        std::array<Vec3, 3> triangle;
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t i = 0; i < 3; ++i) {
                const std::size_t place = at + 12 * (k + 1) + 4 * i;
                triangle[k][static_cast<Eigen::Index>(i)] =
                    file.coordinate(static_cast<double>(load<float>(bytes.data() + place, std::endian::little)),
                                    static_cast<long>(place));
            }
        welder.add(triangle, static_cast<long>(at));
    }
}

/// Parses the lines of an ascii STL; keywords may be in any case.
class StlTextReader {
  public:
    StlTextReader(std::string_view text, MeshRecords& file, Welder& welder)
        : lines_(text), file_(file), welder_(welder) {}

    void read() {
        while (lines_.next()) {
            std::string_view rest = lines_.line();
            const std::string_view key = next_word(rest);
            if (!key.empty()) read_line(key, rest);
        }
        if (in_solid_)
            file_.refuse(lines_.number(), "the file ends here, expected endsolid; it is cut short, export it again");
    }

  private:
    void read_line(std::string_view key, std::string_view rest) {
        if (is(key, "vertex") && in_loop_) {
            if (corners_ == 3)
                file_.refuse(lines_.number(), "a fourth vertex, expected three per facet; export it again");
            Vec3& point = triangle_[corners_++];
            for (int i = 0; i < 3; ++i) point[i] = file_.coordinate(next_word(rest), lines_.number());
        } else if (is(key, "facet") && in_solid_ && !in_facet_) {
            in_facet_ = true;
            place_ = lines_.number();
        } else if (is(key, "outer") && in_facet_ && !in_loop_) {
            in_loop_ = true;
            corners_ = 0;
        } else if (is(key, "endloop") && in_loop_) {
            if (corners_ != 3)
                file_.refuse(lines_.number(), "a facet with " + std::to_string(corners_) +
                                                  (corners_ == 1 ? " vertex" : " vertices") +
                                                  ", expected three; export the file again");
            welder_.add(triangle_, place_);
            in_loop_ = false;
        } else if (is(key, "endfacet") && in_facet_ && !in_loop_) {
            in_facet_ = false;
        } else if ((is(key, "endsolid") || (is(key, "end") && is(next_word(rest), "solid"))) && in_solid_ &&
                   !in_facet_) {
            in_solid_ = false;
        } else if (is(key, "solid") && !in_solid_) {
            in_solid_ = true;
            const std::string name = readable_name(trimmed(rest));
            welder_.enter(name.empty() ? file_.stem : name);
        } else {
            file_.refuse(lines_.number(), "found " + shown(key) + ", expected " + expected() +
                                              "; the file is damaged or not an STL file, export it again");
        }
    }

    const char* expected() const {
        return in_loop_    ? "vertex or endloop"
               : in_facet_ ? "outer loop or endfacet"
               : in_solid_ ? "facet or endsolid"
                           : "solid";
    }

    Lines lines_;
    MeshRecords& file_;
    Welder& welder_;
    std::array<Vec3, 3> triangle_ = {};
    std::size_t corners_ = 0;
    long place_ = 0;
    bool in_solid_ = false, in_facet_ = false, in_loop_ = false;
};

}  // namespace

CadModel read_stl(std::istream& in, const std::string& name) {
    std::string bytes = read_bytes(in, name);
    const bool binary = is_binary(bytes);
    MeshRecords file{.name = name, .stem = stem_of(name, ".stl"), .binary = binary, .apart = true};
    file.single_precision = binary;
    Welder welder(file);
    if (binary) {
        read_binary(bytes, file, welder);
    } else {
        bytes = text_of(std::move(bytes), name);
        StlTextReader(bytes, file, welder).read();
    }
    CadModel model;
    model.remarks = welder.remarks();
    make_surfaces(std::move(file), model);
    return model;
}

void write_stl(std::ostream& out, const std::vector<NamedMesh>& meshes) {
    for (const NamedMesh& surface : meshes) {
        std::string text = "solid " + surface.name + "\n";
        const auto line = [&text](const char* key, const Vec3& point) {
            text += key;
            for (const double value : point) text += " " + format_shortest(value);
            text += "\n";
        };
        for (int t = 0; t < surface.mesh.triangle_count(); ++t) {
            const Vec3 a = surface.mesh.corner(t, 0), b = surface.mesh.corner(t, 1), c = surface.mesh.corner(t, 2);
            line("facet normal", (b - a).cross(c - a).normalized());
            text += "outer loop\n";
            for (const Vec3& corner : {a, b, c}) line("vertex", corner);
            text += "endloop\nendfacet\n";
        }
        out << text << "endsolid " << surface.name << "\n";
    }
}

}  // namespace ripstop
