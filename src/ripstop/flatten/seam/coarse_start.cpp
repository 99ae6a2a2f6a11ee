#include "ripstop/flatten/seam/coarse_start.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "ripstop/base/index.h"
#include "ripstop/energy/woven_membrane.h"
#include "ripstop/mesh/change/flips.h"
#include "ripstop/tile/targets.h"

namespace ripstop {
namespace {

constexpr int most_cells = 100;
constexpr int triangles_a_cell = 300;  ///< keeps the coarse problem cheap compared with the fine one
constexpr int least_cells = 5;         ///< along each side
constexpr std::size_t cell_samples =
    16;  ///< sampled triangles per cell; with fewer, the splines exploit the gaps between samples
constexpr int edge_samples = 400;
constexpr double edge_spring = 1e3;   ///< in E times the tile's size; a softer spring lets the edges yield to the cloth
constexpr double grain_spring = 1;    ///< in E
constexpr double rest_spring = 1e-6;  ///< in E: for control points that hardly affect the tile
constexpr int max_iterations = 8;
constexpr double settled = 1e-4;  ///< relative to the energy: stop if a step promises less

constexpr int support = 16;  ///< control points that influence a point

/// Cubic B-splines on a grid of nearly square cells over the bounding box of the points.
class SplineGrid {
  public:
    SplineGrid(const Points2& points, int target_cells) : low_(points.colwise().minCoeff().transpose()) {
        const Vec2 size = points.colwise().maxCoeff().transpose() - low_;
        const double wanted = std::sqrt(size.x() * size.y() / target_cells);
        for (int d = 0; d < 2; ++d) {
            cells_[d] = std::max(least_cells, static_cast<int>(std::lround(size[d] / wanted)));
            width_[d] = size[d] / cells_[d];
        }
    }

    int control_count() const { return (cells_[0] + 3) * (cells_[1] + 3); }
    int cell_count() const { return cells_[0] * cells_[1]; }
    int cell_of(const Vec2& p) const { return place(p, 0).cell * cells_[1] + place(p, 1).cell; }

    struct Weights {
        std::array<int, support> control;
        Eigen::Matrix<double, 1, support> value;
        Eigen::Matrix<double, 2, support> gradient;
    };
    Weights weights_at(const Vec2& p) const {
        const CellPlace x = place(p, 0), y = place(p, 1);
        Weights weights;
        for (int i = 0, k = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j, ++k) {
                weights.control[at(k)] = (x.cell + i) * (cells_[1] + 3) + y.cell + j;
                weights.value[k] = x.value[i] * y.value[j];
                weights.gradient(0, k) = x.slope[i] * y.value[j];
                weights.gradient(1, k) = x.value[i] * y.slope[j];
            }
        return weights;
    }

  private:
    struct CellPlace {
        int cell;
        Eigen::Vector4d value, slope;
    };
    CellPlace place(const Vec2& p, int d) const {
        const double along = (p[d] - low_[d]) / width_[d];
        const int cell = std::clamp(static_cast<int>(along), 0, cells_[d] - 1);
        const double t = along - cell, s = 1 - t;
        return {cell,
                Eigen::Vector4d(s * s * s, 3 * t * t * t - 6 * t * t + 4, 3 * s * s * s - 6 * s * s + 4, t * t * t) / 6,
                Eigen::Vector4d(-s * s, 3 * t * t - 4 * t, -3 * s * s + 4 * s, t * t) / (2 * width_[d])};
    }

    Vec2 low_, width_;
    std::array<int, 2> cells_{};
};

/// Energy of the sampled cloth as a function of the control points' displacements (x and y of one after the other).
class CoarseCloth {
  public:
    CoarseCloth(const Tile& tile, const Fabric& fabric, const Points2& start)
        : grid_(start, std::min(most_cells, tile.mesh.triangle_count() / triangles_a_cell)),
          membrane_(fabric),
          stiffness_(0.5 * (fabric.c11() + fabric.c22())) {
        sample_triangles(tile, start);
        sample_edges(tile, start);
    }

    Eigen::Index unknowns() const { return 2 * grid_.control_count(); }

    double energy(const Eigen::VectorXd& c) const {
        double sum = 0.5 * rest_spring * stiffness_ * c.squaredNorm();
        for (const TriangleSample& sample : triangles_)
            sum += sample.weight * membrane_.energy(sample.metric, flat(sample, c));
        for (const EdgeSample& sample : edges_) {
            const double strain = edge_strain(sample, c);
            sum += 0.5 * sample.weight * strain * strain;
        }
        const double turn = grain_turn(c);
        return sum + 0.5 * grain_weight_ * turn * turn;
    }

