#include "ripstop/tile/make_tile.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "ripstop/base/error.h"
#include "ripstop/base/index.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/geometry/triangle.h"
#include "ripstop/mesh/adjacency.h"
#include "ripstop/mesh/boundary.h"
#include "ripstop/mesh/disk.h"
#include "ripstop/mesh/unroll.h"
#include "ripstop/model/tile/corner_turn.h"
#include "ripstop/tile/cloth_warp.h"

namespace ripstop {
namespace {

constexpr double least_agreement = 0.3;  // of directions in space: below this, the mean represents none of them
constexpr double least_facing = 0.3;     // fraction of the area: below this, a tile goes right round and faces no side
constexpr const char* laid_on_cloth = ", laid along the cloth because the tile goes right round";
constexpr double alike = 1e-6;        // relative difference of second moments: smaller ones differ by rounding only
constexpr double corner_reach = 0.1;  // relative to the tile's size: largest distance of a given corner from the
                                      // boundary

void require_near(const std::string& name, const TriangleMesh& mesh, const Vec3& corner, double away) {
    const double size = (mesh.positions.colwise().maxCoeff() - mesh.positions.colwise().minCoeff()).norm();
    if (away <= corner_reach * size) return;
    const auto metres = [](double length) { return format_fixed(length, 3); };
    throw InputError("tile " + name + ": its corner (" + metres(corner.x()) + ", " + metres(corner.y()) + ", " +
                     metres(corner.z()) + ") m is " + metres(away) +
                     " m off its boundary, expected a point on it; correct it, or the unit");
}

std::vector<int> corner_positions(const std::string& name, const TriangleMesh& mesh, const std::vector<int>& boundary,
                                  const TileOptions& options) {
    const std::size_t count = boundary.size();
    std::vector<bool> corner(count, false);
    if (options.corners.empty()) {
        const Eigen::VectorXd turning = surface_turning(mesh, boundary);
        for (std::size_t i = 0; i < count; ++i)
            corner[i] = std::abs(turning[static_cast<Eigen::Index>(i)]) > options.corner_angle + corner_rounding;
    } else {
        for (const Vec3& point : options.corners) {
            std::size_t nearest = 0;
            for (std::size_t i = 1; i < count; ++i)
                if ((Vec3(mesh.positions.row(boundary[i])) - point).squaredNorm() <
                    (Vec3(mesh.positions.row(boundary[nearest])) - point).squaredNorm())
                    nearest = i;
            require_near(name, mesh, point, (Vec3(mesh.positions.row(boundary[nearest])) - point).norm());
            corner[nearest] = true;
        }
    }
    std::vector<int> positions;
    for (std::size_t i = 0; i < count; ++i)
        if (corner[i]) positions.push_back(static_cast<int>(i));
    return positions;
}

std::vector<Chain> cut_into_chains(const std::vector<int>& boundary, const std::vector<int>& corners) {
    if (corners.empty()) return {Chain{closed(boundary)}};
    const int count = static_cast<int>(boundary.size());
    std::vector<Chain> chains;
    for (std::size_t c = 0; c < corners.size(); ++c) {
        int end = corners[(c + 1) % corners.size()];
        if (end <= corners[c]) end += count;
        Chain chain;
        for (int i = corners[c]; i <= end; ++i) chain.vertices.push_back(boundary[at(i % count)]);
        chains.push_back(std::move(chain));
    }
    return chains;
}

/// The area-weighted mean of the directions. If they cancel in space, as round a tube, that of the middle triangle.
Vec3 mean_direction(const TriangleMesh& mesh, const Points3& directions) {
    const Vec3 mean = directions.transpose() * triangle_areas(mesh);
    if (mean.norm() > least_agreement * surface_area(mesh)) return mean.normalized();
    return directions.row(middle_triangle(mesh)).transpose().normalized();
}

/// A grain with the given field; its `direction` is the area-weighted mean.
Grain grain_of_field(const std::string& name, const TriangleMesh& mesh, const TileOptions& options) {
    Grain grain{Vec3::Zero(), options.warp_source, options.warp_field};
    if (grain.field.rows() != mesh.triangle_count())
        throw InputError("tile " + name + ": " + std::to_string(grain.field.rows()) + " warps for " +
                         std::to_string(mesh.triangle_count()) + " triangles, expected one each");
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const double length = grain.field.row(t).norm();
        if (!(length > 0) || !std::isfinite(length))
            throw InputError("tile " + name + ": the warp of triangle " + std::to_string(t + 1) +
                             " has no direction; give a vector other than zero");
        grain.field.row(t) /= length;
    }
    if (lay_on_cloth(mesh, grain.field).laid_on_cloth)
        throw InputError("tile " + name +
                         ": the warps of its triangles have no common direction on the cloth; "
                         "turn them to the same side or leave them out");
    grain.direction = mean_direction(mesh, grain.field);
    return grain;
}

/// Rotates the warp triangle by triangle on the cloth, for a tile that goes right round and has no side to be seen
/// from.
Grain turned_on_cloth(const TriangleMesh& mesh, const Eigen::Matrix2Xd& warp, double angle) {
    Grain grain{Vec3::Zero(), {}, warp_in_space(mesh, warp, angle)};
    grain.direction = mean_direction(mesh, grain.field);
    return grain;
}

Grain make_grain(const std::string& name, const TriangleMesh& mesh, const TileOptions& options) {
    const Vec3 facing = area_vector(mesh), normal = facing.normalized();
    const bool has_side = facing.norm() > least_facing * surface_area(mesh);
    if (options.warp) {
        const double length = options.warp->norm();
        if (!(length > 0) || !std::isfinite(length))
            throw InputError("tile " + name + ": the warp has no direction; give two different points or a vector");
        const Vec3 direction = *options.warp / length;
        if (has_side && (direction - direction.dot(normal) * normal).norm() < 0.05)
            throw InputError("tile " + name +
                             ": the warp is perpendicular to the tile; give a direction that runs "
                             "along the cloth");
        const bool laid = lay_on_cloth(mesh, direction.transpose()).laid_on_cloth;
        return {direction, options.warp_source + (laid ? laid_on_cloth : "")};
    }
    if (options.warp_field.rows() > 0) return grain_of_field(name, mesh, options);
    const Vec3 axis = longest_axis(mesh);
    const ClothWarp warp = lay_on_cloth(mesh, axis.transpose());
    const double angle = options.grain_turn.value_or(0);
    Grain grain{axis, {}};
    if (angle != 0)
        grain = has_side && !warp.laid_on_cloth ? Grain{Eigen::AngleAxisd(angle, normal) * axis, {}}
                                                : turned_on_cloth(mesh, warp.along, angle);
    const double degrees = std::round(angle / degree * 1000) / 1000;
    grain.source = "longest axis";
    if (angle != 0) grain.source += " turned by " + format_shortest(degrees) + " degrees";
    if (warp.laid_on_cloth) grain.source += laid_on_cloth;
    return grain;
}

}  // namespace

