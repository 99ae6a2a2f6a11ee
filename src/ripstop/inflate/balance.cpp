#include "ripstop/inflate/balance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "ripstop/base/index.h"
#include "ripstop/base/parallel.h"
#include "ripstop/energy/load_tape.h"
#include "ripstop/model/flight/air.h"

namespace ripstop {
namespace {

constexpr int chunk = 256;  // elements per task

int directions(Freedom freedom) {
    return may_move(freedom, 0) + may_move(freedom, 1) + may_move(freedom, 2);
}

/// Adds the potential energy of a weight at the centroid of the corners.
void add_weight(double weight, int corners, const Vec3* points, SpaceElement& element) {
    for (int k = 0; k < corners; ++k) {
        element.energy += weight / corners * points[k].z();
        element.gradient[3 * k + 2] += weight / corners;
    }
}

}  // namespace

/// A triangle of cloth, a triangle of a cap, or a piece of tape.
struct Balance::Element {
    enum class Kind { cloth, cap, tape } kind = Kind::cloth;
    int number = 0;     ///< index in its own list
    double weight = 0;  ///< [N]
    bool gas = false;
    std::vector<RelaxedMembrane> membrane = {};  ///< for cloth only: one entry
    std::array<const SewnPoint*, 3> places = {};
    int corners = 3;
    std::vector<int> unknowns = {};
    bool is_plain = false;     ///< each corner is a node that may move freely, so the unknowns are its coordinates
    Eigen::MatrixXd map = {};  ///< otherwise: from the unknowns to the corners' coordinates
    int group = -1;
};

Balance::Balance(const SewnEnvelope& sewn, const GasPressure& gas, int threads)
    : sewn_(sewn), gas_(gas), threads_(threads), angle_(2 * std::numbers::pi / sewn.sectors) {
    set_residual(0);
    int size = 0;
    for (const Freedom freedom : sewn.freedom) {
        first_unknown_.push_back(size);
        size += directions(freedom);
    }
    for (Eigen::Index t = 0; t < sewn.triangles.rows(); ++t) {
        const auto i = static_cast<std::size_t>(t);
        Element element{Element::Kind::cloth, static_cast<int>(t)};
        element.membrane.emplace_back(sewn.flat[i]);
        element.weight =
            gravity * sewn.fabrics[static_cast<std::size_t>(sewn.fabric[i])].mass * element.membrane[0].area();
        element.gas = sewn.holds_gas[i] != 0;
        const auto at = [&](int k) { return &sewn.places[static_cast<std::size_t>(sewn.triangles(t, k))]; };
        add_element({at(0), at(1), at(2)}, std::move(element));
    }
    for (std::size_t i = 0; i < sewn.caps.size(); ++i) {
        Element element{Element::Kind::cap, static_cast<int>(i)};
        element.gas = true;
        std::array<Vec3, 3> x;
        for (std::size_t k = 0; k < 3; ++k) x[k] = position(sewn.caps[i][k], sewn.nodes, angle_);
        element.weight = gravity * sewn.cap_mass * 0.5 * (x[1] - x[0]).cross(x[2] - x[0]).norm();
        add_element({&sewn.caps[i][0], &sewn.caps[i][1], &sewn.caps[i][2]}, std::move(element));
    }
    for (std::size_t i = 0; i < sewn.tapes.size(); ++i) {
        Element element{Element::Kind::tape, static_cast<int>(i)};
        element.weight = gravity * sewn.tapes[i].mass * sewn.tapes[i].rest;
        add_element({&sewn.tapes[i].a, &sewn.tapes[i].b}, std::move(element));
    }
    Couplings couplings;
    for (Element& element : elements_)
        if (!element.unknowns.empty()) element.group = couplings.add_element(element.unknowns);
    pattern_ = std::make_unique<SparsePattern>(size, couplings);
}

Balance::~Balance() = default;

void Balance::add_element(const std::vector<const SewnPoint*>& places, Element element) {
    element.corners = static_cast<int>(places.size());
    std::map<int, int> column;  // first column of each node
    element.is_plain = true;
    for (std::size_t k = 0; k < places.size(); ++k) {
        element.places[k] = places[k];
        const SewnPoint& place = *places[k];
        element.is_plain = element.is_plain && place.is_node() && place.shares[0].turns == 0 &&
                           place.shares[0].weight == 1 &&
                           sewn_.freedom[static_cast<std::size_t>(place.shares[0].node)] == Freedom::everywhere &&
                           !column.contains(place.shares[0].node);
        for (const NodeShare& part : place.shares) {
            if (column.contains(part.node)) continue;
            column[part.node] = static_cast<int>(element.unknowns.size());
            const auto node = static_cast<std::size_t>(part.node);
            for (int d = 0; d < directions(sewn_.freedom[node]); ++d)
                element.unknowns.push_back(first_unknown_[node] + d);
        }
    }
    if (!element.is_plain) {
        element.map = Eigen::MatrixXd::Zero(3 * element.corners, std::ssize(element.unknowns));
        for (int k = 0; k < element.corners; ++k)
            for (const NodeShare& part : places[static_cast<std::size_t>(k)]->shares) {
                const double c = std::cos(part.turns * angle_), s = std::sin(part.turns * angle_);
                Eigen::Matrix3d turn;
                turn << c, -s, 0, s, c, 0, 0, 0, 1;
                int at = column[part.node];
                for (int axis = 0; axis < 3; ++axis)
                    if (may_move(sewn_.freedom[static_cast<std::size_t>(part.node)], axis))
                        element.map.block<3, 1>(3 * k, at++) += part.weight * turn.col(axis);
            }
    }
    elements_.push_back(std::move(element));
}

void Balance::set_residual(double residual) {
    cloth_.clear();
    for (const Fabric& fabric : sewn_.fabrics) cloth_.emplace_back(fabric, residual);
}

Vec3 Balance::point(const Element& element, int corner, const Points3& nodes) const {
    const SewnPoint& place = *element.places[at(corner)];
    if (place.is_node() && place.shares[0].turns == 0) return Vec3(nodes.row(place.shares[0].node)) + place.offset;
    return position(place, nodes, angle_);
}

SpaceElement Balance::evaluate(const Element& element, const Points3& nodes) const {
    SpaceElement result;
    const Vec3 x[3] = {point(element, 0, nodes), point(element, 1, nodes),
                       element.corners == 3 ? point(element, 2, nodes) : Vec3::Zero()};
    if (element.kind == Element::Kind::tape) {
        const SewnTape& tape = sewn_.tapes[at(element.number)];
        const TapeElement pull = tape_element(tape.stiffness, tape.rest, x[0], x[1]);
        result.energy = pull.energy;
        result.gradient.head<6>() = pull.gradient;
        result.hessian.topLeftCorner<6, 6>() = pull.hessian;
    }
    if (element.kind == Element::Kind::cloth) {
        const auto fabric = static_cast<std::size_t>(sewn_.fabric[at(element.number)]);
        result = element.membrane[0].element(cloth_[fabric], x[0], x[1], x[2]);
    }
    if (element.gas) {
        const SpaceElement gas = gas_element(gas_, x[0], x[1], x[2]);
        result.energy += gas.energy;
        result.gradient += gas.gradient;
        result.hessian += gas.hessian;
    }
    add_weight(element.weight, element.corners, x, result);
    return result;
}

double Balance::energy_of(const Element& element, const Points3& nodes) const {
    const Vec3 x[3] = {point(element, 0, nodes), point(element, 1, nodes),
                       element.corners == 3 ? point(element, 2, nodes) : Vec3::Zero()};
    double sum = 0;
    for (int k = 0; k < element.corners; ++k) sum += element.weight / element.corners * x[k].z();
    if (element.kind == Element::Kind::tape) {
        const SewnTape& tape = sewn_.tapes[at(element.number)];
        sum += tape_energy(tape.stiffness, tape.rest, x[0], x[1]);
    }
    if (element.kind == Element::Kind::cloth)
        sum += element.membrane[0].energy(cloth_[at(sewn_.fabric[at(element.number)])], x[0], x[1], x[2]);
    if (element.gas) sum += gas_energy(gas_, x[0], x[1], x[2]);
    return sum;
}

double Balance::energy(const Points3& nodes) const {
    const int tasks = static_cast<int>((elements_.size() + chunk - 1) / chunk);
    std::vector<double> sums(static_cast<std::size_t>(tasks), 0.0);
    parallel_for(tasks, threads_, [&](int task) {
        const std::size_t first = static_cast<std::size_t>(task) * chunk;
        for (std::size_t i = first; i < std::min(first + chunk, elements_.size()); ++i)
            sums[at(task)] += energy_of(elements_[i], nodes);
    });
    double sum = 0;
    for (const double each : sums) sum += each;
    return sum;
}

/// Calls `visit` with each element and its result, in order.
template <class Visit>
void Balance::visit_results(const Points3& nodes, bool with_hessian, Visit&& visit) const {
    struct Result {
        double energy = 0;
        Eigen::VectorXd gradient;
        Eigen::MatrixXd hessian;
    };
    std::vector<SpaceElement> plain(elements_.size());
    std::vector<Result> mapped(elements_.size());
    const int tasks = static_cast<int>((elements_.size() + chunk - 1) / chunk);
    parallel_for(tasks, threads_, [&](int task) {
        const std::size_t first = static_cast<std::size_t>(task) * chunk;
        for (std::size_t i = first; i < std::min(first + chunk, elements_.size()); ++i) {
            plain[i] = evaluate(elements_[i], nodes);
            if (elements_[i].is_plain) continue;
            const int size = 3 * elements_[i].corners;
            mapped[i].gradient = elements_[i].map.transpose() * plain[i].gradient.head(size);
            if (with_hessian)
                mapped[i].hessian =
                    elements_[i].map.transpose() * plain[i].hessian.topLeftCorner(size, size) * elements_[i].map;
        }
    });
    for (std::size_t i = 0; i < elements_.size(); ++i) {
        if (elements_[i].is_plain)
            visit(elements_[i], plain[i].energy, plain[i].gradient, plain[i].hessian);
        else
            visit(elements_[i], plain[i].energy, mapped[i].gradient, mapped[i].hessian);
    }
}

double Balance::assemble(const Points3& nodes, Eigen::VectorXd& gradient, Eigen::VectorXd& values) const {
    gradient.setZero(unknowns());
    values.setZero(pattern_->entry_count());
    double sum = 0;
    visit_results(nodes, true, [&](const Element& element, double energy, const auto& force, const auto& stiffness) {
        sum += energy;
        if (element.group < 0) return;
        const std::span<const int> slots = pattern_->slots(element.group);
        std::size_t entry = 0;
        for (int a = 0; a < static_cast<int>(element.unknowns.size()); ++a) {
            gradient[element.unknowns[at(a)]] += force[a];
            for (int b = 0; b <= a; ++b) values[slots[entry++]] += stiffness(a, b);
        }
    });
    return sum;
}

Eigen::VectorXd Balance::gradient(const Points3& nodes) const {
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(unknowns());
    visit_results(nodes, false, [&](const Element& element, double, const auto& force, const auto&) {
        for (std::size_t a = 0; a < element.unknowns.size(); ++a)
            gradient[element.unknowns[a]] += force[static_cast<Eigen::Index>(a)];
    });
    return gradient;
}

Points3 Balance::moved(const Points3& nodes, const Eigen::VectorXd& step) const {
    Points3 result = nodes;
    for (Eigen::Index n = 0; n < nodes.rows(); ++n) {
        const auto i = static_cast<std::size_t>(n);
        int at = first_unknown_[i];
        for (int axis = 0; axis < 3; ++axis)
            if (may_move(sewn_.freedom[i], axis)) result(n, axis) += step[at++];
    }
    return result;
}

double Balance::longest(const Eigen::VectorXd& step) const {
    double most = 0;
    for (std::size_t i = 0; i < first_unknown_.size(); ++i)
        most = std::max(most, step.segment(first_unknown_[i], directions(sewn_.freedom[i])).norm());
    return most;
}

double Balance::lift(const Points3& nodes) const {
    std::vector<char> is_held(sewn_.freedom.size(), 0);
    for (const int node : sewn_.held) is_held[at(node)] = 1;
    double sum = 0;
    for (const Element& element : elements_) {
        const SpaceElement result = evaluate(element, nodes);
        for (int k = 0; k < element.corners; ++k)
            for (const NodeShare& part : element.places[at(k)]->shares)
                if (is_held[at(part.node)]) sum -= part.weight * result.gradient[3 * k + 2];
    }
    return sewn_.sectors * sum;
}

double Balance::net_lift(const Points3& nodes) const {
    double sum = 0;
    for (const Element& element : elements_) {
        if (!element.gas) continue;
        const SpaceElement gas =
            gas_element(gas_, point(element, 0, nodes), point(element, 1, nodes), point(element, 2, nodes));
        for (int k = 0; k < 3; ++k) sum -= gas.gradient[3 * k + 2];
    }
    return sewn_.sectors * sum - weight();
}

double Balance::weight() const {
    double sum = 0;
    for (const Element& element : elements_) sum += element.weight;
    return sewn_.sectors * sum;
}

SpaceElement Balance::on_lid(const std::array<SewnPoint, 3>& lid, const GasPressure& gas, const Points3& nodes) const {
    return gas_element(gas, position(lid[0], nodes, angle_), position(lid[1], nodes, angle_),
                       position(lid[2], nodes, angle_));
}

double Balance::thrust_on_lids(const Points3& nodes) const {
    double sum = 0;
    for (const std::array<SewnPoint, 3>& lid : sewn_.lids)
        for (int k = 0; k < 3; ++k) sum += on_lid(lid, gas_, nodes).gradient[3 * k + 2];
    return sewn_.sectors * sum;
}

double Balance::volume(const Points3& nodes) const {
    const GasPressure one{1, 0, gas_.floor};
    double sum = 0;
    for (const std::array<SewnPoint, 3>& lid : sewn_.lids) sum -= on_lid(lid, one, nodes).energy;
    for (const Element& element : elements_)
        if (element.gas)
            sum -= gas_energy(one, point(element, 0, nodes), point(element, 1, nodes), point(element, 2, nodes));
    return sewn_.sectors * sum;
}

std::array<Vec3, 3> Balance::corners(const Points3& nodes, int triangle) const {
    const Element& element = elements_[at(triangle)];
    return {point(element, 0, nodes), point(element, 1, nodes), point(element, 2, nodes)};
}

Eigen::VectorXd Balance::fictitious_masses(const Points3& nodes, double safety) const {
    Eigen::VectorXd masses = Eigen::VectorXd::Zero(unknowns());
    for (const Element& element : elements_) {
        if (element.unknowns.empty()) continue;
        const Vec3 x[3] = {point(element, 0, nodes), point(element, 1, nodes),
                           element.corners == 3 ? point(element, 2, nodes) : Vec3::Zero()};
        double stiffness = 0;
        if (element.kind == Element::Kind::tape) {
            const SewnTape& tape = sewn_.tapes[at(element.number)];
            stiffness = 1.8 * tape.stiffness / tape.rest;
        } else if (element.kind == Element::Kind::cloth) {
            const Fabric& fabric = sewn_.fabrics[at(sewn_.fabric[at(element.number)])];
            const double longest = std::max({(x[1] - x[0]).norm(), (x[2] - x[1]).norm(), (x[0] - x[2]).norm()});
            const double area = element.membrane[0].area();
            stiffness = std::max(fabric.c11(), fabric.c22()) * longest * longest / (4 * area) * 2;
        }
        for (const int unknown : element.unknowns) masses[unknown] += safety * stiffness;
    }
    return masses.cwiseMax(1e-9);
}

}  // namespace ripstop
