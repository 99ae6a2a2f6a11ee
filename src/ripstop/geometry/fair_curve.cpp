#include "ripstop/geometry/fair_curve.h"

#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "ripstop/base/index.h"
#include "ripstop/geometry/triangle.h"

namespace ripstop {
namespace {

constexpr double first_reach = 2, reach = 3;  // in mean edge lengths
constexpr double least_step = 0.05;  // in mean edge lengths: keeps the order of vertices where a tooth turns back
constexpr double held = 1e6;         // weight of the fixed ends
// Vertices by which the layout of a closed chain overlaps itself at each end. The influence of an end on the fit
// decays as exp(-x / (2 r)): to 0.02 over eight r.
constexpr Eigen::Index lap = 24;

using Sparse = Eigen::SparseMatrix<double>;

/// 1, sin(k x) / k, (1 - cos(k x)) / k^2 and (k x - sin(k x)) / k^3, accurate for small k x too. The operator
/// f''' + k^2 f' maps the first three to zero and the fourth to 1.
Eigen::Vector4d basis(double k, double x) {
    const double z = k * x;
    if (std::abs(z) < 0.02) {
        const double zz = z * z;
        return {1, x * (1 - zz / 6), x * x / 2 * (1 - zz / 12), x * x * x / 6 * (1 - zz / 20)};
    }
    return {1, std::sin(z) / k, (1 - std::cos(z)) / (k * k), (z - std::sin(z)) / (k * k * k)};
}

/// The end conditions of a fit. `held`: the first and last vertex are fixed. `free`: they are where the layout of a
/// longer chain was cut off. `joined`: they are adjacent.
enum class Ends { held, free, joined };

/// The operator f''' + k^2 f' as finite differences over four consecutive vertices, each row weighted by the root of
/// its share of the length. `cyclic`: the last step leads back to the first vertex.
Sparse operator_of(const Eigen::VectorXd& steps, double k, bool cyclic) {
    const Eigen::Index edges = steps.size(), count = cyclic ? edges : edges + 1, rows = cyclic ? edges : edges - 2;
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index i = 0; i < rows; ++i) {
        std::array<double, 4> x{};
        for (Eigen::Index j = 0; j < 3; ++j) x[at(j + 1)] = x[at(j)] + steps[(i + j) % edges];
        const double size = x[3];
        Eigen::Matrix4d values;
        for (int j = 0; j < 4; ++j)
            // scaled to unit length for conditioning
            values.col(j) = basis(k * size, x[at(j)] / size - 0.5);
        const Eigen::Vector4d weights = values.fullPivLu().solve(Eigen::Vector4d(0, 0, 0, 1)) / (size * size * size);
        for (int j = 0; j < 4; ++j) entries.emplace_back(i, (i + j) % count, weights[j] * std::sqrt(size / 3));
    }
    Sparse matrix(rows, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

Points2 fit(const Points2& points, const Eigen::VectorXd& steps, double r, double k, Ends ends) {
    const bool cyclic = ends == Ends::joined;
    const Eigen::Index count = points.rows(), last = count - 1;
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(count);
    for (Eigen::Index i = 0; i < steps.size(); ++i) {
        weights[i] += steps[i] / 2;
        weights[(i + 1) % count] += steps[i] / 2;
    }
    if (ends == Ends::held) {
        weights[0] *= held;
        weights[last] *= held;
    }
    const Sparse rows = operator_of(steps, k, cyclic);
    Sparse system = std::pow(r, 6) * Sparse(rows.transpose() * rows);
    for (Eigen::Index i = 0; i < count; ++i) system.coeffRef(i, i) += weights[i];
    const Eigen::SimplicialLDLT<Sparse> solver(system);
    Points2 fair = solver.solve(Eigen::MatrixXd(weights.asDiagonal() * points));
    fair += Points2(solver.solve(Eigen::MatrixXd(weights.asDiagonal() * (points - fair))));
    if (ends != Ends::held) return fair;
    fair.row(0) = points.row(0);
    fair.row(last) = points.row(last);
    return fair;
}

Eigen::VectorXd steps_of(const Points2& points) {
    const Eigen::Index last = points.rows() - 1;
    return (points.bottomRows(last) - points.topRows(last)).rowwise().norm();
}

/// The turning angle at each vertex [rad]; 0 at both ends.
Eigen::VectorXd turns_of(const Points2& points) {
    Eigen::VectorXd turns = Eigen::VectorXd::Zero(points.rows());
    for (Eigen::Index i = 1; i + 1 < points.rows(); ++i) {
        const Vec2 a = points.row(i) - points.row(i - 1), b = points.row(i + 1) - points.row(i);
        turns[i] = std::atan2(cross(a, b), a.dot(b));
    }
    return turns;
}

/// The mean curvature of a chain [1/m]: its total turning over its length. In an open chain the length counts from
/// the middle of the first edge to the middle of the last.
double bending_of(const ChainLayout& chain) {
    const Eigen::Index edges = chain.lengths.size();
    if (chain.closed) return std::abs(chain.turns.sum()) / chain.lengths.sum();
    const double outer = (chain.lengths[0] + chain.lengths[edges - 1]) / 2;
    return std::abs(chain.turns.segment(1, edges - 1).sum()) / (chain.lengths.sum() - outer);
}

/// The mean curvature of a first fit [1/m]. In a closed chain only one round counts, without the overlap.
double bending_of(const Points2& first_fit, bool closed) {
    const Eigen::VectorXd turns = turns_of(first_fit), steps = steps_of(first_fit);
    if (!closed) return bending_of(ChainLayout{steps, turns, false});
    const Eigen::Index count = first_fit.rows() - 1 - 2 * lap;
    const double length = (steps.segment(lap, count).sum() + steps.segment(lap - 1, count).sum()) / 2;
    return std::abs(turns.segment(lap, count).sum()) / length;
}

/// The chain laid out in the plane. A closed one starts `lap` vertices before its first vertex and ends `lap` after
/// it.
Points2 laid_out(const ChainLayout& chain) {
    const Eigen::Index count = chain.turns.size(), first = chain.closed ? -lap : 0;
    const Eigen::Index last = chain.closed ? count + lap : count - 1;
    Points2 points(last - first + 1, 2);
    points.row(0).setZero();
    double heading = 0;
    for (Eigen::Index i = first; i < last; ++i) {
        const Eigen::Index here = ((i % count) + count) % count;
        if (i > first) heading += chain.turns[here];
        points.row(i - first + 1) =
            points.row(i - first) + chain.lengths[here] * Vec2(std::cos(heading), std::sin(heading)).transpose();
    }
    return points;
}

Ends ends_of(const ChainLayout& chain) {
    return chain.closed ? Ends::free : Ends::held;
}

Vec2 direction(const Points2& points, Eigen::Index i) {
    Vec2 sum = Vec2::Zero();
    if (i > 0) sum += Vec2(points.row(i) - points.row(i - 1)).normalized();
    if (i + 1 < points.rows()) sum += Vec2(points.row(i + 1) - points.row(i)).normalized();
    return sum.normalized();
}

FairLine line_of(const ChainLayout& chain, const Points2& points, const Points2& fair) {
    const Eigen::Index first = chain.closed ? lap : 0, edges = chain.lengths.size();
    const Eigen::VectorXd chords = steps_of(fair), turns = turns_of(fair);
    FairLine line;
    for (Eigen::Index i = first; i < first + edges; ++i) {
        double turn = (turns[i] + turns[i + 1]) / 2;
        if (i == 0 || i + 1 == chords.size()) turn *= 2;  // only one end of this edge has a turn
        line.length += chords[i] * (1 + turn * turn / 24);
        line.area_on_left += cross(fair.row(i + 1) - points.row(i), fair.row(i) - points.row(i + 1)) / 2;
    }
    line.moves.resize(chain.turns.size(), 2);
    for (Eigen::Index v = 0; v < line.moves.rows(); ++v) {
        const Vec2 move = fair.row(first + v) - points.row(first + v), along = direction(points, first + v);
        line.moves.row(v) << move.dot(along), cross(along, move);
    }
    return line;
}

}  // namespace

ChainLayout layout_of(const Points2& chain, bool closed) {
    const Eigen::Index count = chain.rows();
    ChainLayout layout{Eigen::VectorXd(closed ? count : count - 1), Eigen::VectorXd::Zero(count), closed};
    const auto edge = [&](Eigen::Index i) { return Vec2(chain.row((i + 1) % count) - chain.row(i % count)); };
    for (Eigen::Index i = 0; i < layout.lengths.size(); ++i) layout.lengths[i] = edge(i).norm();
    for (Eigen::Index i = closed ? 0 : 1; i < (closed ? count : count - 1); ++i) {
        const Vec2 a = edge(i + count - 1), b = edge(i);
        layout.turns[i] = std::atan2(cross(a, b), a.dot(b));
    }
    return layout;
}

Points2 fair_points(const Points2& chain, bool closed) {
    const ChainLayout layout = layout_of(chain, closed);
    const double edge = layout.lengths.mean();
    const Ends ends = closed ? Ends::joined : Ends::held;
    const Points2 first_fit = fit(chain, layout.lengths, first_reach * edge, bending_of(layout), ends);
    const ChainLayout fitted = layout_of(first_fit, closed);
    return fit(chain, fitted.lengths.cwiseMax(least_step * edge), reach * edge, bending_of(fitted), ends);
}

FairCurve::FairCurve(const ChainLayout& chain) {
    const Points2 points = laid_out(chain);
    first_ = steps_of(points);
    const double edge = chain.lengths.mean();
    first_reach_ = first_reach * edge;
    reach_ = reach * edge;
    steps_ = steps_of(fit(points, first_, first_reach_, bending_of(chain), ends_of(chain))).cwiseMax(least_step * edge);
    line_ = of_image(chain);
}

FairLine FairCurve::of_image(const ChainLayout& image) const {
    const Points2 points = laid_out(image);
    const Points2 first_fit = fit(points, first_, first_reach_, bending_of(image), ends_of(image));
    const double bending = bending_of(first_fit, image.closed);
    return line_of(image, points, fit(points, steps_, reach_, bending, ends_of(image)));
}

}  // namespace ripstop
