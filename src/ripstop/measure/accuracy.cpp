#include "ripstop/measure/accuracy.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ripstop/energy/woven_membrane.h"
#include "ripstop/measure/distortion.h"
#include "ripstop/measure/overlap.h"
#include "ripstop/mesh/adjacency.h"

namespace ripstop {
namespace {

Vec3 centre_of(const TriangleMesh& mesh, int t) {
    return (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3;
}

void measure_triangles(const Tile& tile, const Points2& flat, Accuracy& accuracy) {
    const std::vector<TriangleDistortion> distortion = measure_distortion(tile.mesh, flat);
    const double infinity = std::numeric_limits<double>::infinity();
    accuracy.warp_strain_min = accuracy.weft_strain_min = infinity;
    accuracy.warp_strain_max = accuracy.weft_strain_max = -infinity;
    double worst = -1;
    double unsigned_error = 0;
    for (int t = 0; t < tile.mesh.triangle_count(); ++t) {
        const TriangleDistortion& here = distortion[static_cast<std::size_t>(t)];
        const double area = triangle_area(tile.mesh, t);
        accuracy.area += area;
        accuracy.flat_area += here.area_ratio * area;
        unsigned_error += std::abs(here.area_ratio - 1) * area;
        accuracy.warp_strain_min = std::min(accuracy.warp_strain_min, here.warp_strain);
        accuracy.warp_strain_max = std::max(accuracy.warp_strain_max, here.warp_strain);
        accuracy.weft_strain_min = std::min(accuracy.weft_strain_min, here.weft_strain);
        accuracy.weft_strain_max = std::max(accuracy.weft_strain_max, here.weft_strain);
        const double strain = std::max(std::abs(here.warp_strain), std::abs(here.weft_strain));
        if (strain > worst) {
            worst = strain;
            accuracy.worst_strain = centre_of(tile.mesh, t);
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

void measure_edges(const Tile& tile, const Points2& flat, Accuracy& accuracy) {
    const Adjacency adjacency(tile.mesh.triangles, tile.mesh.vertex_count());
    double total = 0, difference = 0;
    double boundary_difference = 0;
    for (const int edge : adjacency.edges()) {
        const int a = adjacency.from(edge), b = adjacency.to(edge);
        const double length = (tile.mesh.positions.row(b) - tile.mesh.positions.row(a)).norm();
        const double flat_length = (flat.row(b) - flat.row(a)).norm();
        total += length;
        difference += std::abs(flat_length - length);
        if (!adjacency.is_boundary(edge)) continue;
        accuracy.perimeter += length;
        accuracy.flat_perimeter += flat_length;
        boundary_difference += std::abs(flat_length - length);
        const double error = std::abs(flat_length / length - 1);
        if (error >= accuracy.boundary_error_max) {
            accuracy.boundary_error_max = error;
            accuracy.worst_edge = (tile.mesh.positions.row(a) + tile.mesh.positions.row(b)) / 2;
        }
    }
    accuracy.perimeter_error = accuracy.flat_perimeter / accuracy.perimeter - 1;
    accuracy.edge_error_abs = difference / total;
    accuracy.boundary_error_abs = boundary_difference / accuracy.perimeter;
    for (const Chain& chain : tile.chains)
        accuracy.chains.push_back(
            {edge_lengths(tile.mesh.positions, chain.vertices).sum(), edge_lengths(flat, chain.vertices).sum()});
}

}  // namespace

Accuracy measure_accuracy(const Tile& tile, const Points2& flat, const Fabric& fabric) {
    Accuracy accuracy;
    measure_triangles(tile, flat, accuracy);
    measure_edges(tile, flat, accuracy);
    accuracy.energy = membrane_energy(tile.mesh, flat, fabric);
    const auto overlaps = overlapping_triangles(tile.mesh.triangles, flat);
    accuracy.overlaps = static_cast<int>(overlaps.size());
    if (!overlaps.empty()) accuracy.worst_overlap = centre_of(tile.mesh, overlaps.front()[0]);
    return accuracy;
}

}  // namespace ripstop
