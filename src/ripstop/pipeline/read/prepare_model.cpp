#include "ripstop/pipeline/read/prepare_model.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "ripstop/base/index.h"
#include "ripstop/base/parallel.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/mesh/change/mend.h"

namespace ripstop {
namespace {

constexpr double far = 1000;  // distance from the origin, in sizes of the model
constexpr std::size_t shown_names = 3;

/// The rows of the remaining vertices or triangles.
template <class Rows>
Rows rows_of(const Rows& rows, const std::vector<int>& kept) {
    Rows result(static_cast<Eigen::Index>(kept.size()), rows.cols());
    for (std::size_t i = 0; i < kept.size(); ++i) result.row(static_cast<Eigen::Index>(i)) = rows.row(kept[i]);
    return result;
}

/// Whether vertices that are merged have the same drawn position too.
bool drawn_alike(const NamedMesh& surface, const MendedMesh& mended) {
    for (std::size_t v = 0; surface.drawn && v < mended.becomes.size(); ++v) {
        if (mended.becomes[v] < 0) continue;
        const int kept = mended.vertex[at(mended.becomes[v])];
        if (surface.drawn->row(static_cast<Eigen::Index>(v)) != surface.drawn->row(kept)) return false;
    }
    return true;
}

MendedMesh mended_of(const NamedMesh& surface, double tip_width) {
    MendedMesh mended = mend_mesh(surface.mesh, {false, tip_width});
    if (mended.welded + mended.closed > 0 && !drawn_alike(surface, mended)) mended = mend_mesh(surface.mesh, {true});
    return mended;
}

void take(NamedMesh& surface, MendedMesh&& mended) {
    if (surface.drawn && drawn_alike(surface, mended))
        surface.drawn = rows_of(*surface.drawn, mended.vertex);
    else
        surface.drawn.reset();
    if (surface.warp.rows() > 0) surface.warp = rows_of(surface.warp, mended.triangle);
    surface.mesh = std::move(mended.mesh);
}

/// The repairs of one kind in all surfaces.
struct MendedKind {
    int MendedMesh::*count;
    const char *one, *many, *done;
};

constexpr MendedKind kinds[] = {
    {&MendedMesh::joined, "vertex", "vertices", "merged with another in the same place"},
    {&MendedMesh::flat, "triangle without area", "triangles without area", "removed"},
    {&MendedMesh::doubled, "triangle", "triangles", "that coincided with another removed"},
    {&MendedMesh::unused, "unused vertex", "unused vertices", "removed"},
    {&MendedMesh::welded, "vertex", "vertices", "of tips, separate for each triangle, welded"},
    {&MendedMesh::closed, "tip", "tips", "narrower than the seam tolerance closed to points"},
};

std::string place_in_model(const Vec3& at) {
    return "(" + format_fixed(at.x(), 4) + ", " + format_fixed(at.y(), 4) + ", " + format_fixed(at.z(), 4) + ")";
}

std::string sentence(const CadModel& model, const std::vector<MendedMesh>& mended, const MendedKind& kind) {
    int sum = 0;
    std::vector<std::size_t> surfaces;
    for (std::size_t s = 0; s < mended.size(); ++s) {
        sum += mended[s].*kind.count;
        if (mended[s].*kind.count > 0) surfaces.push_back(s);
    }
    if (sum == 0) return {};
    std::string names;
    for (std::size_t i = 0; i < std::min(surfaces.size(), shown_names); ++i)
        names += (i ? ", " : "") + model.surfaces[surfaces[i]].name;
    if (surfaces.size() > shown_names) names += " and " + std::to_string(surfaces.size() - shown_names) + " more";
    return std::to_string(sum) + " " + (sum == 1 ? kind.one : kind.many) + " " + kind.done + ": in " + names +
           (surfaces.size() == 1 ? ", near " : ", the first near ") + place_in_model(mended[surfaces.front()].place);
}

}  // namespace

std::vector<std::string> mend_surfaces(CadModel& model, double tip_width, int threads) {
    std::vector<MendedMesh> mended(model.surfaces.size());
    parallel_for(static_cast<int>(mended.size()), threads, [&](int s) {
        const NamedMesh& surface = model.surfaces[at(s)];
        if (surface.fault.empty()) mended[at(s)] = mended_of(surface, tip_width);
    });
    std::vector<std::string> sentences;
    for (const MendedKind& kind : kinds)
        if (std::string text = sentence(model, mended, kind); !text.empty()) sentences.push_back(std::move(text));
    for (std::size_t s = 0; s < mended.size(); ++s)
        if (mended[s].any()) take(model.surfaces[s], std::move(mended[s]));
    return sentences;
}

Vec3 far_origin(const CadModel& model) {
    Eigen::AlignedBox3d box;
    for (const NamedMesh& surface : model.surfaces)
        for (Eigen::Index v = 0; v < surface.mesh.positions.rows(); ++v)
            box.extend(Vec3(surface.mesh.positions.row(v)));
    if (box.isEmpty()) return Vec3::Zero();
    const Vec3 centre = box.center();
    const double size = box.sizes().maxCoeff();
    Vec3 origin = Vec3::Zero();
    for (int axis = 0; axis < 3; ++axis)
        if (std::abs(centre[axis]) > far * size) origin[axis] = std::round(centre[axis]);
    return origin;
}

void count_from(const Vec3& origin, CadModel& model) {
    for (NamedMesh& surface : model.surfaces) surface.mesh.positions.rowwise() -= origin.transpose();
    for (NamedCurve& curve : model.curves) curve.points.rowwise() -= origin.transpose();
}

void count_from(const Vec3& origin, double metres, Project& project) {
    for (ProjectTile& tile : project.tiles) {
        if (tile.at) *tile.at -= origin;
        for (Vec3& corner : tile.corners) corner -= origin;
    }
    for (InnerTie& tie : project.flight.rigging.ties) {
        tie.from -= metres * origin;
        tie.to -= metres * origin;
    }
    if (project.flight.load.mouth_plane) *project.flight.load.mouth_plane -= metres * origin.z();
}

}  // namespace ripstop
