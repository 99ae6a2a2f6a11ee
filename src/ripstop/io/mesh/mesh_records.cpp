#include "ripstop/io/mesh/mesh_records.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "ripstop/base/error.h"
#include "ripstop/base/text/lower_case.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/io/mesh/mesh_faces.h"
#include "ripstop/io/text/text.h"
#include "ripstop/mesh/components.h"

namespace ripstop {
namespace {

constexpr double largest_coordinate = 1e12;  // beyond it, squares and products lose too many digits
constexpr int none = -1;

void require_indices(const MeshRecords& file) {
    for (const RecordedFace& face : file.faces)
        for (std::size_t c = face.first; c < face.first + static_cast<std::size_t>(face.count); ++c) {
            const auto vertex = static_cast<std::size_t>(file.corners[c].vertex);
            if (vertex >= file.vertices.size())
                file.refuse_index(face.place, static_cast<long>(vertex) + file.first_index, file.vertices.size());
            if (file.corners[c].texture >= static_cast<long>(file.textures.size()))
                file.refuse_index(face.place, static_cast<long>(file.corners[c].texture) + file.first_index,
                                  file.textures.size(), "texture coordinate");
        }
}

/// Names each face after the connected part it is in. A part lies in one surface.
void name_parts(MeshRecords& file, const TriangleList& list) {
    TriangleMesh whole;
    whole.positions.resize(static_cast<Eigen::Index>(file.vertices.size()), 3);
    whole.triangles.resize(static_cast<Eigen::Index>(list.faces.size()), 3);
    for (std::size_t c = 0; c < list.corners.size(); ++c)
        whole.triangles(static_cast<Eigen::Index>(c / 3), static_cast<Eigen::Index>(c % 3)) =
            file.corners[list.corners[c]].vertex;
    const std::vector<int> parts = connected_parts(whole);
    std::vector<int> surface_of_part;
    std::vector<int> count(file.surfaces.size(), 0);
    for (std::size_t t = 0; t < parts.size(); ++t) {
        RecordedFace& face = file.faces[list.faces[t]];
        if (static_cast<std::size_t>(parts[t]) ==
            surface_of_part.size()) {  // parts are numbered by their first triangle
            surface_of_part.push_back(face.surface);
            ++count[static_cast<std::size_t>(face.surface)];
        }
    }
    for (std::size_t t = 0; t < parts.size(); ++t) file.faces[list.faces[t]].surface = parts[t];
    std::set<std::string> taken(file.surfaces.begin(), file.surfaces.end());
    std::vector<int> last(count.size(), 0);
    std::vector<std::string> names;
    for (const int surface : surface_of_part) {
        const auto s = static_cast<std::size_t>(surface);
        std::string name = file.surfaces[s];
        while (count[s] > 1 && !taken.insert(name).second)
            name = file.surfaces[s] + "_" +
                   padded(static_cast<std::size_t>(++last[s]), static_cast<std::size_t>(count[s]));
        names.push_back(name);
    }
    file.surfaces = std::move(names);
}

/// Makes surfaces, each with its own vertices, from the corners of a file. One table over all vertices of the file
/// serves all surfaces, so many small surfaces cost no more than one large one.
class SurfaceMaker {
  public:
    SurfaceMaker(const MeshRecords& file, const TriangleList& list)
        : file_(file), list_(list), local_(file.vertices.size(), none) {}

    /// Makes a surface of these triangles of the list.
    NamedMesh make(const std::string& name, const std::vector<std::size_t>& triangles) {
        const std::vector<int> used = number_vertices(triangles);
        NamedMesh surface{name, {}};
        surface.mesh.positions.resize(static_cast<Eigen::Index>(used.size()), 3);
        for (std::size_t i = 0; i < used.size(); ++i)
            surface.mesh.positions.row(static_cast<Eigen::Index>(i)) =
                file_.vertices[static_cast<std::size_t>(used[i])].transpose();
        surface.mesh.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
        for (std::size_t i = 0; i < triangles.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k)
                surface.mesh.triangles(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) =
                    local_[vertex(list_.corners[3 * triangles[i] + k])];
        surface.drawn = drawn(triangles, static_cast<Eigen::Index>(used.size()));
        surface.warp = warp(name, triangles);
        if (const int m = material(triangles); m != none)
            surface.attributes["material"] = file_.materials[static_cast<std::size_t>(m)];
        for (const int v : used) local_[static_cast<std::size_t>(v)] = none;
        return surface;
    }

  private:
    std::size_t vertex(std::size_t corner) const { return static_cast<std::size_t>(file_.corners[corner].vertex); }
    const RecordedFace& face(std::size_t triangle) const { return file_.faces[list_.faces[triangle]]; }

    /// The vertices that these triangles use, in the file's order. Stores their new numbers in `local_`.
    std::vector<int> number_vertices(const std::vector<std::size_t>& triangles) {
        std::vector<int> used;
        for (const std::size_t t : triangles)
            for (std::size_t c = 3 * t; c < 3 * t + 3; ++c)
                if (int& local = local_[vertex(list_.corners[c])]; local == none) {
                    local = 0;
                    used.push_back(file_.corners[list_.corners[c]].vertex);
                }
        std::sort(used.begin(), used.end());
        for (std::size_t i = 0; i < used.size(); ++i) local_[static_cast<std::size_t>(used[i])] = static_cast<int>(i);
        return used;
    }

