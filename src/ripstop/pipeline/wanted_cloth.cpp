#include "ripstop/pipeline/wanted_cloth.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>

#include "ripstop/geometry/triangle.h"

namespace ripstop {
namespace {

Mat22 from_voigt(const Vec3& strain) {
    Mat22 C;
    C << 1 + 2 * strain[0], strain[2], strain[2], 1 + 2 * strain[1];
    return C;
}

/// Metric of the target triangle in the warp axes of the drawn one.
Mat22 target_metric(const Mat22& drawn, const Mat22& axes, const Vec3& b_a, const Vec3& c_a) {
    Mat22 gram;
    gram << b_a.dot(b_a), b_a.dot(c_a), b_a.dot(c_a), c_a.dot(c_a);
    const Mat22 inverse = (axes.transpose() * drawn).inverse();
    return inverse.transpose() * gram * inverse;
}

Points3 seen_from_drawing(const Tile& tile, const Points3& target, const Points3& strain) {
    const Eigen::Matrix2Xd warp = warp_in_triangles(tile);
    Points3 total(tile.mesh.triangle_count(), 3);
    for (int t = 0; t < tile.mesh.triangle_count(); ++t) {
        Mat22 axes;
        axes << warp(0, t), -warp(1, t), warp(1, t), warp(0, t);
        const auto at = [&](int k) { return Vec3(target.row(tile.mesh.triangles(t, k))); };
        const Mat22 drawn = lay_flat(tile.mesh.corner(t, 0), tile.mesh.corner(t, 1), tile.mesh.corner(t, 2));
        const Mat22 metric = target_metric(drawn, axes, at(1) - at(0), at(2) - at(0));
        const Mat22 root = Eigen::SelfAdjointEigenSolver<Mat22>(from_voigt(strain.row(t))).operatorSqrt();
        const Mat22 C = root * metric.inverse() * root;
        total.row(t) << 0.5 * (C(0, 0) - 1), 0.5 * (C(1, 1) - 1), C(0, 1);
    }
    return total;
}

/// Cloth a drawn length of each boundary edge, as the tile by itself would have it.
Eigen::VectorXd own_ratios(Tile tile, const Points3& strain) {
    tile.compensation = {};
    const Eigen::VectorXd drawn = target_lengths(tile);
    tile.compensation.strain = strain;
    return target_lengths(tile).cwiseQuotient(drawn);
}

/// A function of the way along a seam that is constant between places.
class Steps {
  public:
    Steps(const SeamSide& side, const Eigen::VectorXd& ratios, bool reversed) {
        const auto add = [&](const SeamPart& part) {
            ends_.push_back((ends_.empty() ? 0 : ends_.back()) + part.length);
            values_.push_back(ratios[part.edge]);
        };
        if (reversed)
            std::for_each(side.parts.rbegin(), side.parts.rend(), add);
        else
            std::for_each(side.parts.begin(), side.parts.end(), add);
    }
    /// Its integral from the start.
    double until(double along) const {
        double sum = 0, start = 0;
        for (std::size_t i = 0; i < ends_.size() && start < along; ++i) {
            sum += values_[i] * (std::min(along, i + 1 == ends_.size() ? along : ends_[i]) - start);
            start = ends_[i];
        }
        return sum;
    }
    const std::vector<double>& ends() const { return ends_; }

