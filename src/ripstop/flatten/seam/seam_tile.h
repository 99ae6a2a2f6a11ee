#pragma once

#include "ripstop/flatten/seam/seam_hold.h"
#include "ripstop/flatten/seam/seam_stretch.h"

namespace ripstop {

/// A tile of a matched envelope: its least energy E as a function of the stretch h of the intervals at its edges, with
/// exact first and second derivatives. In its own intervals' order (`TileStretch::intervals`).
class SeamTile {
  public:
    /// Flattens with free edges, which gives the seams the shape about which they bend. `bending` in A^1.5 E, > 0.
    /// Keeps references to tile and stretch.
    SeamTile(const Tile& tile, const Fabric& fabric, const TileStretch& stretch, double bending);

    /// By how much each edge is longer than its target where all are free, as a ratio.
    const Eigen::VectorXd& free_stretch() const { return free_stretch_; }

    /// Flattens with the edges as long as h makes them. False where they cannot be held there.
    bool hold(const Eigen::VectorXd& h);

    double energy() const { return held_.energy; }  ///< cloth and cut line [J]
    Eigen::VectorXd gradient() const;               ///< dE/dh = -reachᵀ lambda [J]

    /// Factorises where the tile is and gives d2E/dh2 = reachᵀ (S - diag(lambda / l)) reach [J].
    Eigen::MatrixXd linearize();
    /// Whether that was the Hessian itself, nothing clamped or added.
    bool exact() const { return exact_; }

    /// Predicts from that factorisation, to second order, where h + change takes the tile; `attempt` goes a share of
    /// the way there and comes to rest. The energy there, infinite where it does not come to rest. `accept` keeps it.
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
    Eigen::VectorXd lengths_;  ///< of `held_`
    Eigen::VectorXd length_change_;
    SeamStep::Solution course_;  ///< change of u, lambda and mu on the way
    const SeamStep* system_ = nullptr;
    bool exact_ = false;
    double force_scale_;
    int factorizations_ = 0;
};

}  // namespace ripstop
