#pragma once

#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "require.h"
#include "ripstop/base/error.h"
#include "ripstop/io/mesh/mesh_file.h"
#include "ripstop/mesh/change/mend.h"

namespace ripstop::fuzzing {

/// The maps of a mended mesh name existing vertices and triangles of the original.
inline void require_maps(const TriangleMesh& mesh, const MendedMesh& mended) {
    const TriangleMesh& now = mended.mesh;
    require(std::cmp_equal(mended.vertex.size(), now.vertex_count()) &&
            std::cmp_equal(mended.triangle.size(), now.triangle_count()) &&
            std::cmp_equal(mended.becomes.size(), mesh.vertex_count()));
    require(now.triangles.size() == 0 ||
            (now.triangles.minCoeff() >= 0 && now.triangles.maxCoeff() < now.vertex_count()));
    for (const int v : mended.vertex) require(v >= 0 && v < mesh.vertex_count());
    for (const int v : mended.becomes) require(v >= -1 && v < now.vertex_count());
    for (const int t : mended.triangle) require(t >= 0 && t < mesh.triangle_count());
}

/// Vertices stay in place, except at a tip that is closed.
inline void require_mendable(const TriangleMesh& mesh) {
    const MendedMesh mended = mend_mesh(mesh);
    require_maps(mesh, mended);
    for (std::size_t v = 0; v < mended.vertex.size(); ++v)
        require(mended.mesh.positions.row(static_cast<Eigen::Index>(v)) == mesh.positions.row(mended.vertex[v]));
    require_maps(mesh, mend_mesh(mesh, {false, 0.1}));
}

inline void require_sound(const CadModel& model) {
    require(!model.surfaces.empty());
    for (const auto& [name, mesh, drawn, warp, attributes, fault] : model.surfaces) {
        require(!name.empty() && mesh.triangle_count() > 0);
        require(mesh.triangles.minCoeff() >= 0 && mesh.triangles.maxCoeff() < mesh.vertex_count());
        require(mesh.positions.allFinite());
        require(!drawn || (drawn->rows() == mesh.vertex_count() && drawn->allFinite()));
        require_mendable(mesh);
        require(warp.rows() == 0 || (warp.rows() == mesh.triangle_count() && warp.allFinite()));
    }
    for (const NamedCurve& curve : model.curves)
        require(!curve.name.empty() && curve.points.rows() >= 2 && curve.points.allFinite());
}

inline void require_equal(const NamedMesh& a, const NamedMesh& b, const MeshKept& kept) {
    require(!kept.names || a.name == b.name);
    require(a.mesh.triangle_count() == b.mesh.triangle_count());
    for (int t = 0; t < a.mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k) require(a.mesh.corner(t, k) == b.mesh.corner(t, k));
    require(!kept.vertices || (a.mesh.positions == b.mesh.positions && a.mesh.triangles == b.mesh.triangles));
    require(!kept.some_drawn || a.drawn == b.drawn);
    require(!kept.warp || a.warp == b.warp);
}

/// Any bytes give sound surfaces or an InputError that names the file. What was read can be written and read
/// again, as far as the format preserves it.
inline int check_reader(std::string_view extension, const std::uint8_t* data, std::size_t size) {
    for (const MeshFormat& format : mesh_formats()) {
        if (format.extension != extension) continue;
        std::istringstream in(std::string(reinterpret_cast<const char*>(data), size));
        CadModel model;
        try {
            model = format.read(in, "fuzz");
        } catch (const InputError& error) {
            require(std::string_view(error.what()).starts_with("fuzz:"));
            return 0;
        }
        require_sound(model);
        std::stringstream written;
        format.write(written, model.surfaces);
        const std::vector<NamedMesh> again = format.read(written, "fuzz").surfaces;
        require(again.size() == model.surfaces.size());
        for (std::size_t i = 0; i < again.size(); ++i) require_equal(model.surfaces[i], again[i], format.kept);
        return 0;
    }
    std::abort();
}

}  // namespace ripstop::fuzzing
