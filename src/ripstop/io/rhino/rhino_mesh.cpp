#include "ripstop/io/rhino/rhino_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

#include "ripstop/base/error.h"
#include "ripstop/mesh/change/coincident.h"
#include "ripstop/mesh/components.h"
#include "ripstop/model/tile/cad_model.h"

namespace ripstop {
namespace {

constexpr RhinoId double_vertices_class = rhino_id("17F24E75-21BE-4a7b-9F3D-7F85225247E3");
constexpr std::size_t float_point = 3 * sizeof(float), double_point = 3 * sizeof(double);
constexpr unsigned first_writer_of_mapping_tags = 200606010;
constexpr double largest_in_mesh = 1e12;  // as in every reader: larger numbers are not coordinates

using Quads = Eigen::Matrix<int, Eigen::Dynamic, 4, Eigen::RowMajor>;

Quads read_faces(RhinoBytes& data, std::size_t count) {
    const int width = data.integer();
    if (width != 1 && width != 2 && width != 4)
        data.refuse("corners of " + std::to_string(width) + " bytes, expected 1, 2 or 4");
    if (count > data.left() / (4 * static_cast<std::size_t>(width)))
        data.refuse(std::to_string(count) + " faces, but only " + std::to_string(data.left()) + " bytes are left");
    const std::string_view bytes = data.take(4 * static_cast<std::size_t>(width) * count).view();
    Quads faces(static_cast<Eigen::Index>(count), 4);
    for (Eigen::Index i = 0; i < faces.size(); ++i) {
        std::uint32_t corner = 0;
        std::memcpy(&corner, bytes.data() + i * width, static_cast<std::size_t>(width));
        faces.data()[i] = static_cast<int>(corner);  // beyond int: negative, and refused like others
    }
    return faces;
}

template <class T>
Points3 points_of(std::string_view bytes) {
    using Rows = Eigen::Matrix<T, Eigen::Dynamic, 3, Eigen::RowMajor>;
    Rows rows(static_cast<Eigen::Index>(bytes.size() / (3 * sizeof(T))), 3);
    if (!bytes.empty()) std::memcpy(rows.data(), bytes.data(), bytes.size());
    return rows.template cast<double>();
}

/// True if the double vertices round to the single ones. If they do not, they belong to another state of the mesh.
bool fits(const Points3& fine, const Points3& coarse) {
    if (fine.rows() != coarse.rows()) return false;
    for (Eigen::Index v = 0; v < fine.rows(); ++v)
        if (!((fine.row(v).cast<float>().cast<double>() - coarse.row(v)).cwiseAbs().maxCoeff() <=
              1e-6 * coarse.row(v).cwiseAbs().maxCoeff()))
            return false;
    return true;
}

/// Rhino 5 attaches the double vertices to the mesh as user data: two counts, two checksums, the points.
std::optional<Points3> double_vertices_beside(const RhinoClass& object) {
    const auto found = object.user_data.find(double_vertices_class);
    if (found == object.user_data.end()) return std::nullopt;
    RhinoBytes body = found->second;
    RhinoBytes data = body.anonymous();
    data.skip(4 * sizeof(std::int32_t));
    const std::size_t count = data.count(double_point);
    return points_of<double>(data.take(double_point * count).view());
}

/// Rhino 6 and later store the double vertices at the end of the mesh, after data that we skip.
std::optional<Points3> double_vertices_within(RhinoBytes& data, int minor, unsigned writer) {
    if (minor < 7) return std::nullopt;
    data.skip(sizeof(std::int32_t) + sizeof(RhinoId));  // whether the texture is rotated, its mapping
    data.skip_buffer();                                 // surface parameters
    if (writer == 0 || writer >= first_writer_of_mapping_tags) data.chunk();
    data.skip(3);                       // manifold, oriented, solid
    if (data.flag()) data.anonymous();  // n-gons
    if (!data.flag()) return std::nullopt;
    RhinoBytes block = data.anonymous();
    const std::size_t count = block.natural();
    return points_of<double>(block.buffer(double_point * count));
}

Points3 read_vertices(RhinoBytes& data, std::size_t count, RhinoBytes::Version version, unsigned writer,
                      const RhinoClass& object, double& rounding) {
    Points3 coarse;
    std::optional<Points3> fine = double_vertices_beside(object);
    if (version.major == 1) {
        if (data.count(float_point) != count) data.refuse("two different numbers of vertices");
        coarse = points_of<float>(data.take(float_point * count).view());
    } else if (count > 0) {
        coarse = points_of<float>(data.buffer(float_point * count));
        for (int unused = 0; unused < 4; ++unused) data.skip_buffer();  // normals, texture, curvature, colours
        if (auto within = double_vertices_within(data, version.minor, writer)) fine = std::move(within);
    }
    if (fine && fits(*fine, coarse)) return std::move(*fine);
    if (coarse.size() > 0) rounding = single_rounding(coarse.cwiseAbs().maxCoeff());
    return coarse;
}

void require_sound(const Points3& points, const Quads& faces, const RhinoBytes& data, const std::string& called) {
    const auto refuse = [&](const std::string& found) {
        throw InputError(data.name() + ": " + called + ": " + found + "; repair it in Rhino (MeshRepair) or delete it");
    };
    for (Eigen::Index f = 0; f < faces.rows(); ++f)
        for (Eigen::Index k = 0; k < 4; ++k)
            if (faces(f, k) < 0 || faces(f, k) >= points.rows())
                refuse("face " + std::to_string(f + 1) + " has the vertex " +
                       std::to_string(static_cast<std::uint32_t>(faces(f, k))) + " of " +
                       std::to_string(points.rows()) + ", counted from 0");
    for (Eigen::Index v = 0; v < points.rows(); ++v)
        if (!(points.row(v).cwiseAbs().maxCoeff() < largest_in_mesh) || !points.row(v).allFinite())
            refuse("vertex " + std::to_string(v) + " has a coordinate that is not a number below 1e12");
}

/// The corner, 0 or 1, from which a quad is fanned into two triangles.
int fan_corner_of_quad(const Points3& points, const Eigen::Matrix<int, 1, 4>& quad) {
    const auto at = [&](int k) -> Vec3 { return points.row(quad[k & 3]); };
    const auto half = [&](int a, int b, int c) -> Vec3 { return (at(b) - at(a)).cross(at(c) - at(a)); };
    const Vec3 area = (at(2) - at(0)).cross(at(3) - at(1));
    const auto is_plain = [&](int corner) {
        return half(corner, corner + 1, corner + 2).dot(area) > 0 && half(corner, corner + 2, corner + 3).dot(area) > 0;
    };
    const bool plain0 = is_plain(0), plain1 = is_plain(1);
    if (plain0 != plain1) return plain0 ? 0 : 1;
    return (at(3) - at(1)).norm() < (1 - 1e-6) * (at(2) - at(0)).norm() ? 1 : 0;
}

/// A triangle is stored as a quad with equal last corners.
Triangles triangulated(const Points3& points, const Quads& faces, int& left_out) {
    Triangles triangles(2 * faces.rows(), 3);
    Eigen::Index count = 0;
    const auto add = [&](int a, int b, int c) {
        if (a == b || b == c || c == a) return 0;
        triangles.row(count++) << a, b, c;
        return 1;
    };
    for (Eigen::Index f = 0; f < faces.rows(); ++f) {
        const Eigen::Matrix<int, 1, 4> quad = faces.row(f);
        int added = 0;
        if (quad[2] == quad[3]) {
            added = add(quad[0], quad[1], quad[2]);
        } else {
            const int c = fan_corner_of_quad(points, quad);
            added = add(quad[c], quad[c + 1], quad[c + 2]) + add(quad[c], quad[c + 2], quad[(c + 3) & 3]);
        }
        if (added == 0) ++left_out;
    }
    triangles.conservativeResize(count, 3);
    return triangles;
}

int part_count(const TriangleMesh& mesh) {
    const std::vector<int> parts = connected_parts(mesh);
    return parts.empty() ? 0 : *std::max_element(parts.begin(), parts.end()) + 1;
}

void join_parts(RhinoMesh& found) {
    const int parts = part_count(found.mesh);
    if (parts < 2) return;
    TriangleMesh joined = join_coincident(found.mesh);
    if (part_count(joined) == parts) return;
    found.joined = found.mesh.vertex_count() - joined.vertex_count();
    found.mesh = std::move(joined);
}

}  // namespace

RhinoMesh read_rhino_mesh(const RhinoClass& object, unsigned writer, const std::string& called) {
    RhinoBytes data = object.data;
    const auto version = data.packed_version();
    if (version.major != 1 && version.major != 3)
        data.refuse(called + " has the format " + std::to_string(version.major) + ", expected 1 or 3");
    const std::size_t vertices = data.natural(), faces = data.natural();
    data.skip(10 * sizeof(double));     // texture and surface domains, scale
    data.skip(16 * sizeof(float) + 4);  // boxes, whether closed
    if (data.flag()) data.chunk();      // meshing parameters
    for (int i = 0; i < 4; ++i)
        if (data.flag()) data.chunk();  // curvature
    const Quads quads = read_faces(data, faces);
    RhinoMesh found;
    const Points3 points = read_vertices(data, vertices, version, writer, object, found.rounding);
    require_sound(points, quads, data, called);
    found.mesh = drop_unused({points, triangulated(points, quads, found.faces_left_out)});
    join_parts(found);
    return found;
}

}  // namespace ripstop
