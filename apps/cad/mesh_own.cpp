#include <Standard_Failure.hxx>
#include <limits>

#include "fill.h"

namespace ripstop::cad {
namespace {

constexpr int most_tries = 4;  // with borders twice as fine each time, because a coarse one may cross itself in u and v

/// The meshes of the faces that could be filled, and the numbers of the others.
struct Attempted {
    Meshes meshes;
    std::vector<std::size_t> failed = {};
    bool hopeless = false;  ///< one of these has no closed border in u and v
};

Triangles in_rows(const Filled& face, int first_inner) {
    Triangles triangles(static_cast<Eigen::Index>(face.triangles.size()), 3);
    for (std::size_t t = 0; t < face.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const int corner = face.triangles[t][k];
            triangles(static_cast<Eigen::Index>(t), static_cast<Eigen::Index>(k)) =
                corner < 0 ? first_inner - 1 - corner : corner;
        }
    return triangles;
}

Attempted attempt(const std::vector<TopoDS_Face>& faces, const EdgeSizes& sizes,
                  const std::vector<std::optional<FaceSizes>>& face_sizes, const std::vector<double>& borders_finer,
                  const Told& told) {
    const Borders borders(faces, face_sizes, sizes, borders_finer);
    std::vector<Vec3> points = borders.points();
    Attempted result;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        Triangles& triangles = result.meshes.faces.emplace_back(0, 3);
        if (faces[f].IsNull()) continue;
        told(f);
        const double most = sizes.most.empty() ? std::numeric_limits<double>::infinity() : sizes.most[f];
        const auto loops = borders.loops(faces[f], *face_sizes[f]);
        const auto face = loops ? filled(faces[f], *loops, borders.points(), *face_sizes[f], most) : std::nullopt;
        if (!face || face->triangles.empty()) {
            result.failed.push_back(f);
            result.hopeless = result.hopeless || !loops;
            continue;
        }
        triangles = in_rows(*face, static_cast<int>(points.size()));
        points.insert(points.end(), face->inner.begin(), face->inner.end());
    }
    Points3& positions = result.meshes.positions;
    positions.resize(static_cast<Eigen::Index>(points.size()), 3);
    for (std::size_t i = 0; i < points.size(); ++i) positions.row(static_cast<Eigen::Index>(i)) = points[i];
    return result;
}

std::optional<Meshes> filled_faces(const std::vector<TopoDS_Face>& faces, const EdgeSizes& sizes, const Told& told) {
    std::vector<std::optional<FaceSizes>> face_sizes(faces.size());
    for (std::size_t f = 0; f < faces.size(); ++f)
        if (!faces[f].IsNull()) face_sizes[f].emplace(faces[f], sizes, sizes.finer.empty() ? 1 : sizes.finer[f]);
    std::vector<double> borders_finer(faces.size(), 1);
    for (int n = 0; n < most_tries; ++n) {
        Attempted attempted = attempt(faces, sizes, face_sizes, borders_finer, told);
        if (attempted.failed.empty()) return std::move(attempted.meshes);
        if (attempted.hopeless) break;
        for (const std::size_t f : attempted.failed) borders_finer[f] /= 2;
    }
    return {};
}

}  // namespace

std::optional<Meshes> meshed_in_parameters(const std::vector<TopoDS_Face>& faces, const EdgeSizes& sizes,
                                           const Told& told) {
    try {
        return filled_faces(faces, sizes, told);
    } catch (const Standard_Failure&) {  // the kernel cannot locate an edge on the face
        return {};
    }
}

}  // namespace ripstop::cad