Vec3 longest_axis(const TriangleMesh& mesh) {
    const Vec3 centre = centroid(mesh);
    Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const double area = triangle_area(mesh, t);
        Vec3 sum = Vec3::Zero();
        for (int k = 0; k < 3; ++k) {
            const Vec3 x = mesh.corner(t, k) - centre;
            moment += area / 12 * x * x.transpose();
            sum += x;
        }
        moment += area / 12 * sum * sum.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moment);
    Vec3 axis = solver.eigenvectors().col(2).normalized();
    if (solver.eigenvalues()[1] > (1 - alike) * solver.eigenvalues()[2])
        axis = longest_axis_on_cloth(mesh).value_or(axis);
    for (const int k : {2, 1, 0}) {
        if (std::abs(axis[k]) < 1e-9) continue;
        if (axis[k] < 0) axis = -axis;
        break;
    }
    return axis;
}

Tile make_tile(std::string name, TriangleMesh mesh, const TileOptions& options) {
    const Adjacency adjacency(mesh.triangles, mesh.vertex_count());
    Tile tile;
    tile.boundary = require_disk(mesh, adjacency, name);
    tile.chains = cut_into_chains(tile.boundary, corner_positions(name, mesh, tile.boundary, options));
    tile.grain = make_grain(name, mesh, options);
    tile.drawn = options.drawn;
    tile.compensation = options.compensation;
    tile.attributes = options.attributes;
    tile.name = std::move(name);
    tile.mesh = std::move(mesh);
    return tile;
}

}  // namespace ripstop
