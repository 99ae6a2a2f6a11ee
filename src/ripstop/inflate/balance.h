#pragma once

#include <memory>
#include <vector>

#include "ripstop/energy/gas_pressure.h"
#include "ripstop/energy/relaxed_membrane.h"
#include "ripstop/model/flight/sewn_envelope.h"
#include "ripstop/numeric/sparse_pattern.h"

namespace ripstop {

/// The potential energy of a sewn envelope as a function of its node positions:
///
///     Pi(x) = sum A psi_r(E) + sum L EA <e>+^2 / 2 + weight - integral of p dV       [J]
///
/// with cloth (`TensionField`), tapes (`tape_element`), the weight of both and of the valve, and gas (`gas_element`).
/// If the envelope has equal sectors, the energy is that of one sector. The unknowns are the free directions of the
/// nodes.
class Balance {
  public:
    /// `sewn` must outlive it. The result does not depend on `threads` (0: one per core).
    Balance(const SewnEnvelope& sewn, const GasPressure& gas, int threads);
    ~Balance();

    void set_residual(double residual);  ///< fraction of the unrelaxed cloth energy (`TensionField`); initially 0

    int unknowns() const { return pattern_->size(); }
    const SparsePattern& pattern() const { return *pattern_; }
    const SewnEnvelope& sewn() const { return sewn_; }
    const GasPressure& gas() const { return gas_; }

    double energy(const Points3& nodes) const;
    Eigen::VectorXd gradient(const Points3& nodes) const;
    /// Computes energy, gradient and Hessian (the pattern's lower triangle). The Hessian of cloth and tapes is
    /// positive semi-definite, that of the gas is not.
    double assemble(const Points3& nodes, Eigen::VectorXd& gradient, Eigen::VectorXd& values) const;

    /// The node positions after a step in the unknowns.
    Points3 moved(const Points3& nodes, const Eigen::VectorXd& step) const;
    /// The largest displacement of a node in a step [m].
    double longest(const Eigen::VectorXd& step) const;

    /// The total force on the held nodes, all sectors [N]: the load below must balance it.
    double lift(const Points3& nodes) const;
    /// The lift of the gas minus `weight`: the vertical force of the gas on skin and caps, all sectors [N].
    double net_lift(const Points3& nodes) const;
    /// The upward force that the gas would exert on lids over the openings where it escapes (`SewnEnvelope::lids`),
    /// all sectors [N]. It is not part of the lift.
    double thrust_on_lids(const Points3& nodes) const;
    double weight() const;                      ///< weight of cloth, tapes and valve, all sectors [N]
    double volume(const Points3& nodes) const;  ///< volume inside skin, caps and lids, all sectors [m3]
    /// Masses for which explicit integration with time step 1 is stable: the stiffness at each node with unrelaxed
    /// elements and every tape taut, times `safety`.
    Eigen::VectorXd fictitious_masses(const Points3& nodes, double safety) const;

    double angle() const { return angle_; }  ///< angle of a sector [rad]
    /// The corners of a skin triangle in space, relative to the axis.
    std::array<Vec3, 3> corners(const Points3& nodes, int triangle) const;

  private:
    struct Element;
    void add_element(const std::vector<const SewnPoint*>& places, Element element);
    template <class Visit>
    void visit_results(const Points3& nodes, bool with_hessian, Visit&& visit) const;
    double energy_of(const Element& element, const Points3& nodes) const;
    SpaceElement evaluate(const Element& element, const Points3& nodes) const;
    SpaceElement on_lid(const std::array<SewnPoint, 3>& lid, const GasPressure& gas, const Points3& nodes) const;
    Vec3 point(const Element& element, int corner, const Points3& nodes) const;

    const SewnEnvelope& sewn_;
    GasPressure gas_;
    int threads_;
    double angle_;
    std::vector<TensionField> cloth_;  ///< one per fabric
    std::vector<int> first_unknown_;   ///< of each node; it has as many unknowns as free directions
    std::vector<Element> elements_;
    std::unique_ptr<SparsePattern> pattern_;
};

}  // namespace ripstop