    /// The gradient of the energy, and its Hessian without negative curvature.
    void assemble(const Eigen::VectorXd& c, Eigen::VectorXd& gradient, Eigen::MatrixXd& hessian) const {
        gradient = rest_spring * stiffness_ * c;
        hessian = rest_spring * stiffness_ * Eigen::MatrixXd::Identity(unknowns(), unknowns());
        for (const TriangleSample& sample : triangles_) add_triangle(sample, c, gradient, hessian);
        for (const EdgeSample& sample : edges_) {
            const Vec2 d = sample.start + displacement(sample.along, c);
            add_spring(sample.along, d / sample.length / sample.length, edge_strain(sample, c), sample.weight, gradient,
                       hessian);
        }
        gradient += grain_weight_ * grain_turn(c) * grain_row_;
        hessian += grain_weight_ * grain_row_ * grain_row_.transpose();
    }

    Points2 moved(const Points2& start, const Eigen::VectorXd& c) const {
        Points2 positions = start;
        for (Eigen::Index v = 0; v < start.rows(); ++v) {
            const SplineGrid::Weights weights = grid_.weights_at(start.row(v).transpose());
            for (int k = 0; k < support; ++k)
                positions.row(v) +=
                    weights.value[k] * c.segment<2>(2 * weights.control[static_cast<std::size_t>(k)]).transpose();
        }
        return positions;
    }

  private:
    /// The derivative of an edge vector with respect to the control points: it changes by sum_k slope_k c_k.
    struct Slopes {
        std::array<int, support> control;
        Eigen::Matrix<double, 1, support> slope;
    };
    struct TriangleSample {
        TriangleMetric metric;
        double weight;  ///< number of triangles of its size that it represents
        Mat22 start;
        std::array<Slopes, 2> edges;
    };
    struct EdgeSample {
        double length, weight;
        Vec2 start;
        Slopes along;
    };

    Slopes slopes(const Vec2& at, const Vec2& direction) const {
        const SplineGrid::Weights weights = grid_.weights_at(at);
        return {weights.control, direction.transpose() * weights.gradient};
    }

    static Vec2 displacement(const Slopes& slopes, const Eigen::VectorXd& c) {
        Vec2 sum = Vec2::Zero();
        for (int k = 0; k < support; ++k)
            sum += slopes.slope[k] * c.segment<2>(2 * slopes.control[static_cast<std::size_t>(k)]);
        return sum;
    }

    static Mat22 flat(const TriangleSample& sample, const Eigen::VectorXd& c) {
        Mat22 edges = sample.start;
        for (int k = 0; k < 2; ++k) edges.col(k) += displacement(sample.edges[static_cast<std::size_t>(k)], c);
        return edges;
    }

    static double edge_strain(const EdgeSample& sample, const Eigen::VectorXd& c) {
        const Vec2 d = sample.start + displacement(sample.along, c);
        return (d.squaredNorm() / (sample.length * sample.length) - 1) / 2;
    }

    double grain_turn(const Eigen::VectorXd& c) const { return grain_start_ + grain_row_.dot(c); }

    void sample_triangles(const Tile& tile, const Points2& start) {
        const std::vector<Mat22> targets = target_triangles(tile);
        const Eigen::Matrix2Xd warp = warp_in_triangles(tile);
        std::vector<std::vector<int>> members(static_cast<std::size_t>(grid_.cell_count()));
        std::vector<double> area(members.size(), 0);
        const auto centre = [&](int t) {
            return Vec2(start(tile.mesh.triangles.row(t), Eigen::all).colwise().mean().transpose());
        };
        for (int t = 0; t < tile.mesh.triangle_count(); ++t) {
            const auto cell = static_cast<std::size_t>(grid_.cell_of(centre(t)));
            members[cell].push_back(t);
            const double own = 0.5 * targets[static_cast<std::size_t>(t)].determinant();
            area[cell] += own;
            size_ += own;
        }
        grain_row_ = Eigen::VectorXd::Zero(unknowns());
        grain_weight_ = grain_spring * stiffness_ * size_;
        for (std::size_t cell = 0; cell < members.size(); ++cell) {
            const std::size_t count = std::min(cell_samples, members[cell].size());
            for (std::size_t i = 0; i < count; ++i) {
                const int t = members[cell][(2 * i + 1) * members[cell].size() / (2 * count)];
                const Mat22& target = targets[static_cast<std::size_t>(t)];
                const double share = area[cell] / static_cast<double>(count);
                TriangleSample sample{triangle_metric(target), share / (0.5 * target.determinant()), {}, {}};
                const auto corner = [&](int k) { return Vec2(start.row(tile.mesh.triangles(t, k)).transpose()); };
                for (int k = 0; k < 2; ++k) {
                    sample.start.col(k) = corner(k + 1) - corner(0);
                    sample.edges[static_cast<std::size_t>(k)] = slopes(centre(t), sample.start.col(k));
                }
                add_grain(sample, share / size_, target, warp.col(t));
                triangles_.push_back(sample);
            }
        }
        size_ = std::sqrt(size_);
    }

