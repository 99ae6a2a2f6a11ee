#include <algorithm>
#include <ostream>

#include "ripstop/io/mesh/binary.h"
#include "ripstop/io/mesh/ply.h"

namespace ripstop {
namespace {

template <class Numbers>
void append(std::string& text, const Numbers& row) {
    for (Eigen::Index k = 0; k < row.size(); ++k) append_little_endian<double>(text, row(k));
}

std::string header(const std::vector<NamedMesh>& meshes, bool drawn, bool warp) {
    std::string text = "ply\nformat binary_little_endian 1.0\ncomment written by ripstop\ncomment unit m\n";
    Eigen::Index vertices = 0, triangles = 0;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        text += "comment tile " + std::to_string(i + 1) + " " + meshes[i].name + "\n";
        vertices += meshes[i].mesh.positions.rows();
        triangles += meshes[i].mesh.triangles.rows();
    }
    text +=
        "element vertex " + std::to_string(vertices) + "\nproperty double x\nproperty double y\nproperty double z\n";
    if (drawn) text += "property double u\nproperty double v\n";
    text +=
        "element face " + std::to_string(triangles) + "\nproperty list uchar int vertex_indices\nproperty int tile\n";
    if (warp) text += "property double warp_x\nproperty double warp_y\nproperty double warp_z\n";
    return text + "end_header\n";
}

}  // namespace

void write_ply(std::ostream& out, const std::vector<NamedMesh>& meshes) {
    const bool drawn =
        std::all_of(meshes.begin(), meshes.end(), [](const NamedMesh& m) { return m.drawn.has_value(); });
    const bool warp = std::any_of(meshes.begin(), meshes.end(), [](const NamedMesh& m) { return m.warp.rows() > 0; });
    out << header(meshes, drawn, warp);
    for (const NamedMesh& surface : meshes) {
        std::string bytes;
        for (Eigen::Index v = 0; v < surface.mesh.positions.rows(); ++v) {
            append(bytes, surface.mesh.positions.row(v));
            if (drawn) append(bytes, surface.drawn->row(v));
        }
        out << bytes;
    }
    std::int32_t first = 0, tile = 0;
    for (const NamedMesh& surface : meshes) {
        ++tile;
        std::string bytes;
        for (Eigen::Index t = 0; t < surface.mesh.triangles.rows(); ++t) {
            append_little_endian<std::uint8_t>(bytes, 3);
            for (Eigen::Index k = 0; k < 3; ++k)
                append_little_endian<std::int32_t>(bytes, first + surface.mesh.triangles(t, k));
            append_little_endian<std::int32_t>(bytes, tile);
            if (warp) append(bytes, surface.warp.rows() > 0 ? Vec3(surface.warp.row(t)) : Vec3(Vec3::Zero()));
        }
        out << bytes;
        first += static_cast<std::int32_t>(surface.mesh.positions.rows());
    }
}

}  // namespace ripstop