  private:
    std::vector<double> ends_, values_;
};

/// Adds to each edge of a side what of the seam's cloth belongs to it [m].
void share_out(const SeamSide& side, const Steps& own, const Steps& other, bool reversed, Eigen::VectorXd& cloth,
               Eigen::VectorXd& covered) {
    double start = 0;
    for (std::size_t i = 0; i < side.parts.size(); ++i) {
        const SeamPart& part = side.parts[reversed ? side.parts.size() - 1 - i : i];
        const double end = own.ends()[i];
        cloth[part.edge] += 0.5 * (own.until(end) - own.until(start) + other.until(end) - other.until(start));
        covered[part.edge] += part.length;
        start = end;
    }
}

double path_length(const SeamSide& side, const std::vector<int>& boundary, const Points3& x) {
    double sum = 0;
    for (const SeamPart& part : side.parts) {
        const auto i = static_cast<std::size_t>(part.edge);
        sum += (x.row(boundary[(i + 1) % boundary.size()]) - x.row(boundary[i])).norm();
    }
    return sum;
}

}  // namespace

WantedCloth drawn_cloth(const Envelope& envelope) {
    WantedCloth wanted;
    for (const Tile& tile : envelope.tiles) {
        wanted.target.push_back(tile.mesh.positions);
        wanted.strain.push_back(Points3::Zero(tile.mesh.triangle_count(), 3));
    }
    wanted.tape_strain.assign(envelope.seams.size(), 0);
    return wanted;
}

void compensate_tiles(const WantedCloth& wanted, Envelope& envelope) {
    std::vector<Eigen::VectorXd> ratios, cloth, covered;
    for (std::size_t i = 0; i < envelope.tiles.size(); ++i) {
        Tile& tile = envelope.tiles[i];
        tile.compensation.strain = seen_from_drawing(tile, wanted.target[i], wanted.strain[i]);
        ratios.push_back(own_ratios(tile, tile.compensation.strain));
        cloth.push_back(Eigen::VectorXd::Zero(ratios[i].size()));
        covered.push_back(Eigen::VectorXd::Zero(ratios[i].size()));
    }
    for (const Seam& seam : envelope.seams) {
        const auto a = static_cast<std::size_t>(seam.a.tile), b = static_cast<std::size_t>(seam.b.tile);
        const Steps first(seam.a, ratios[a], false), second(seam.b, ratios[b], true);
        share_out(seam.a, first, second, false, cloth[a], covered[a]);
        share_out(seam.b, second, first, true, cloth[b], covered[b]);
    }
    for (std::size_t i = 0; i < envelope.tiles.size(); ++i) {
        const Eigen::VectorXd drawn = drawn_lengths(envelope.tiles[i]);
        const Eigen::VectorXd left = (drawn - covered[i]).cwiseMax(0);
        envelope.tiles[i].compensation.edges = (cloth[i] + left.cwiseProduct(ratios[i])).cwiseQuotient(covered[i] + left);
    }
}

std::vector<double> tape_factors(const WantedCloth& wanted, const Envelope& envelope) {
    std::vector<double> factors;
    for (std::size_t s = 0; s < envelope.seams.size(); ++s) {
        const SeamSide& side = envelope.seams[s].a;
        const auto i = static_cast<std::size_t>(side.tile);
        const Tile& tile = envelope.tiles[i];
        const double moved = path_length(side, tile.boundary, wanted.target[i]) /
                             path_length(side, tile.boundary, tile.mesh.positions);
        factors.push_back(moved / std::sqrt(1 + 2 * wanted.tape_strain[s]));
    }
    return factors;
}

std::vector<Points3> elastic_strain(const CutPlan& plan, const Inflated& inflated) {
    std::vector<Points3> strains;
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        const Fabric& fabric = plan.fabric_of(plan.tiles[i].tile);
        Eigen::Matrix3d stiffness;
        stiffness << fabric.c11(), fabric.c12(), 0, fabric.c12(), fabric.c22(), 0, 0, 0, fabric.shear_stiffness;
        strains.push_back(inflated.tiles[i].stress * stiffness.inverse());
    }
    return strains;
}

std::vector<double> tape_strains(const CutPlan& plan) {
    std::vector<double> strains;
    for (std::size_t s = 0; s < plan.seams.size(); ++s) {
        const SeamSide& side = plan.seams[s].a;
        const auto i = static_cast<std::size_t>(side.tile);
        const Tile& tile = plan.tiles[i].tile;
        const double cut = path_length(side, tile.boundary, tile.mesh.positions) *
                           (plan.tape_factors.empty() ? 1 : plan.tape_factors[s]);
        const double stretch = path_length(side, tile.boundary, plan.inflated->tiles[i].positions) / cut;
        strains.push_back(plan.seams[s].type.tape ? std::max(0.0, 0.5 * (stretch * stretch - 1)) : 0);
    }
    return strains;
}

}  // namespace ripstop
