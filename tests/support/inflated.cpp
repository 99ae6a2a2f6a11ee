#include "support/inflated.h"

#include "support/seams.h"

namespace ripstop::testing {
namespace {

InflatedTile blown(const Tile& tile) {
    const Eigen::Index triangles = tile.mesh.triangle_count();
    InflatedTile there;
    there.positions = tile.mesh.positions;
    there.positions.col(2).array() += 0.010;
    there.deviation = Eigen::VectorXd::Constant(tile.mesh.vertex_count(), 0.010);
    there.strain = Vec3(0.5 * (1.01 * 1.01 - 1), 0, 0).transpose().replicate(triangles, 1);
    there.stress = Vec3(20, 5, 0).transpose().replicate(triangles, 1);
    there.tension = Vec2(20.4, 5).transpose().replicate(triangles, 1);
    there.state.assign(static_cast<std::size_t>(triangles), ClothState::taut);
    there.state[0] = ClothState::wrinkled;
    there.state[1] = ClothState::slack;
    there.off = {0.010, 0.010, 0.010, 0.010};
    there.tension_max = 20.4;
    there.wrinkled = there.slack = 1.0 / static_cast<double>(triangles);
    return there;
}

}  // namespace

CutPlan inflated_plan() {
    CutPlan plan = sewn_plan();
    plan.fabric.name = "nylon";
    plan.seams[0].type.tape = true;
    Inflated inflated;
    for (const FlatTile& tile : plan.tiles) inflated.tiles.push_back(blown(tile.tile));
    inflated.tapes = {{TapeKind::load, 0, 150, 90, 0.99 * plan.seams[0].length, Vec3(1, 0.5, 0.01)},
                      {TapeKind::wire, 0, 300, 300, 3, Vec3::Zero()},
                      {TapeKind::tie, 1, 20, 10, 2, Vec3::Zero()}};
    inflated.off = {0.010, -0.020, 0.012, 0.025};
    inflated.drawn_height = 10;
    inflated.height = 10.05;
    inflated.drawn_diameter = inflated.diameter = 8;
    inflated.drawn_volume = 400;
    inflated.volume = 404;
    inflated.lift = 1000 * 9.80665;
    inflated.cloth_mass = 30;
    inflated.tape_mass = 5;
    inflated.crown_pressure = 27;
    inflated.tension_max = 20.4;
    inflated.tension_tile = "left";
    inflated.load_tape_max = 150;
    inflated.wrinkled = 0.05;
    inflated.slack = 0.01;
    inflated.is_stable = true;
    inflated.summary = {Termination::converged, 17, 20, "forces in balance"};
    inflated.seconds = 1.5;
    inflated.safety = {{"cloth", 20.4, 10000, 0.2, 5, 70, "tile left"},
                       {"load tapes", 150, 10000, 0.5, 5, 23.8, "seam S1"},
                       {"wires", 300, 3000, 1, 2.25, 7.1, "wire 1"}};
    inflated.causes = Causes{0.001, 0.008, 0.002};
    plan.inflated = inflated;
    return plan;
}

}  // namespace ripstop::testing
