#include "ripstop/pipeline/flight/wanted_cloth.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>

#include "ripstop/geometry/triangle.h"
#include "ripstop/tile/targets.h"

namespace ripstop {
namespace {

Mat22 from_voigt(const Vec3& strain) {
    Mat22 C;
    C << 1 + 2 * strain[0], strain[2], strain[2], 1 + 2 * strain[1];
    return C;
}

/// The metric of the target triangle in the warp axes of the drawn triangle.
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

/// Cloth per drawn length of each boundary edge, for the tile alone.
Eigen::VectorXd own_ratios(Tile tile, const Points3& strain) {
    tile.compensation = {};
    const Eigen::VectorXd drawn = target_lengths(tile);
    tile.compensation.strain = strain;
    return target_lengths(tile).cwiseQuotient(drawn);
}

/// A piecewise constant function along a seam.
class Steps {
  public:
    /// The ratios of a side's edges. An edge that continues beyond the seam is `is_firm`: the other side must follow
    /// it.
    Steps(const SeamSide& side, const Eigen::VectorXd& ratios, const Eigen::VectorXd& drawn, bool reversed) {
        const auto add = [&](const SeamPart& part) {
            add_step((steps_.empty() ? 0 : steps_.back().end) + part.length, ratios[part.edge],
                     part.length < (1 - 1e-6) * drawn[part.edge]);
        };
        if (reversed)
            std::for_each(side.parts.rbegin(), side.parts.rend(), add);
        else
            std::for_each(side.parts.begin(), side.parts.end(), add);
    }

    /// At each place the firm value, else the mean of the two.
    Steps(const Steps& one, const Steps& other) {
        std::size_t i = 0, j = 0;
        while (i < one.steps_.size() && j < other.steps_.size()) {
            const Step &a = one.steps_[i], &b = other.steps_[j];
            const bool is_last = i + 1 == one.steps_.size() && j + 1 == other.steps_.size();
            add_step(is_last ? std::max(a.end, b.end) : std::min(a.end, b.end),
                     a.is_firm == b.is_firm ? 0.5 * (a.value + b.value)
                     : a.is_firm            ? a.value
                                            : b.value,
                     a.is_firm || b.is_firm);
            const bool a_ends = a.end <= b.end && i + 1 < one.steps_.size();
            const bool b_ends = b.end <= a.end && j + 1 < other.steps_.size();
            if (!a_ends && !b_ends) {
                if (is_last) break;
                i + 1 < one.steps_.size() ? ++i : ++j;
                continue;
            }
            i += a_ends;
            j += b_ends;
        }
    }

    /// The integral from the start to `along`.
    double until(double along) const {
        double sum = 0, start = 0;
        for (std::size_t i = 0; i < steps_.size() && start < along; ++i) {
            sum += steps_[i].value * (std::min(along, i + 1 == steps_.size() ? along : steps_[i].end) - start);
            start = steps_[i].end;
        }
        return sum;
    }
    double end(std::size_t i) const { return steps_[i].end; }

  private:
    struct Step {
        double end, value;
        bool is_firm;
    };
    void add_step(double end, double value, bool is_firm) { steps_.push_back({end, value, is_firm}); }

    std::vector<Step> steps_;
};

/// Distributes the seam's cloth over the edges of one side [m].
void share_out(const SeamSide& side, const Steps& own, const Steps& common, bool reversed, Eigen::VectorXd& cloth,
               Eigen::VectorXd& covered) {
    double start = 0;
    for (std::size_t i = 0; i < side.parts.size(); ++i) {
        const SeamPart& part = side.parts[reversed ? side.parts.size() - 1 - i : i];
        cloth[part.edge] += common.until(own.end(i)) - common.until(start);
        covered[part.edge] += part.length;
        start = own.end(i);
    }
}

/// Cloth per drawn length of each boundary edge of each tile, equal on both sides of every seam.
std::vector<Eigen::VectorXd> sewn_ratios(const Envelope& envelope, const std::vector<Eigen::VectorXd>& own) {
    std::vector<Eigen::VectorXd> drawn, cloth, covered;
    for (const Tile& tile : envelope.tiles) {
        drawn.push_back(drawn_lengths(tile));
        cloth.push_back(Eigen::VectorXd::Zero(drawn.back().size()));
        covered.push_back(Eigen::VectorXd::Zero(drawn.back().size()));
    }
    for (const Seam& seam : envelope.seams) {
        if (seam.into) continue;
        const auto a = static_cast<std::size_t>(seam.a.tile), b = static_cast<std::size_t>(seam.b.tile);
        const Steps first(seam.a, own[a], drawn[a], false), second(seam.b, own[b], drawn[b], true);
        const Steps common(first, second);
        share_out(seam.a, first, common, false, cloth[a], covered[a]);
        share_out(seam.b, second, common, true, cloth[b], covered[b]);
    }
    // An additional sheet follows the seam that contains it.
    for (const Seam& seam : envelope.seams) {
        if (!seam.into) continue;
        const auto a = static_cast<std::size_t>(seam.a.tile), b = static_cast<std::size_t>(seam.b.tile);
        const Eigen::VectorXd sewn = cloth[b].cwiseQuotient(covered[b].cwiseMax(1e-300));
        const Steps own_steps(seam.a, own[a], drawn[a], false), common(seam.b, sewn, drawn[b], true);
        share_out(seam.a, own_steps, common, false, cloth[a], covered[a]);
    }
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        const Eigen::VectorXd left = (drawn[i] - covered[i]).cwiseMax(0);
        cloth[i] = (cloth[i] + left.cwiseProduct(own[i])).cwiseQuotient(covered[i] + left);
    }
    return cloth;
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
    std::vector<Eigen::VectorXd> ratios;
    for (std::size_t i = 0; i < envelope.tiles.size(); ++i) {
        Tile& tile = envelope.tiles[i];
        tile.compensation.strain = seen_from_drawing(tile, wanted.target[i], wanted.strain[i]);
        ratios.push_back(own_ratios(tile, tile.compensation.strain));
    }
    // An edge in two seams has one ratio. The second round passes the result of the first on to its other mate.
    ratios = sewn_ratios(envelope, sewn_ratios(envelope, ratios));
    for (std::size_t i = 0; i < envelope.tiles.size(); ++i) envelope.tiles[i].compensation.edges = ratios[i];
}

std::vector<double> tape_factors(const WantedCloth& wanted, const Envelope& envelope) {
    std::vector<double> factors;
    for (std::size_t s = 0; s < envelope.seams.size(); ++s) {
        const SeamSide& side = envelope.seams[s].a;
        const auto i = static_cast<std::size_t>(side.tile);
        const Tile& tile = envelope.tiles[i];
        const double moved =
            path_length(side, tile.boundary, wanted.target[i]) / path_length(side, tile.boundary, tile.mesh.positions);
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
        strains.push_back(plan.seams[s].has_tape() ? std::max(0.0, 0.5 * (stretch * stretch - 1)) : 0);
    }
    return strains;
}

}  // namespace ripstop
