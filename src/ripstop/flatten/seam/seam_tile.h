#pragma once

#include "ripstop/flatten/seam/seam_hold.h"
#include "ripstop/flatten/seam/seam_stretch.h"

namespace ripstop {

/// A tile of a matched envelope: its least energy E as a function of the stretches h of its intervals, with exact
/// first and second derivatives. The intervals are ordered as in `TileStretch::intervals`.
class SeamTile {
  public:
    /// Flattens with free edges, which gives the shape about which the seams bend. `bending` in A^1.5 E, > 0. Keeps
    /// references to tile and stretch.
    SeamTile(const Tile& tile, const Fabric& fabric, const TileStretch& stretch, double bending);

    /// The stretch of each edge, relative to its target, if all edges are free.
    const Eigen::VectorXd& free_stretch() const { return free_stretch_; }

    /// Flattens with the edge lengths for h. Returns false if the edges cannot be held at these lengths.
    bool hold(const Eigen::VectorXd& h);

    double energy() const { return held_.energy; }  ///< of cloth and cut line [J]
    Eigen::VectorXd gradient() const;               ///< dE/dh = -reachᵀ lambda [J]

    /// Factorises at the present shape and returns d2E/dh2 = reachᵀ (S - diag(lambda / l)) reach [J].
    Eigen::MatrixXd linearize();
    /// Whether that was the unmodified Hessian.
    bool exact() const { return exact_; }

    /// Predicts from that factorisation, to second order, the shape at h + change. `attempt` goes a fraction of the
    /// way and minimises; it returns the energy there, infinity if it does not converge. `accept` keeps the result.
    void aim(const Eigen::VectorXd& change);
    double attempt(double share);
    void accept();

    const SeamSolution& solution() const { return held_; }
    double force_scale() const { return force_scale_; }  ///< E times the mean boundary edge [N]
    int factorizations() const { return factorizations_; }

  private:
    void stiffen_seams(double bending);
    SeamSolution counted(SeamSolution solution);

    const Tile& tile_;
    const TileStretch& stretch_;
    SeamProblem problem_;
    SeamNewton newton_;
    Eigen::VectorXd target_, free_stretch_;
    SeamSolution loose_, held_, tried_;
    Eigen::VectorXd lengths_;  ///< edge lengths of `held_`
    Eigen::VectorXd length_change_;
    SeamStep::Solution course_;  ///< predicted change of u, lambda and mu
    const SeamStep* system_ = nullptr;
    bool exact_ = false;
    double force_scale_;
    int factorizations_ = 0;
};

}  // namespace ripstop
