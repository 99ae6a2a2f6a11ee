#include "ripstop/design/special/special_settle.h"

#include <Eigen/Dense>
#include <algorithm>

namespace ripstop {
namespace {

constexpr double close_enough = 1e-11;  // [m]: a hundred times the rounding error at ten metres

/// The level functions that must vanish.
class Levels {
  public:
    Levels(const SpecialBody& body, const Ties& ties) : body_(body), curves_(ties.curves) {
        const bool is_round = body.shape().joint_radius > 0;
        for (const int face : ties.faces) {
            const bool is_same_surface =
                is_round && !faces_.empty() && std::none_of(faces_.begin(), faces_.end(), [&](int other) {
                    return body.faces()[static_cast<std::size_t>(other)].primitive ==
                           body.faces()[static_cast<std::size_t>(face)].primitive;
                });
            if (!is_same_surface) faces_.push_back(face);
        }
        std::erase_if(curves_, [&](const BodyCurve& curve) {
            return curve.kind == BodyCurve::crease &&
                   (!is_round || body.faces()[static_cast<std::size_t>(curve.a)].primitive ==
                                     body.faces()[static_cast<std::size_t>(curve.b)].primitive);
        });
    }

    void at(const Vec3& x, std::vector<Level>& levels) const {
        levels.clear();
        if (faces_.empty()) levels.push_back(body_.surface_level(body_.owner(x), x));
        for (const int face : faces_) levels.push_back(body_.surface_level(face, x));
        for (const BodyCurve& curve : curves_) levels.push_back(body_.curve_level(curve, x));
    }

  private:
    const SpecialBody& body_;
    std::vector<int> faces_;
    std::vector<BodyCurve> curves_;
};

Vec3 shortest_step(const std::vector<Level>& levels) {
    if (levels.size() == 1) {
        const double steep = levels[0].gradient.squaredNorm();
        return steep > 0 ? Vec3(-levels[0].value / steep * levels[0].gradient) : Vec3::Zero();
    }
    const auto rows = static_cast<Eigen::Index>(levels.size());
    Eigen::MatrixX3d jacobian(rows, 3);
    Eigen::VectorXd values(rows);
    for (Eigen::Index i = 0; i < rows; ++i) {
        jacobian.row(i) = levels[static_cast<std::size_t>(i)].gradient;
        values[i] = levels[static_cast<std::size_t>(i)].value;
    }
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
    solver.setThreshold(1e-7);
    solver.compute(jacobian);
    return -solver.solve(values);
}

}  // namespace

void Ties::add(int face) {
    if (face >= 0 && std::find(faces.begin(), faces.end(), face) == faces.end()) faces.push_back(face);
}

void Ties::add(const BodyCurve& curve) {
    if (std::find(curves.begin(), curves.end(), curve) == curves.end()) curves.push_back(curve);
}

bool settle(const SpecialBody& body, const Ties& ties, double reach, Vec3& place) {
    const Levels levels(body, ties);
    std::vector<Level> here;
    Vec3 x = place;
    for (int iteration = 0; iteration < 60; ++iteration) {
        levels.at(x, here);
        double worst = 0;
        for (const Level& level : here) worst = std::max(worst, std::abs(level.value));
        if (worst < close_enough) {
            place = x;
            return true;
        }
        Vec3 step = shortest_step(here);
        if (const double length = step.norm(); length > reach) step *= reach / length;
        x += step;
        if (!((x - place).norm() < 4 * reach)) return false;
    }
    return false;
}

}  // namespace ripstop
