#include "support/flat_tiles.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "ripstop/geometry/polygon.h"
#include "ripstop/geometry/triangle.h"
#include "ripstop/mesh/adjacency.h"
#include "ripstop/mesh/boundary.h"
#include "ripstop/pattern/piece/pieces.h"
#include "ripstop/tile/make_tile.h"
#include "support/shapes.h"

namespace ripstop::testing {
namespace {

Accuracy measured(const Tile& tile, const Points2& flat) {
    Accuracy accuracy;
    for (int t = 0; t < tile.mesh.triangle_count(); ++t) {
        const auto corner = [&](int k) { return Vec2(flat.row(tile.mesh.triangles(t, k))); };
        const double area = triangle_area(tile.mesh, t);
        const double flat_area = signed_area(corner(0), corner(1), corner(2));
        accuracy.area += area;
        accuracy.flat_area += flat_area;
        accuracy.area_error_abs += std::abs(flat_area - area);
        accuracy.flipped += flat_area <= 0;
    }
    accuracy.area_error = accuracy.flat_area / accuracy.area - 1;
    accuracy.area_error_abs /= accuracy.area;
    for (const Chain& chain : tile.chains) {
        const double length = edge_lengths(tile.mesh.positions, chain.vertices).sum();
        const double flat_length = edge_lengths(flat, chain.vertices).sum();
        accuracy.chains.push_back({length, flat_length});
        accuracy.perimeter += length;
        accuracy.flat_perimeter += flat_length;
    }
    accuracy.perimeter_error = accuracy.flat_perimeter / accuracy.perimeter - 1;
    return accuracy;
}

}  // namespace

FlatTile flat_tile(const std::string& name, const TriangleMesh& mesh, const Points2& positions) {
    FlatTile result;
    result.tile = make_tile(name, mesh);
    result.method = "by hand";
    result.flattening = {positions, {Termination::converged, 12, 3, "energy at rest"}};
    result.accuracy = measured(result.tile, positions);
    result.verdict.judged = true;
    result.seconds = 0.25;
    return result;
}

FlatTile flat_cylinder(const std::string& name) {
    const double radius = 1, angle = 0.6, height = 0.5;
    const int columns = 12, rows = 8;
    const TriangleMesh mesh = cylinder(radius, angle, height, columns, rows);
    const double chord = 2 * radius * std::sin(angle / columns / 2);
    Points2 flat(mesh.vertex_count(), 2);
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i) flat.row(j * (columns + 1) + i) << chord * i, height * j / rows;
    return flat_tile(name, mesh, flat);
}

FlatTile sinusoidal_gore(const std::string& name) {
    const TriangleMesh mesh = lune(std::numbers::pi / 8, 6, 48);
    Points2 flat(mesh.vertex_count(), 2);
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        const Vec3 p = mesh.positions.row(v);
        const double latitude = std::asin(std::clamp(p.z(), -1.0, 1.0));
        flat.row(v) << latitude, -std::atan2(p.y(), p.x()) * std::cos(latitude);
    }
    return flat_tile(name, mesh, flat);
}

FlatTile flat_polygon(const std::string& name, const Points2& corners) {
    // Ear clipping; test polygons are small.
    std::vector<int> left;
    for (int i = 0; i < corners.rows(); ++i) left.push_back(i);
    std::vector<Eigen::Vector3i> triangles;
    while (left.size() > 2) {
        bool cut = false;
        for (std::size_t i = 0; i < left.size() && !cut; ++i) {
            const std::size_t n = left.size();
            const Eigen::Vector3i ear(left[(i + n - 1) % n], left[i], left[(i + 1) % n]);
            Points2 triangle(3, 2);
            for (int k = 0; k < 3; ++k) triangle.row(k) = corners.row(ear[k]);
            bool is_ear = signed_area(triangle) > 0;
            for (const int v : left)
                if ((ear.array() != v).all() && contains(triangle, Vec2(corners.row(v)))) is_ear = false;
            if (!is_ear) continue;
            triangles.push_back(ear);
            left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
            cut = true;
        }
        if (!cut) break;
    }
    TriangleMesh mesh;
    mesh.positions = Points3::Zero(corners.rows(), 3);
    mesh.positions.leftCols(2) = corners;
    mesh.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
    for (std::size_t t = 0; t < triangles.size(); ++t)
        mesh.triangles.row(static_cast<Eigen::Index>(t)) = triangles[t].transpose();
    return flat_tile(name, mesh, corners);
}

CutPlan two_tile_plan() {
    CutPlan plan;
    plan.input_file = "balloon.obj";
    plan.input_sha256 = std::string(64, 'a');
    plan.tiles = {flat_cylinder("G01 P01"), sinusoidal_gore("Bílý \"dráček\"")};
    FlatTile& gore = plan.tiles[1];
    gore.accuracy.energy = 1.5;
    gore.accuracy.warp_strain_min = -0.01;
    gore.accuracy.warp_strain_max = 0.005;
    gore.accuracy.shear_max = 2 * degree;
    gore.verdict.findings = {{"chain", "chain 1 is 0.5 % too long; 0.1 % is allowed",
                              gore.tile.mesh.positions.row(gore.tile.boundary[1]), 0.5, 0.1}};
    return plan;
}

PatternPiece piece_of(const FlatTile& tile) {
    CutPlan plan;
    plan.tiles.push_back(tile);
    return make_pieces(plan).at(0);
}

}  // namespace ripstop::testing
