#include "ripstop/inflate/inflate.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <chrono>
#include <cmath>

#include "ripstop/base/index.h"
#include "ripstop/energy/deformation.h"
#include "ripstop/energy/load_tape.h"
#include "ripstop/inflate/deviation.h"

namespace ripstop {
namespace {

/// The node positions for the given start positions of the tiles; points that depend on nodes follow.
Points3 start_nodes(const SewnEnvelope& sewn, const std::vector<Points3>& start) {
    Points3 nodes = sewn.nodes;
    for (std::size_t i = 0; i < start.size(); ++i)
        for (Eigen::Index v = 0; v < start[i].rows(); ++v) {
            const SewnPoint& place = sewn.places[static_cast<std::size_t>(sewn.first_vertex[i] + v)];
            if (!place.is_node() || place.shares[0].turns != 0) continue;
            const Vec3 at = Vec3(start[i].row(v)) - sewn.origin - place.offset;
            for (int axis = 0; axis < 3; ++axis)
                if (may_move(sewn.freedom[static_cast<std::size_t>(place.shares[0].node)], axis))
                    nodes(place.shares[0].node, axis) = at[axis];
        }
    return nodes;
}

Eigen::VectorXd flat_areas(const FlatTile& tile) {
    return Eigen::VectorXd::NullaryExpr(tile.tile.mesh.triangle_count(), [&](Eigen::Index t) {
        return 0.5 * flat_edges(tile.tile.mesh.triangles, tile.flattening.positions, static_cast<int>(t)).determinant();
    });
}

/// Computes strain, stress and state of a tile's cloth for its positions in flight.
void read_cloth(const FlatTile& tile, const Fabric& fabric, RestState rest, InflatedTile& inflated) {
    const TensionField cloth(fabric);
    const TriangleMesh& mesh = tile.tile.mesh;
    const Eigen::Index count = mesh.triangle_count();
    inflated.strain.resize(count, 3);
    inflated.stress.resize(count, 3);
    inflated.tension.resize(count, 2);
    inflated.state.resize(static_cast<std::size_t>(count));
    const std::vector<Mat22> cut = cloth_at_rest(tile, rest);
    double area = 0;
    for (int t = 0; t < count; ++t) {
        const RelaxedMembrane membrane(cut[static_cast<std::size_t>(t)]);
        const auto at = [&](int k) { return Vec3(inflated.positions.row(mesh.triangles(t, k))); };
        const Mat32 F = membrane.deformation(at(0), at(1), at(2));
        const Vec3 strain = green_voigt(F);
        const ClothResponse response = cloth.at(strain);
        inflated.strain.row(t) = strain;
        inflated.stress.row(t) = response.stress;
        inflated.tension.row(t) = principal_tensions(F, response.stress);
        inflated.state[static_cast<std::size_t>(t)] = response.state;
        inflated.tension_max = std::max(inflated.tension_max, inflated.tension(t, 0));
        area += membrane.area();
        if (response.state == ClothState::wrinkled) inflated.wrinkled += membrane.area();
        if (response.state == ClothState::slack) inflated.slack += membrane.area();
    }
    inflated.wrinkled /= area;
    inflated.slack /= area;
}

void read_tapes(const SewnEnvelope& sewn, const Points3& nodes, double angle, Inflated& inflated) {
    for (const SewnTape& tape : sewn.tapes) {
        const Vec3 a = position(tape.a, nodes, angle), b = position(tape.b, nodes, angle);
        const double force = tape_force(tape.stiffness, tape.rest, a, b);
        const bool goes_on = !inflated.tapes.empty() && inflated.tapes.back().kind == tape.kind &&
                             inflated.tapes.back().source == tape.source;
        if (!goes_on) inflated.tapes.push_back({tape.kind, tape.source, force, force, 0, 0.5 * (a + b) + sewn.origin});
        InflatedTape& whole = inflated.tapes.back();
        if (force > whole.force_max) whole.worst = 0.5 * (a + b) + sewn.origin;
        whole.force_max = std::max(whole.force_max, force);
        whole.force_min = std::min(whole.force_min, force);
        whole.cut_length += tape.rest;
        inflated.tape_mass += sewn.sectors * tape.rest * tape.mass;
        if (tape.kind == TapeKind::load) inflated.load_tape_max = std::max(inflated.load_tape_max, force);
    }
}

/// The height from highest to lowest point, and the largest diameter about the vertical axis through the middle.
void measure_sizes(const std::vector<Points3>& tiles, double& height, double& diameter) {
    Vec3 low = Vec3::Constant(1e300), high = Vec3::Constant(-1e300);
    for (const Points3& tile : tiles) {
        low = low.cwiseMin(tile.colwise().minCoeff().transpose());
        high = high.cwiseMax(tile.colwise().maxCoeff().transpose());
    }
    height = high.z() - low.z();
    diameter = std::max(high.x() - low.x(), high.y() - low.y());
}

void read_sizes(const CutPlan& plan, Inflated& inflated) {
    std::vector<Points3> drawn, there;
    for (const FlatTile& tile : plan.tiles) drawn.push_back(tile.tile.mesh.positions);
    for (const InflatedTile& tile : inflated.tiles) there.push_back(tile.positions);
    measure_sizes(drawn, inflated.drawn_height, inflated.drawn_diameter);
    measure_sizes(there, inflated.height, inflated.diameter);
}

void read_tiles(const CutPlan& plan, const SewnEnvelope& sewn, const Points3& nodes, double angle, RestState rest,
                Inflated& inflated) {
    double area = 0;
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        const FlatTile& tile = plan.tiles[i];
        const Fabric& fabric = plan.fabric_of(tile.tile);
        InflatedTile there;
        there.positions.resize(tile.tile.mesh.vertex_count(), 3);
        for (Eigen::Index v = 0; v < there.positions.rows(); ++v)
            there.positions.row(v) = position(sewn.places[at(sewn.first_vertex[i] + v)], nodes, angle) + sewn.origin;
        read_cloth(tile, fabric, rest, there);
        if (there.tension_max > inflated.tension_max) {
            inflated.tension_max = there.tension_max;
            inflated.tension_tile = tile.tile.name;
        }
        const double own_area = flat_areas(tile).sum();
        area += own_area;
        inflated.wrinkled += there.wrinkled * own_area;
        inflated.slack += there.slack * own_area;
        inflated.cloth_mass += fabric.mass * own_area;
        inflated.tiles.push_back(std::move(there));
    }
    inflated.wrinkled /= area;
    inflated.slack /= area;
}

constexpr double limit_load = 1.4;

SafetyFactor factor_of_cloth(const Inflated& inflated, const CutPlan& plan, double knock_down, double required) {
    constexpr double left_out = 1e-3;  // fraction of the area to ignore
    struct Part {
        double load, strength, area;
        std::size_t tile;
    };
    std::vector<Part> parts;
    double whole = 0;
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        const FlatTile& tile = plan.tiles[i];
        const Eigen::VectorXd areas = flat_areas(tile);
        whole += areas.sum();
        for (Eigen::Index t = 0; t < areas.size(); ++t)
            parts.push_back({inflated.tiles[i].tension(t, 0), plan.fabric_of(tile.tile).strength, areas[t], i});
    }
    std::stable_sort(parts.begin(), parts.end(),
                     [](const Part& a, const Part& b) { return a.load * b.strength > b.load * a.strength; });
    double area = 0;
    for (const Part& part : parts) {
        area += part.area;
        if (area < left_out * whole) continue;
        return {"cloth",
                part.load,
                part.strength,
                knock_down,
                required,
                knock_down * part.strength / (limit_load * std::max(part.load, 1e-12)),
                "tile " + plan.tiles[part.tile].tile.name};
    }
    return {};
}

}  // namespace

