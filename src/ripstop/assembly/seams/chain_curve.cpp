#include "ripstop/assembly/seams/chain_curve.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "ripstop/base/index.h"
#include "ripstop/geometry/angle.h"
#include "ripstop/geometry/triangle.h"
#include "ripstop/model/tile/corner_turn.h"

namespace ripstop {
namespace {

/// An edge and the parameter on it. For a closed curve, `at` may have any value.
struct OnEdge {
    int edge;
    double t;
    double laps;
};

OnEdge locate(const ChainCurve& curve, double at) {
    const int count = curve.edge_count();
    double laps = 0;
    if (curve.closed) {
        laps = std::floor(at / count);
        at -= laps * count;
    }
    const int edge = std::clamp(static_cast<int>(std::floor(at)), 0, count - 1);
    return {edge, std::clamp(at - edge, 0.0, 1.0), laps};
}

Vec3 cubic(const ChainCurve& curve, int edge, double t) {
    const double s = 1 - t;
    return curve.points.row(edge) * (s * s * (1 + 2 * t)) + curve.points.row(edge + 1) * (t * t * (3 - 2 * t)) +
           curve.start_slopes.row(edge) * (s * s * t) - curve.end_slopes.row(edge) * (t * t * s);
}

Vec3 slope(const ChainCurve& curve, int edge, double t) {
    const double s = 1 - t;
    const Vec3 chord = curve.points.row(edge + 1) - curve.points.row(edge);
    return chord * (6 * s * t) + Vec3(curve.start_slopes.row(edge)) * (s * (1 - 3 * t)) +
           Vec3(curve.end_slopes.row(edge)) * (t * (3 * t - 2));
}

/// The arc length of an edge from its start to t, by Gauss quadrature with five points; the error is of tenth
/// order in the edge's turn.
double arc(const ChainCurve& curve, int edge, double t) {
    constexpr std::array<double, 3> place{0, 0.5384693101056831, 0.9061798459386640};
    constexpr std::array<double, 3> weight{0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
    double sum = weight[0] * slope(curve, edge, t / 2).norm();
    for (std::size_t k = 1; k < 3; ++k)
        sum += weight[k] *
               (slope(curve, edge, t / 2 * (1 - place[k])).norm() + slope(curve, edge, t / 2 * (1 + place[k])).norm());
    return sum * t / 2;
}

Vec3 mirrored_about(const Vec3& tangent, const Vec3& chord) {
    return 2 * tangent.dot(chord) * chord - tangent;
}

/// Sets the unit tangents at both ends of each edge.
void set_tangents(ChainCurve& curve) {
    const int count = static_cast<int>(curve.points.rows()) - 1;
    Points3 chords(count, 3);
    Eigen::VectorXd lengths(count);
    for (int e = 0; e < count; ++e) {
        chords.row(e) = curve.points.row(e + 1) - curve.points.row(e);
        lengths[e] = chords.row(e).norm();
        chords.row(e) /= lengths[e];
    }
    curve.start_slopes = curve.end_slopes = Points3::Zero(count, 3);
    for (int v = curve.closed ? 0 : 1; v < count; ++v) {
        const int before = (v + count - 1) % count, after = v;
        const Vec3 a = chords.row(before), b = chords.row(after);
        if (angle_between(a, b) > corner_turn) continue;
        const Vec3 tangent = (lengths[after] * a + lengths[before] * b).normalized();
        curve.end_slopes.row(before) = tangent;
        curve.start_slopes.row(after) = tangent;
    }
    for (int e = 0; e < count; ++e) {
        const Vec3 chord = chords.row(e);
        const bool no_start = curve.start_slopes.row(e).isZero(), no_end = curve.end_slopes.row(e).isZero();
        if (no_start) curve.start_slopes.row(e) = no_end ? chord : mirrored_about(curve.end_slopes.row(e), chord);
        if (no_end) curve.end_slopes.row(e) = no_start ? chord : mirrored_about(curve.start_slopes.row(e), chord);
    }
    for (int e = 0; e < count; ++e) {
        const double quarter = angle_between(curve.start_slopes.row(e), curve.end_slopes.row(e)) / 4;
        const double speed = lengths[e] / (std::cos(quarter) * std::cos(quarter));
        curve.start_slopes.row(e) *= speed;
        curve.end_slopes.row(e) *= speed;
    }
}

/// True for a loop without a corner. There is a corner if the curve turns sharply at the loop's start, or if the chain
/// and the boundary start at different vertices.
bool is_without_corner(const Tile& tile, const Points3& points) {
    if (tile.chains.size() != 1 || tile.chains.front().vertices.front() != tile.boundary.front()) return false;
    const Eigen::Index last = points.rows() - 1;
    return angle_between(points.row(last) - points.row(last - 1), points.row(1) - points.row(0)) <= corner_turn;
}

/// The angle between the surface normals at two vertices.
double turn_of_normal(const TriangleMesh& mesh, int from, int to) {
    Vec3 at_from = Vec3::Zero(), at_to = Vec3::Zero();
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k) {
            const int v = mesh.triangles(t, k);
            if (v != from && v != to) continue;
            const Vec3 area = (mesh.corner(t, 1) - mesh.corner(t, 0)).cross(mesh.corner(t, 2) - mesh.corner(t, 0));
            (v == from ? at_from : at_to) += area;
        }
    return angle_between(at_from, at_to);
}

}  // namespace

ChainCurve make_chain_curve(const Tile& tile, const Chain& chain) {
    ChainCurve curve;
    curve.points.resize(chain.edge_count() + 1, 3);
    for (int i = 0; i <= chain.edge_count(); ++i) curve.points.row(i) = tile.mesh.positions.row(chain.vertices[at(i)]);
    curve.closed = is_without_corner(tile, curve.points);
    set_tangents(curve);
    curve.stations = Eigen::VectorXd::Zero(chain.edge_count() + 1);
    for (int e = 0; e < chain.edge_count(); ++e) curve.stations[e + 1] = curve.stations[e] + arc(curve, e, 1);
    if (chain.edge_count() == 1)
        curve.unseen_turn = turn_of_normal(tile.mesh, chain.vertices.front(), chain.vertices.back());
    return curve;
}

Vec3 point_at(const ChainCurve& curve, double at) {
    const OnEdge place = locate(curve, at);
    return cubic(curve, place.edge, place.t);
}

Vec3 direction_at(const ChainCurve& curve, double at) {
    const OnEdge place = locate(curve, at);
    return slope(curve, place.edge, place.t).normalized();
}

double station_at(const ChainCurve& curve, double at) {
    const OnEdge place = locate(curve, at);
    const double within =
        place.t == 1 ? curve.stations[place.edge + 1] : curve.stations[place.edge] + arc(curve, place.edge, place.t);
    return place.laps * curve.length() + within;
}

double turn_of_edge(const ChainCurve& curve, int edge) {
    return angle_between(curve.start_slopes.row(edge), curve.end_slopes.row(edge));
}

std::vector<double> breaks_between(double low, double high) {
    std::vector<double> breaks{low};
    for (double v = std::floor(low) + 1; v < high; ++v) breaks.push_back(v);
    breaks.push_back(high);
    return breaks;
}

double chord_of_edge(const ChainCurve& curve, int edge) {
    return (curve.points.row(edge + 1) - curve.points.row(edge)).norm();
}

FootPoint foot_on_edge(const ChainCurve& curve, int edge, const Vec3& point) {
    const Vec3 start = curve.points.row(edge);
    const Vec3 chord = Vec3(curve.points.row(edge + 1)) - start;
    double t = std::clamp((point - start).dot(chord) / chord.squaredNorm(), 0.0, 1.0);
    for (int k = 0; k < 20;
         ++k) {  // Newton without the second derivative: the cubic is nearly straight, so each step gains a digit
        const Vec3 along = slope(curve, edge, t);
        const double next = std::clamp(t + (point - cubic(curve, edge, t)).dot(along) / along.squaredNorm(), 0.0, 1.0);
        const bool done = std::abs(next - t) < 1e-14;
        t = next;
        if (done) break;
    }
    return {edge + t, (point - cubic(curve, edge, t)).norm()};
}

}  // namespace ripstop
