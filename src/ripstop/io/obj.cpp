#include "ripstop/io/obj.h"

#include <algorithm>
#include <istream>
#include <ostream>

#include "ripstop/base/number_text.h"
#include "ripstop/io/obj_file.h"
#include "ripstop/io/text.h"
#include "ripstop/mesh/components.h"
#include "ripstop/mesh/fan.h"

namespace ripstop {
namespace {

constexpr int none = -1;

/// The corners of all triangles, three a triangle, and the face each triangle comes from.
struct TriangleList {
    std::vector<std::size_t> corners;
    std::vector<std::size_t> faces;
};

TriangleList triangulated(const ObjFile& file) {
    TriangleList list;
    list.corners.reserve(3 * file.faces.size());
    list.faces.reserve(file.faces.size());
    std::vector<Vec3> polygon;
    for (std::size_t f = 0; f < file.faces.size(); ++f) {
        const ObjFace& face = file.faces[f];
        const auto count = static_cast<std::size_t>(face.count);
        int apex = 0;
        if (count > 3) {
            polygon.clear();
            for (std::size_t k = 0; k < count; ++k)
                polygon.push_back(file.vertices[static_cast<std::size_t>(file.corners[face.first + k].vertex)]);
            apex = fan_corner(polygon);
            if (apex < 0)
                file.refuse(face.line,
                            "a face with " + std::to_string(count) +
                                " corners has no area or folds over itself when it is fanned into triangles, "
                                "expected a plain polygon; triangulate it in the CAD");
        }
        for (std::size_t k = 1; k + 1 < count; ++k) {
            for (const std::size_t step : {std::size_t{0}, k, k + 1})
                list.corners.push_back(face.first + (static_cast<std::size_t>(apex) + step) % count);
            list.faces.push_back(f);
        }
    }
    return list;
}

/// Renames the faces of a file without names by the connected part they are in.
void name_parts(ObjFile& file, const TriangleList& list) {
    TriangleMesh whole;
    whole.positions.resize(static_cast<Eigen::Index>(file.vertices.size()), 3);
    whole.triangles.resize(static_cast<Eigen::Index>(list.faces.size()), 3);
    for (std::size_t c = 0; c < list.corners.size(); ++c)
        whole.triangles(static_cast<Eigen::Index>(c / 3), static_cast<Eigen::Index>(c % 3)) =
            file.corners[list.corners[c]].vertex;
    const std::vector<int> parts = connected_parts(whole);
    int count = 0;
    for (std::size_t t = 0; t < parts.size(); ++t) {
        file.faces[list.faces[t]].surface = parts[t];
        count = std::max(count, parts[t] + 1);
    }
    if (count == 1) return;
    const std::string stem = file.surfaces.front();
    const std::size_t digits = std::max<std::size_t>(2, std::to_string(count).size());
    file.surfaces.clear();
    for (int part = 1; part <= count; ++part) {
        const std::string number = std::to_string(part);
        file.surfaces.push_back(stem + "_" + std::string(digits - number.size(), '0') + number);
    }
}

/// Makes surfaces of a file's corners, each with its own vertices. Keeps one table over all vertices of the file, so that
/// many small surfaces cost no more than one large.
class SurfaceMaker {
  public:
    explicit SurfaceMaker(const ObjFile& file) : file_(file), local_(file.vertices.size(), none) {}

    /// `corners`: three a triangle, in `file.corners`.
    NamedMesh make(const std::string& name, const std::vector<std::size_t>& corners) {
        std::vector<int> used;
        for (const std::size_t c : corners)
            if (int& local = local_[vertex(c)]; local == none) {
                local = 0;
                used.push_back(file_.corners[c].vertex);
            }
        std::sort(used.begin(), used.end());
        NamedMesh surface{name, {}};
        surface.mesh.positions.resize(static_cast<Eigen::Index>(used.size()), 3);
        for (std::size_t i = 0; i < used.size(); ++i) {
            local_[static_cast<std::size_t>(used[i])] = static_cast<int>(i);
            surface.mesh.positions.row(static_cast<Eigen::Index>(i)) =
                file_.vertices[static_cast<std::size_t>(used[i])].transpose();
        }
        surface.mesh.triangles.resize(static_cast<Eigen::Index>(corners.size() / 3), 3);
        for (std::size_t i = 0; i < corners.size(); ++i)
            surface.mesh.triangles(static_cast<Eigen::Index>(i / 3), static_cast<Eigen::Index>(i % 3)) =
                local_[vertex(corners[i])];
        surface.drawn = drawn(corners, static_cast<Eigen::Index>(used.size()));
        for (const int v : used) local_[static_cast<std::size_t>(v)] = none;
        return surface;
    }

  private:
    std::size_t vertex(std::size_t corner) const { return static_cast<std::size_t>(file_.corners[corner].vertex); }

    std::optional<Points2> drawn(const std::vector<std::size_t>& corners, Eigen::Index count) const {
        Points2 points(count, 2);
        std::vector<bool> has(static_cast<std::size_t>(count), false);
        for (const std::size_t c : corners) {
            if (file_.corners[c].texture == none) return std::nullopt;
            const Vec2& point = file_.textures[static_cast<std::size_t>(file_.corners[c].texture)];
            const int v = local_[vertex(c)];
            if (has[static_cast<std::size_t>(v)] && points.row(v) != point.transpose()) return std::nullopt;
            points.row(v) = point.transpose();
            has[static_cast<std::size_t>(v)] = true;
        }
        return points;
    }

    const ObjFile& file_;
    std::vector<int> local_;
};

}  // namespace

CadModel read_obj(std::istream& in, const std::string& name) {
    ObjFile file = parse_obj(read_text(in, name), name);
    const TriangleList list = triangulated(file);
    if (!file.named) name_parts(file, list);
    std::vector<std::vector<std::size_t>> corners(file.surfaces.size());
    for (std::size_t c = 0; c < list.corners.size(); ++c)
        corners[static_cast<std::size_t>(file.faces[list.faces[c / 3]].surface)].push_back(list.corners[c]);
    CadModel model;
    SurfaceMaker maker(file);
    for (std::size_t s = 0; s < corners.size(); ++s) model.surfaces.push_back(maker.make(file.surfaces[s], corners[s]));
    return model;
}

void write_obj(std::ostream& out, const std::vector<NamedMesh>& meshes) {
    Eigen::Index first_vertex = 1;
    Eigen::Index first_texture = 1;
    for (const NamedMesh& surface : meshes) {
        std::string text = "o " + surface.name + "\n";
        const auto rows = [&text](const char* key, const auto& points) {
            for (Eigen::Index i = 0; i < points.rows(); ++i) {
                text += key;
                for (Eigen::Index k = 0; k < points.cols(); ++k) text += " " + format_shortest(points(i, k));
                text += "\n";
            }
        };
        rows("v", surface.mesh.positions);
        if (surface.drawn) rows("vt", *surface.drawn);
        for (Eigen::Index t = 0; t < surface.mesh.triangles.rows(); ++t) {
            text += "f";
            for (Eigen::Index k = 0; k < 3; ++k) {
                const int v = surface.mesh.triangles(t, k);
                text += " " + std::to_string(first_vertex + v);
                if (surface.drawn) text += "/" + std::to_string(first_texture + v);
            }
            text += "\n";
        }
        out << text;
        first_vertex += surface.mesh.positions.rows();
        if (surface.drawn) first_texture += surface.drawn->rows();
    }
}

}  // namespace ripstop
