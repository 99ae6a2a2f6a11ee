#include "ripstop/report/view/map_values.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ripstop/mesh/boundary.h"
#include "ripstop/report/figures/cloth_map.h"
#include "ripstop/report/figures/figures.h"
#include "ripstop/report/figures/seam_drift.h"
#include "ripstop/tile/targets.h"

namespace ripstop {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

Eigen::VectorXd mean_of_corners(const Eigen::VectorXd& at_vertices, const Triangles& triangles) {
    Eigen::VectorXd means(triangles.rows());
    for (Eigen::Index t = 0; t < triangles.rows(); ++t)
        means[t] = (at_vertices[triangles(t, 0)] + at_vertices[triangles(t, 1)] + at_vertices[triangles(t, 2)]) / 3;
    return means;
}

/// The elongation of a thread from Green's strain.
Eigen::ArrayXd stretch(const Points3& green, int thread) {
    return (1 + 2 * green.col(thread).array()).max(0).sqrt();
}

Eigen::VectorXd shear_in_flight(const Points3& green) {
    const Eigen::ArrayXd sine = green.col(2).array() / (stretch(green, 0) * stretch(green, 1)).max(1e-12);
    return sine.max(-1).min(1).asin();
}

Eigen::VectorXd flight_values(const InflatedTile& there, const Triangles& triangles, std::string_view id) {
    if (id == "deviation") return mean_of_corners(there.deviation, triangles);
    if (id == "flight-tension") return there.tension.col(0);
    if (id == "flight-warp") return there.stress.col(0);
    if (id == "flight-weft") return there.stress.col(1);
    if (id == "flight-shear") return there.stress.col(2);
    if (id == "flight-strain-warp") return stretch(there.strain, 0) - 1;
    if (id == "flight-strain-weft") return stretch(there.strain, 1) - 1;
    if (id == "flight-strain-shear") return shear_in_flight(there.strain);
    Eigen::VectorXd states(static_cast<Eigen::Index>(there.state.size()));
    for (Eigen::Index t = 0; t < states.size(); ++t)
        states[t] = static_cast<double>(there.state[static_cast<std::size_t>(t)]);
    return states;
}

const Eigen::VectorXd* strains_of(const StrainMap& strain, std::string_view id) {
    if (id == "warp") return &strain.warp;
    if (id == "weft") return &strain.weft;
    if (id == "shear") return &strain.shear;
    return id == "area" ? &strain.area : nullptr;
}

using Edges = std::vector<Eigen::VectorXd>;

Edges unknown_edges(const CutPlan& plan) {
    Edges edges;
    for (const FlatTile& tile : plan.tiles)
        edges.push_back(Eigen::VectorXd::Constant(static_cast<Eigen::Index>(tile.tile.boundary.size()), unknown));
    return edges;
}

Edges mismatches(const CutPlan& plan) {
    Edges edges = unknown_edges(plan);
    for (std::size_t i = 0; i < plan.walks.size(); ++i)
        for (const bool is_b : {false, true}) {
            const SeamWalk& walk = plan.walks[i];
            const SeamSide& side = is_b ? plan.seams[i].b : plan.seams[i].a;
            double walked = 0;
            for (const SeamPart& part : side.parts) {
                const double middle = walked + part.length / 2;
                const double drift = drift_at(walk, is_b ? walk.length - middle : middle);
                edges[static_cast<std::size_t>(side.tile)][part.edge] = (is_b ? drift : -drift) / walk.length;
                walked += part.length;
            }
        }
    return edges;
}

Edges tape_forces(const CutPlan& plan) {
    Edges edges = unknown_edges(plan);
    if (!plan.inflated) return edges;
    for (const InflatedTape& tape : plan.inflated->tapes) {
        if (tape.kind != TapeKind::load) continue;
        const Seam& seam = plan.seams[static_cast<std::size_t>(tape.source)];
        for (const SeamSide* side : {&seam.a, &seam.b})
            for (const SeamPart& part : side->parts)
                edges[static_cast<std::size_t>(side->tile)][part.edge] = tape.force_max;
    }
    return edges;
}

Edges edge_errors(const CutPlan& plan) {
    Edges edges = unknown_edges(plan);
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        const FlatTile& tile = plan.tiles[i];
        if (!tile.is_flat()) continue;
        edges[i] = edge_lengths(tile.flattening.positions, closed(tile.tile.boundary)).array() /
                       target_lengths(tile.tile).array() -
                   1;
    }
    return edges;
}

Edges tensions(const CutPlan& plan) {
    Edges edges = unknown_edges(plan);
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        const Eigen::VectorXd& tension = plan.tiles[i].flattening.seam_tension;
        if (tension.size() == edges[i].size()) edges[i] = tension;
    }
    return edges;
}

}  // namespace

Eigen::VectorXd cloth_values(const CutPlan& plan, std::size_t tile, const StrainMap& strain, const PageMap& map) {
    const FlatTile& flat = plan.tiles[tile];
    const TriangleMesh& mesh = flat.tile.mesh;
    if (!map.is_of_cloth()) return {};
    if (map.is_in_flight)
        return plan.inflated ? flight_values(plan.inflated->tiles[tile], mesh.triangles, map.id) : Eigen::VectorXd();
    if (!flat.is_flat()) return {};
    if (const Eigen::VectorXd* values = strains_of(strain, map.id))
        return values->size() == mesh.triangle_count() ? *values : Eigen::VectorXd();
    Eigen::VectorXd errors(mesh.triangle_count());
    for (int t = 0; t < mesh.triangle_count(); ++t) errors[t] = mean_edge_error(flat, t);
    return errors;
}

std::vector<Eigen::VectorXd> edge_values(const CutPlan& plan, const PageMap& map) {
    if (map.id == "mismatch") return mismatches(plan);
    if (map.id == "tapes") return tape_forces(plan);
    if (map.id == "tension") return tensions(plan);
    return map.id == "edges" ? edge_errors(plan) : Edges();
}

}  // namespace ripstop
