#include "ripstop/model/tile/tile.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "ripstop/base/error.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/geometry/triangle.h"
#include "ripstop/mesh/adjacency.h"
#include "ripstop/mesh/disk.h"
#include "ripstop/mesh/unroll.h"
#include "ripstop/model/tile/cloth_warp.h"
#include "ripstop/model/tile/corner_turn.h"

namespace ripstop {
namespace {

constexpr double least_agreement = 0.3;  // of directions in space: below this, the mean represents none of them
constexpr double least_facing = 0.3;     // fraction of the area: below this, a tile goes right round and faces no side
constexpr const char* laid_on_cloth = ", laid along the cloth as the tile runs round";
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
        for (int i = corners[c]; i <= end; ++i) chain.vertices.push_back(boundary[static_cast<std::size_t>(i % count)]);
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
                         ": the warps of its triangles point every way, expected one way along the cloth; "
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
                             ": the warp stands upright on the tile; give a direction that runs "
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

template <class Points>
Eigen::VectorXd lengths(const Points& positions, const std::vector<int>& vertices) {
    Eigen::VectorXd result(std::max<Eigen::Index>(0, static_cast<Eigen::Index>(vertices.size()) - 1));
    for (Eigen::Index i = 0; i < result.size(); ++i)
        result[i] = (positions.row(vertices[static_cast<std::size_t>(i) + 1]) -
                     positions.row(vertices[static_cast<std::size_t>(i)]))
                        .norm();
    return result;
}

/// (I + 2 E)^(-1/2): maps the drawn triangle to the cloth that has the strain E (E11, E22, 2 E12) when it is
/// stretched to it.
Mat22 unstretched(const Vec3& strain) {
    Mat22 C;
    C << 1 + 2 * strain[0], strain[2], strain[2], 1 + 2 * strain[1];
    return Eigen::SelfAdjointEigenSolver<Mat22>(C).operatorInverseSqrt();
}

Tile without_strain(Tile tile) {
    tile.compensation.strain.resize(0, 3);
    return tile;
}

}  // namespace

std::vector<int> closed(std::vector<int> loop) {
    if (!loop.empty()) loop.push_back(loop.front());
    return loop;
}

Eigen::VectorXd edge_lengths(const Points3& positions, const std::vector<int>& vertices) {
    return lengths(positions, vertices);
}
Eigen::VectorXd edge_lengths(const Points2& positions, const std::vector<int>& vertices) {
    return lengths(positions, vertices);
}

Eigen::VectorXd surface_turning(const TriangleMesh& mesh, const std::vector<int>& boundary) {
    Eigen::VectorXd angle = Eigen::VectorXd::Zero(mesh.vertex_count());
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k)
            angle[mesh.triangles(t, k)] +=
                angle_at(mesh.corner(t, k), mesh.corner(t, (k + 1) % 3), mesh.corner(t, (k + 2) % 3));
    Eigen::VectorXd turning(static_cast<Eigen::Index>(boundary.size()));
    for (Eigen::Index i = 0; i < turning.size(); ++i)
        turning[i] = std::numbers::pi - angle[boundary[static_cast<std::size_t>(i)]];
    return turning;
}

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

Eigen::Matrix2Xd warp_in_triangles(const Tile& tile) {
    const Points3& field = tile.grain.field;
    return lay_on_cloth(tile.mesh, field.rows() > 0 ? field : Points3(tile.grain.direction.transpose())).along;
}

std::vector<Mat22> target_triangles(const Tile& tile) {
    std::vector<Mat22> targets(static_cast<std::size_t>(tile.mesh.triangle_count()));
    for (int t = 0; t < tile.mesh.triangle_count(); ++t)
        targets[static_cast<std::size_t>(t)] =
            lay_flat(tile.mesh.corner(t, 0), tile.mesh.corner(t, 1), tile.mesh.corner(t, 2));
    const Compensation& given = tile.compensation;
    const bool is_strained = given.strain.rows() > 0;
    if (given.warp == 0 && given.weft == 0 && !is_strained) return targets;
    const Eigen::Matrix2Xd warp = warp_in_triangles(tile);
    for (int t = 0; t < tile.mesh.triangle_count(); ++t) {
        const Vec2 along = warp.col(t), across(-along.y(), along.x());
        Mat22 target = targets[static_cast<std::size_t>(t)];
        if (is_strained) {
            Mat22 axes;
            axes << along, across;
            target = axes * unstretched(given.strain.row(t)) * axes.transpose() * target;
        }
        const Mat22 longer =
            Mat22::Identity() + given.warp * along * along.transpose() + given.weft * across * across.transpose();
        targets[static_cast<std::size_t>(t)] = longer * target;
    }
    return targets;
}

Eigen::VectorXd drawn_lengths(const Tile& tile) {
    if (tile.curve_lengths.size() > 0) return tile.curve_lengths;
    return edge_lengths(tile.mesh.positions, closed(tile.boundary));
}

Eigen::VectorXd target_lengths(const Tile& tile) {
    Eigen::VectorXd lengths = drawn_lengths(tile);
    if (!tile.compensation.any()) return lengths;
    // If the edges have their own compensation, the triangles contribute only warp and weft.
    const bool is_told = tile.compensation.edges.size() > 0;
    const Eigen::VectorXd chords = edge_lengths(tile.mesh.positions, closed(tile.boundary));
    const std::vector<Mat22> targets = target_triangles(is_told ? without_strain(tile) : tile);
    const Adjacency adjacency(tile.mesh.triangles, tile.mesh.vertex_count());
    Eigen::VectorXd leaving(tile.mesh.vertex_count());  // target length of the boundary edge that starts at each vertex
    for (int h = 0; h < adjacency.half_edge_count(); ++h) {
        if (!adjacency.is_boundary(h)) continue;
        const Mat22& target = targets[static_cast<std::size_t>(Adjacency::triangle(h))];
        leaving[adjacency.from(h)] = triangle_edge(target, h % 3).norm();
    }
    Eigen::Index edge = 0;
    std::vector<double> extra(tile.chains.size(), 0);
    std::copy_n(tile.compensation.chains.begin(), std::min(extra.size(), tile.compensation.chains.size()),
                extra.begin());
    std::vector<Eigen::Index> place(static_cast<std::size_t>(tile.mesh.vertex_count()));
    for (const int v : tile.boundary) place[static_cast<std::size_t>(v)] = edge++;
    for (std::size_t c = 0; c < tile.chains.size(); ++c)
        for (int i = 0; i < tile.chains[c].edge_count(); ++i) {
            const int v = tile.chains[c].vertices[static_cast<std::size_t>(i)];
            const Eigen::Index at = place[static_cast<std::size_t>(v)];
            lengths[at] *= leaving[v] / chords[at] * (1 + extra[c]) * (is_told ? tile.compensation.edges[at] : 1);
        }
    return lengths;
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
