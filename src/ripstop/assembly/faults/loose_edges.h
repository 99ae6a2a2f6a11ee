#pragma once

#include <vector>

#include "ripstop/assembly/seams/find_seams.h"
#include "ripstop/assembly/seams/seam_runs.h"
#include "ripstop/model/plan/envelope_check.h"

namespace ripstop {

/// The boundary of a tile as one curve: its chains, one after the other.
class BoundaryCurve {
  public:
    BoundaryCurve(const std::vector<PlacedChain>& chains, int tile);
    Vec3 point(double at) const;
    Vec3 direction_after(double at) const;                  ///< of the edge that starts here or contains this place
    Vec3 direction_before(double at) const;                 ///< of the edge that ends here or contains this place
    double length_between(double start, double end) const;  ///< sum of chords [m]
    int edge_count() const { return edges_; }
    /// The chain curve, and the edge on it, of a boundary edge.
    std::pair<const ChainCurve*, int> edge(int boundary_edge) const;

  private:
    const PlacedChain& chain_at(int boundary_edge, int& local) const;
    std::vector<const PlacedChain*> chains_;
    int edges_;
};

/// Joins the loose edges of an envelope into loops, end to start. A run continues with the next of its own tile,
/// across corners, else with the nearest start of another within twenty tolerances or a twentieth of the longer
/// run. O(#runs²) for the runs of tiles that have a seam. `corners_of_loop`: the places at which each loop turns
/// in space by more than 40 degrees.
std::vector<LooseLoop> find_loops(const std::vector<Tile>& tiles, const std::vector<PlacedChain>& chains,
                                  const std::vector<LooseRun>& loose, double tolerance,
                                  std::vector<std::vector<int>>* runs_of_loop = nullptr,
                                  std::vector<std::vector<Vec3>>* corners_of_loop = nullptr);

/// The turn of a loose edge on the cloth at a place: pi minus the angles that the tiles fill there, within `reach`
/// [m]. It is 0 on the rim of a tube, even with flat sides, because the rim turns in space only. O(#boundary
/// vertices).
double turn_on_cloth(const std::vector<Tile>& tiles, const Vec3& place, double reach);

}  // namespace ripstop