Inflated inflate(const CutPlan& plan, const InflateOptions& options) {
    const auto begun = std::chrono::steady_clock::now();
    Inflated inflated;
    inflated.load = options.load;
    inflated.rise = buoyancy(options.load.air);
    const SewnEnvelope sewn = sew(plan, options.sewing);
    inflated.floor = options.load.mouth_plane.value_or(sewn.floor);
    inflated.sectors = sewn.sectors;
    inflated.seam_gap = sewn.seam_gap;
    // Heights count from the mouth, wherever the gauge pressure is zero, so that the mouth needs no cap for force or
    // volume.
    const double at_mouth = options.load.extra_pressure + inflated.rise * (sewn.floor - inflated.floor);
    Balance balance(sewn, {at_mouth, inflated.rise, sewn.floor}, options.threads);
    EquilibriumOptions solving;
    solving.iterations = options.iterations;
    solving.settled = 2e-5;
    solving.progress = options.progress;
    inflated.residual_stiffness = solving.residuals.back();
    const Equilibrium found = find_equilibrium(balance, start_nodes(sewn, options.start), solving);
    inflated.summary = found.summary;
    inflated.force_residual = found.residual;
    inflated.is_stable = found.is_stable;

    read_tiles(plan, sewn, found.nodes, balance.angle(), options.sewing.rest, inflated);
    read_tapes(sewn, found.nodes, balance.angle(), inflated);
    read_sizes(plan, inflated);
    inflated.volume = balance.volume(found.nodes);
    inflated.drawn_volume = balance.volume(sewn.nodes);
    inflated.lift = balance.lift(found.nodes) - balance.thrust_on_lids(found.nodes);
    inflated.imbalance = inflated.lift / (balance.net_lift(found.nodes) - balance.thrust_on_lids(found.nodes)) - 1;
    inflated.crown_pressure = balance.gas().at(found.nodes.col(2).maxCoeff());
    measure_deviation(plan, options.threads, inflated);
    inflated.safety = safety_factors(inflated, plan, options.sewing.rigging);
    inflated.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    return inflated;
}

std::vector<SafetyFactor> safety_factors(const Inflated& inflated, const CutPlan& plan, const Rigging& rigging) {
    constexpr double hot = 0.5, aged = 0.5, seam = 0.8, envelope = 5, suspension = 5;
    std::vector<SafetyFactor> factors;
    if (const SafetyFactor cloth = factor_of_cloth(inflated, plan, hot * aged * seam, envelope); cloth.load > 0)
        factors.push_back(cloth);
    const auto add = [&](TapeKind kind, const char* part, double strength, double knock_down, double required) {
        SafetyFactor worst{part, 0, strength, knock_down, required};
        for (const InflatedTape& tape : inflated.tapes) {
            if (tape.kind != kind) continue;
            const double own = kind == TapeKind::tie ? rigging.ties[at(tape.source)].material.strength : strength;
            const double factor = knock_down * own / (limit_load * std::max(tape.force_max, 1e-12));
            if (worst.load > 0 && factor >= worst.factor) continue;
            worst.load = tape.force_max;
            worst.strength = own;
            worst.factor = factor;
            worst.where = kind == TapeKind::load  ? "seam " + plan.seams[at(tape.source)].id
                          : kind == TapeKind::tie ? "tie " + rigging.ties[at(tape.source)].name
                                                  : fmt::format("wire {}", tape.source + 1);
        }
        if (worst.load > 0) factors.push_back(worst);
    };
    add(TapeKind::load, "load tapes", rigging.load_tape.strength, aged, envelope);
    add(TapeKind::wire, "wires", rigging.wire.strength, 1, suspension);
    add(TapeKind::tie, "ties", 0, aged, envelope);
    return factors;
}

}  // namespace ripstop