    /// Adds the sample's transverse warp component, weighted by its share of the mean.
    void add_grain(const TriangleSample& sample, double share, const Mat22& target, const Vec2& warp) {
        const Vec2 along = target.inverse() * warp;
        grain_start_ += share * sample.start.row(1).dot(along);
        for (int e = 0; e < 2; ++e)
            for (int k = 0; k < support; ++k) {
                const Slopes& edge = sample.edges[static_cast<std::size_t>(e)];
                grain_row_[2 * edge.control[static_cast<std::size_t>(k)] + 1] += share * along[e] * edge.slope[k];
            }
    }

    void sample_edges(const Tile& tile, const Points2& start) {
        const Eigen::VectorXd lengths = target_lengths(tile);
        const auto count = static_cast<int>(lengths.size());
        const int taken = std::min(count, edge_samples);
        for (int i = 0; i < taken; ++i) {
            const int edge = static_cast<int>(static_cast<long>(i) * count / taken);
            const Vec2 a = start.row(tile.boundary[static_cast<std::size_t>(edge)]).transpose();
            const Vec2 b = start.row(tile.boundary[static_cast<std::size_t>((edge + 1) % count)]).transpose();
            const double stands_for = lengths.sum() / taken;
            edges_.push_back(
                {lengths[edge], edge_spring * stiffness_ * size_ * stands_for, b - a, slopes(0.5 * (a + b), b - a)});
        }
    }

    void add_triangle(const TriangleSample& sample, const Eigen::VectorXd& c, Eigen::VectorXd& gradient,
                      Eigen::MatrixXd& hessian) const {
        const MembraneElement element = membrane_.element(sample.metric, flat(sample, c), Curvature::semidefinite);
        const auto& [p, q] = sample.edges;  // both in one cell, so they share their control points
        for (int i = 0; i < support; ++i) {
            const int row = 2 * p.control[static_cast<std::size_t>(i)];
            gradient.segment<2>(row) += sample.weight * (p.slope[i] * element.gradient.segment<2>(2) +
                                                         q.slope[i] * element.gradient.segment<2>(4));
            const Eigen::Matrix<double, 2, 4> left = sample.weight * (p.slope[i] * element.hessian.block<2, 4>(2, 2) +
                                                                      q.slope[i] * element.hessian.block<2, 4>(4, 2));
            for (int j = 0; j < support; ++j)
                hessian.block<2, 2>(row, 2 * p.control[static_cast<std::size_t>(j)]) +=
                    p.slope[j] * left.leftCols<2>() + q.slope[j] * left.rightCols<2>();
        }
    }

    /// Adds weight strain^2 / 2; `slope` is the derivative of the strain with respect to the edge.
    static void add_spring(const Slopes& along, const Vec2& slope, double strain, double weight,
                           Eigen::VectorXd& gradient, Eigen::MatrixXd& hessian) {
        const Mat22 block = weight * slope * slope.transpose();
        for (int i = 0; i < support; ++i) {
            const int row = 2 * along.control[static_cast<std::size_t>(i)];
            gradient.segment<2>(row) += weight * strain * along.slope[i] * slope;
            for (int j = 0; j < support; ++j)
                hessian.block<2, 2>(row, 2 * along.control[static_cast<std::size_t>(j)]) +=
                    along.slope[i] * along.slope[j] * block;
        }
    }

    SplineGrid grid_;
    WovenMembrane membrane_;
    double stiffness_;
    double size_ = 0;  ///< holds the area first, then its square root
    std::vector<TriangleSample> triangles_;
    std::vector<EdgeSample> edges_;
    Eigen::VectorXd grain_row_;
    double grain_start_ = 0, grain_weight_ = 0;
};

}  // namespace

Points2 coarse_solution(const Tile& tile, const Fabric& fabric, const Points2& start) {
    const CoarseCloth cloth(tile, fabric, start);
    Eigen::VectorXd c = Eigen::VectorXd::Zero(cloth.unknowns()), gradient;
    Eigen::MatrixXd hessian;
    double energy = cloth.energy(c);
    for (int iteration = 0; iteration < max_iterations; ++iteration) {
        cloth.assemble(c, gradient, hessian);
        const Eigen::VectorXd step = -hessian.llt().solve(gradient);
        const double promised = -0.5 * gradient.dot(step);
        double length = 1, reached = cloth.energy(c + step);
        while (!(reached < energy) && length > 0.01) reached = cloth.energy(c + (length *= 0.5) * step);
        if (!(reached < energy)) break;
        c += length * step;
        energy = reached;
        if (promised < settled * energy) break;
    }
    Points2 positions = cloth.moved(start, c);
    return count_flipped(tile.mesh.triangles, positions) == 0 ? positions : start;
}

}  // namespace ripstop
