#include "ripstop/measure/measure_accuracy.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ripstop/base/index.h"
#include "ripstop/energy/woven_membrane.h"
#include "ripstop/geometry/polygon.h"
#include "ripstop/geometry/triangle.h"
#include "ripstop/measure/distortion.h"
#include "ripstop/measure/overlap.h"
#include "ripstop/measure/walk_seams.h"
#include "ripstop/mesh/adjacency.h"
#include "ripstop/tile/targets.h"

namespace ripstop {
namespace {

Vec3 centre_of(const TriangleMesh& mesh, int t) {
    return (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3;
}

void measure_triangles(const Tile& tile, const std::vector<Mat22>& targets, const Points2& flat, Accuracy& accuracy) {
    const std::vector<TriangleDistortion> distortion = measure_distortion(targets, tile.mesh.triangles, flat);
    const double infinity = std::numeric_limits<double>::infinity();
    accuracy.warp_strain_min = accuracy.weft_strain_min = infinity;
    accuracy.warp_strain_max = accuracy.weft_strain_max = -infinity;
    double worst_warp = -1, worst_weft = -1;
    double unsigned_error = 0;
    for (int t = 0; t < tile.mesh.triangle_count(); ++t) {
        const TriangleDistortion& here = distortion[at(t)];
        const double area = 0.5 * targets[at(t)].determinant();
        accuracy.area += area;
        accuracy.flat_area += here.area_ratio * area;
        unsigned_error += std::abs(here.area_ratio - 1) * area;
        accuracy.warp_strain_min = std::min(accuracy.warp_strain_min, here.warp_strain);
        accuracy.warp_strain_max = std::max(accuracy.warp_strain_max, here.warp_strain);
        accuracy.weft_strain_min = std::min(accuracy.weft_strain_min, here.weft_strain);
        accuracy.weft_strain_max = std::max(accuracy.weft_strain_max, here.weft_strain);
        if (std::abs(here.warp_strain) > worst_warp) {
            worst_warp = std::abs(here.warp_strain);
            accuracy.worst_warp = centre_of(tile.mesh, t);
        }
        if (std::abs(here.weft_strain) > worst_weft) {
            worst_weft = std::abs(here.weft_strain);
            accuracy.worst_weft = centre_of(tile.mesh, t);
        }
        if (std::abs(here.shear) > accuracy.shear_max) {
            accuracy.shear_max = std::abs(here.shear);
            accuracy.worst_shear = centre_of(tile.mesh, t);
        }
        if (here.flipped && accuracy.flipped++ == 0) accuracy.worst_flip = centre_of(tile.mesh, t);
    }
    accuracy.area_error = accuracy.flat_area / accuracy.area - 1;
    accuracy.area_error_abs = unsigned_error / accuracy.area;
}

/// The length of half-edge h in its triangle's target shape.
double target_length(const std::vector<Mat22>& targets, int h) {
    return triangle_edge(targets[at(Adjacency::triangle(h))], h % 3).norm();
}

void measure_all_edges(const Tile& tile, const std::vector<Mat22>& targets, const Points2& flat, Accuracy& accuracy) {
    const Adjacency adjacency(tile.mesh.triangles, tile.mesh.vertex_count());
    double total = 0, difference = 0;
    for (const int edge : adjacency.edges()) {
        const int twin = adjacency.twin(edge);
        const double one = target_length(targets, edge);
        const double length = twin < 0 ? one : 0.5 * (one + target_length(targets, twin));
        total += length;
        difference += std::abs((flat.row(adjacency.to(edge)) - flat.row(adjacency.from(edge))).norm() - length);
    }
    accuracy.edge_error_abs = difference / total;
}

void measure_boundary(const Tile& tile, const Points2& flat, bool edges_on_curve, Accuracy& accuracy) {
    const Eigen::VectorXd lengths = target_lengths(tile);
    const Eigen::VectorXd flat_lengths = boundary_on_cloth(tile, flat, edges_on_curve);
    const Eigen::VectorXd error = (flat_lengths.cwiseQuotient(lengths).array() - 1).abs();
    accuracy.perimeter = lengths.sum();
    accuracy.flat_perimeter = flat_lengths.sum();
    accuracy.perimeter_error = accuracy.flat_perimeter / accuracy.perimeter - 1;
    accuracy.boundary_error_abs = (flat_lengths - lengths).cwiseAbs().sum() / accuracy.perimeter;
    Eigen::Index worst = 0;
    accuracy.boundary_error_max = error.maxCoeff(&worst);
    const auto position = [&](Eigen::Index i) {
        return Vec3(tile.mesh.positions.row(tile.boundary[static_cast<std::size_t>(i) % tile.boundary.size()]));
    };
    accuracy.worst_edge = (position(worst) + position(worst + 1)) / 2;

    std::vector<Eigen::Index> place(static_cast<std::size_t>(tile.mesh.vertex_count()));
    for (std::size_t i = 0; i < tile.boundary.size(); ++i) place[at(tile.boundary[i])] = static_cast<Eigen::Index>(i);
    for (const Chain& chain : tile.chains) {
        ChainAccuracy along;
        for (int i = 0; i < chain.edge_count(); ++i) {
            const Eigen::Index edge = place[at(chain.vertices[at(i)])];
            along.length += lengths[edge];
            along.flat_length += flat_lengths[edge];
        }
        accuracy.chains.push_back(along);
    }
}

}  // namespace

Accuracy measure_accuracy(const Tile& tile, const Points2& flat, const Fabric& fabric, bool edges_on_curve) {
    const std::vector<Mat22> targets = target_triangles(tile);
    Accuracy accuracy;
    measure_triangles(tile, targets, flat, accuracy);
    measure_all_edges(tile, targets, flat, accuracy);
    measure_boundary(tile, flat, edges_on_curve, accuracy);
    accuracy.energy = membrane_energy(targets, tile.mesh.triangles, flat, fabric);
    const auto overlaps = overlapping_triangles(tile.mesh.triangles, flat);
    accuracy.overlaps = static_cast<int>(overlaps.size());
    if (!overlaps.empty()) accuracy.worst_overlap = centre_of(tile.mesh, overlaps.front()[0]);
    accuracy.outline_crossings = self_intersections(flat(tile.boundary, Eigen::all)).count;
    return accuracy;
}

}  // namespace ripstop