    std::optional<Points2> drawn(const std::vector<std::size_t>& triangles, Eigen::Index count) const {
        if (file_.textures.empty()) return std::nullopt;
        Points2 points(count, 2);
        std::vector<bool> has(static_cast<std::size_t>(count), false);
        for (const std::size_t t : triangles)
            for (std::size_t k = 3 * t; k < 3 * t + 3; ++k) {
                const std::size_t c = list_.corners[k];
                if (file_.corners[c].texture == none) return std::nullopt;
                const Vec2& point = file_.textures[static_cast<std::size_t>(file_.corners[c].texture)];
                const int v = local_[vertex(c)];
                if (has[static_cast<std::size_t>(v)] && points.row(v) != point.transpose()) return std::nullopt;
                points.row(v) = point.transpose();
                has[static_cast<std::size_t>(v)] = true;
            }
        return points;
    }

    Points3 warp(const std::string& name, const std::vector<std::size_t>& triangles) const {
        Points3 field;
        if (file_.warps.empty()) return field;
        const auto of = [this](std::size_t t) -> const Vec3& { return file_.warps[list_.faces[t]]; };
        const auto given = [&of](std::size_t t) { return of(t).norm() > 0; };
        if (std::none_of(triangles.begin(), triangles.end(), given)) return field;
        field.resize(static_cast<Eigen::Index>(triangles.size()), 3);
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            if (!given(triangles[i]))
                file_.refuse(face(triangles[i]).place,
                             "a face of " + name + " has the warp 0 0 0 but others have a direction, expected one on " +
                                 "every face or on none; give the missing ones");
            field.row(static_cast<Eigen::Index>(i)) = of(triangles[i]).transpose();
        }
        return field;
    }

    int material(const std::vector<std::size_t>& triangles) const {
        const int first = face(triangles.front()).material;
        const bool alike =
            std::all_of(triangles.begin(), triangles.end(), [&](std::size_t t) { return face(t).material == first; });
        return alike ? first : none;
    }

    const MeshRecords& file_;
    const TriangleList& list_;
    std::vector<int> local_;
};

}  // namespace

std::string MeshRecords::at(long place) const {
    return name + (binary ? ": byte " : ":") + std::to_string(place) + ": ";
}

void MeshRecords::refuse(long place, const std::string& what) const {
    throw InputError(at(place) + what);
}

void MeshRecords::refuse_index(long place, long given, std::size_t count, const char* what) const {
    refuse(place, std::string("a face refers to ") + what + " " + std::to_string(given) + ", expected one of the " +
                      std::to_string(count) + " that exist, counted from " +
                      (first_index == 1 ? "1 (or from the end, negative)" : "0") +
                      "; the file is cut short or damaged, so export it again");
}

double MeshRecords::coordinate(std::string_view word, long place) const {
    const std::optional<double> value = parse_double(word);
    if (!value)
        refuse(place, (word.empty() ? "a coordinate is missing" : "found " + shown(word)) +
                          ", expected a finite number with a decimal point; export the file again");
    if (std::abs(*value) > largest_coordinate)
        refuse(place,
               "the coordinate " + shown(word) + " is too large, expected at most 1e12; check the unit and the model");
    return *value;
}

double MeshRecords::coordinate(double value, long place) const {
    if (!(std::abs(value) <= largest_coordinate))
        refuse(place, std::isfinite(value)
                          ? "the coordinate " + format_shortest(value) +
                                " is too large, expected at most 1e12; check the unit and the model"
                          : "found a number that is not finite, expected a coordinate; export the file again");
    return value;
}

void make_surfaces(MeshRecords file, CadModel& model) {
    require_indices(file);
    mend_faces(file);
    if (file.faces.empty())
        throw InputError(file.name + ": no face" + (file.remarks.empty() ? "" : " (" + file.remarks.back() + ")") +
                         ", expected a triangulated surface; export the surfaces as meshes");
    const TriangleList list = triangulated(file);
    if (file.apart) name_parts(file, list);
    std::vector<std::vector<std::size_t>> triangles(file.surfaces.size());
    for (std::size_t t = 0; t < list.faces.size(); ++t)
        triangles[static_cast<std::size_t>(file.faces[list.faces[t]].surface)].push_back(t);
    SurfaceMaker maker(file, list);
    for (std::size_t s = 0; s < triangles.size(); ++s) {
        if (triangles[s].empty()) continue;
        NamedMesh& surface = model.surfaces.emplace_back(maker.make(file.surfaces[s], triangles[s]));
        for (const std::size_t t : triangles[s]) {
            const auto fault = list.faults.find(list.faces[t]);
            if (fault == list.faults.end()) continue;
            surface.fault = file.at(file.faces[fault->first].place) + fault->second;
            break;
        }
    }
    if (file.single_precision)
        for (const Vec3& vertex : file.vertices)
            model.rounding = std::max(model.rounding, single_rounding(vertex.cwiseAbs().maxCoeff()));
    for (std::string& remark : file.remarks) model.remarks.push_back(file.name + ": " + std::move(remark));
}

std::string stem_of(const std::string& name, std::string_view extension) {
    std::string stem = name.substr(name.find_last_of("/\\") + 1);
    const std::size_t dot = stem.rfind('.');
    if (dot != 0 && dot != std::string::npos && lower_case(stem.substr(dot)) == extension) stem.resize(dot);
    return stem.empty() ? "surface" : readable_name(stem);
}

}  // namespace ripstop
