#pragma once

#include <vector>

#include "ripstop/assembly/seams/find_seams.h"
#include "ripstop/assembly/seams/seam_runs.h"
#include "ripstop/model/plan/envelope_check.h"

namespace ripstop {

/// A tile's boundary as one curve: its chains one after the other.
class BoundaryCurve {
  public:
    BoundaryCurve(const std::vector<PlacedChain>& chains, int tile);
    Vec3 point(double at) const;
    Vec3 direction_after(double at) const;                  ///< of the edge that begins or goes on here
    Vec3 direction_before(double at) const;                 ///< of the edge that ends or goes on here
    double length_between(double start, double end) const;  ///< by chords [m]
    int edge_count() const { return edges_; }
    /// Chain curve and edge of it.
    std::pair<const ChainCurve*, int> edge(int boundary_edge) const;

  private:
    const PlacedChain& chain_at(int boundary_edge, int& local) const;
    std::vector<const PlacedChain*> chains_;
    int edges_;
};

/// The loose edges of an envelope joined end to start into loops: a tile's own first, over its corners, then the
/// nearest start of another within twenty tolerances or a twentieth of the longer run. O(#runs^2) in the runs of
/// tiles that are sewn somewhere. `corners_of_loop`: where each turns in space by more than 40 degrees.
std::vector<LooseLoop> find_loops(const std::vector<Tile>& tiles, const std::vector<PlacedChain>& chains,
                                  const std::vector<LooseRun>& loose, double tolerance,
                                  std::vector<std::vector<int>>* runs_of_loop = nullptr,
                                  std::vector<std::vector<Vec3>>* corners_of_loop = nullptr);

/// How much a loose edge turns on the cloth at a place: pi less the angles that the tiles fill there, as far as `reach`
/// [m] about it. 0 on the rim of a tube, whatever its sides: they turn in space alone. O(#boundary vertices).
double turn_on_cloth(const std::vector<Tile>& tiles, const Vec3& place, double reach);

}  // namespace ripstop
