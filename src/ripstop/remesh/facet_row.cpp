#include "ripstop/remesh/facet_row.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

namespace ripstop {
namespace {

constexpr double past_end = 1e-6;  // how far past its ends an edge still counts, relative to its length
constexpr int foot_steps = 12;

}  // namespace

Vec3 FacetRow::chord_at(const Side& side, double u) const {
    const std::size_t i = static_cast<std::size_t>(side.edge);
    const Vec3 p = tile_->mesh.positions.row(tile_->boundary[i]);
    const Vec3 q = tile_->mesh.positions.row(tile_->boundary[(i + 1) % tile_->boundary.size()]);
    return p + (side.from + u * (side.to - side.from)) * (q - p);
}

/// The point on the cubic of its edge.
Vec3 FacetRow::curve_at(const Side& side, double u) const {
    if (side.from == side.to) return chord_at(side, 0);
    const double t = side.from + u * (side.to - side.from), s = 1 - t;
    const Vec3 chord = chord_at({side.edge, 0, 1}, 1) - chord_at({side.edge, 0, 1}, 0);
    const Vec3 start = slopes_.start.row(side.edge), end = slopes_.end.row(side.edge);
    return chord_at(side, u) + (start - chord) * (s * s * t) - (end - chord) * (t * t * s);
}

/// The nearest parameters in a bilinear cell, by Gauss-Newton.
FacetRow::Foot FacetRow::foot_in(const Cell& cell, const Vec3& point) const {
    const Vec3 a0 = chord_at(cell.a, 0), a1 = chord_at(cell.a, 1), b0 = chord_at(cell.b, 0), b1 = chord_at(cell.b, 1);
    Foot foot{0.5, 0.5, 0};
    for (int step = 0; step < foot_steps; ++step) {
        const Vec3 on_a = a0 + foot.u * (a1 - a0), on_b = b0 + foot.u * (b1 - b0);
        Eigen::Matrix<double, 3, 2> slopes;
        slopes.col(0) = (1 - foot.v) * (a1 - a0) + foot.v * (b1 - b0);
        slopes.col(1) = on_b - on_a;
        const Vec3 off = point - (1 - foot.v) * on_a - foot.v * on_b;
        foot.off = off.norm();
        Mat22 normal = slopes.transpose() * slopes;
        normal.diagonal().array() += 1e-12 * normal.trace();  // u is undefined at a tip
        const Vec2 change = normal.ldlt().solve(slopes.transpose() * off);
        foot.u = std::clamp(foot.u + change[0], 0.0, 1.0);
        foot.v = std::clamp(foot.v + change[1], 0.0, 1.0);
        if (change.cwiseAbs().maxCoeff() < 1e-12) break;
    }
    return foot;
}

Vec3 FacetRow::at(double along, double across) const {
    const int q = std::clamp(static_cast<int>(std::floor(along)), 0, cell_count() - 1);
    const Cell& cell = cells_[static_cast<std::size_t>(q)];
    return (1 - across) * curve_at(cell.a, along - q) + across * curve_at(cell.b, along - q);
}

Vec3 FacetRow::faceted_at(double along, double across) const {
    const int q = std::clamp(static_cast<int>(std::floor(along)), 0, cell_count() - 1);
    const Cell& cell = cells_[static_cast<std::size_t>(q)];
    return (1 - across) * chord_at(cell.a, along - q) + across * chord_at(cell.b, along - q);
}

Vec3 FacetRow::at(const MeshPlace& place) const {
    const Vec3 point = place.weights[0] * tile_->mesh.corner(place.triangle, 0) +
                       place.weights[1] * tile_->mesh.corner(place.triangle, 1) +
                       place.weights[2] * tile_->mesh.corner(place.triangle, 2);
    const std::size_t k = static_cast<std::size_t>(facet_[static_cast<std::size_t>(place.triangle)]);
    Foot nearest;
    int cell = -1;
    for (int q = first_cell_[k]; q < first_cell_[k + 1]; ++q) {
        const Foot foot = foot_in(cells_[static_cast<std::size_t>(q)], point);
        if (cell >= 0 && foot.off >= nearest.off) continue;
        nearest = foot;
        cell = q;
    }
    return at(cell + nearest.u, nearest.v);
}

std::optional<double> FacetRow::along(const BoundaryPlace& place, Side Cell::*side) const {
    const int count = static_cast<int>(tile_->boundary.size());
    for (int q = 0; q < cell_count(); ++q) {
        const Side& here = cells_[static_cast<std::size_t>(q)].*side;
        if (here.from == here.to) continue;
        // The start of an edge is the end of the previous one.
        const bool is_next = place.share == 0 && place.edge == (here.edge + 1) % count;
        if (place.edge != here.edge && !is_next) continue;
        const double u = ((is_next ? 1 : place.share) - here.from) / (here.to - here.from);
        if (u >= -past_end && u <= 1 + past_end) return q + std::clamp(u, 0.0, 1.0);
    }
    return {};
}

std::optional<double> FacetRow::along_a(const BoundaryPlace& place) const {
    return along(place, &Cell::a);
}

std::optional<double> FacetRow::along_b(const BoundaryPlace& place) const {
    return along(place, &Cell::b);
}

int FacetRow::triangle_near(double along, const Vec3& point) const {
    const int q = std::clamp(static_cast<int>(std::floor(along)), 0, cell_count() - 1);
    const auto after = std::upper_bound(first_cell_.begin(), first_cell_.end(), q);
    const int facet = static_cast<int>(after - first_cell_.begin()) - 1;
    int nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (int t = 0; t < tile_->mesh.triangle_count(); ++t) {
        if (facet_[static_cast<std::size_t>(t)] != facet) continue;
        const Vec3 middle = (tile_->mesh.corner(t, 0) + tile_->mesh.corner(t, 1) + tile_->mesh.corner(t, 2)) / 3;
        if ((middle - point).norm() >= least) continue;
        least = (middle - point).norm();
        nearest = t;
    }
    return nearest;
}

}  // namespace ripstop
