#pragma once

#include <memory>
#include <vector>

#include "ripstop/energy/gas_pressure.h"
#include "ripstop/energy/relaxed_membrane.h"
#include "ripstop/model/flight/sewn_envelope.h"
#include "ripstop/numeric/sparse_pattern.h"

namespace ripstop {

/// The potential energy of a sewn envelope as a function of where its nodes are:
///
///     Pi(x) = sum A psi_r(E) + sum L EA <e>+^2 / 2 + weight - integral of p dV       [J]
///
/// cloth (`TensionField`), tapes (`tape_element`), weight of both and of the valve, gas (`gas_element`). Of one sector,
/// where the envelope has equal ones. The unknowns are the free directions of the nodes.
class Balance {
  public:
    /// `sewn` must outlive it. `threads` (0: one a core) do not change the result.
    Balance(const SewnEnvelope& sewn, const GasPressure& gas, int threads);
    ~Balance();

    void set_residual(double residual);  ///< share of the unrelaxed cloth (`TensionField`); 0 at first
    void set_gas(const GasPressure& gas) { gas_ = gas; }

    int unknowns() const { return pattern_->size(); }
    const SparsePattern& pattern() const { return *pattern_; }
    const SewnEnvelope& sewn() const { return sewn_; }
    const GasPressure& gas() const { return gas_; }

    double energy(const Points3& nodes) const;
    Eigen::VectorXd gradient(const Points3& nodes) const;
    /// Energy, gradient and Hessian, the pattern's lower triangle. The Hessian of cloth and tapes is positive
    /// semi-definite, that of the gas is not.
    double assemble(const Points3& nodes, Eigen::VectorXd& gradient, Eigen::VectorXd& values) const;

    /// The nodes moved by a step in the unknowns.
    Points3 moved(const Points3& nodes, const Eigen::VectorXd& step) const;
    /// The farthest that a node is moved by a step [m].
    double longest(const Eigen::VectorXd& step) const;

    /// The force that everything together puts on the held nodes, all sectors [N]: what hangs below must pull back.
    double lift(const Points3& nodes) const;
    /// What the gas lifts by itself less `weight`: the vertical force of the gas on skin and caps, all sectors [N].
    double net_lift(const Points3& nodes) const;
    /// What the gas would push up on lids that close the openings it leaves by (`SewnEnvelope::lids`), all sectors
    /// [N]: it is no lift.
    double thrust_on_lids(const Points3& nodes) const;
    double weight() const;                      ///< of cloth, tapes and valve, all sectors [N]
    double volume(const Points3& nodes) const;  ///< within skin, caps and lids, all sectors [m3]
    /// Masses with which explicit integration at a time step of 1 is stable: a node's stiffness by its elements
    /// unrelaxed and with every tape taut, times `safety`.
    Eigen::VectorXd fictitious_masses(const Points3& nodes, double safety) const;

    double angle() const { return angle_; }  ///< of a sector [rad]
    /// Corners of a triangle of the skin in space, from the axis.
    std::array<Vec3, 3> corners(const Points3& nodes, int triangle) const;

  private:
    struct Element;
    void add_element(const std::vector<const Place*>& places, Element element);
    template <class Visit>
    void visit_results(const Points3& nodes, bool with_hessian, Visit&& visit) const;
    double energy_of(const Element& element, const Points3& nodes) const;
    SpaceElement evaluate(const Element& element, const Points3& nodes) const;
    SpaceElement on_lid(const std::array<Place, 3>& lid, const GasPressure& gas, const Points3& nodes) const;
    Vec3 point(const Element& element, int corner, const Points3& nodes) const;

    const SewnEnvelope& sewn_;
    GasPressure gas_;
    int threads_;
    double angle_;
    std::vector<TensionField> cloth_;  ///< of each fabric
    std::vector<int> first_unknown_;   ///< of each node; of as many as its freedom has directions
    std::vector<Element> elements_;
    std::unique_ptr<SparsePattern> pattern_;
};

}  // namespace ripstop
