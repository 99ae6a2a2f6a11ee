#include "support/balloons.h"

#include <numbers>

#include "ripstop/io/json/fabric_json.h"
#include "ripstop/model/flight/air.h"
#include "ripstop/pipeline/flatten/flatten_envelope.h"
#include "ripstop/pipeline/flight/tape_seams.h"
#include "ripstop/pipeline/flight/wanted_cloth.h"
#include "ripstop/pipeline/read/read_envelope.h"

namespace ripstop::testing {

Envelope balloon(const EnvelopeDesign& design) {
    ReadOptions options;
    options.fabric = fabric_named("nylon");
    Envelope envelope = make_envelope(design_natural(design), options);
    for (Tile& tile : envelope.tiles) tile.grain.direction = Vec3::UnitZ();
    return envelope;
}

CutPlan cut_balloon(const EnvelopeDesign& design, bool with_tapes) {
    FlattenOptions options;
    options.fabric = fabric_named("nylon");
    CutPlan plan = flatten_envelope(balloon(design), options);
    if (with_tapes) tape_meridians(plan);
    return plan;
}

std::vector<double> tape_forces_by_design(const EnvelopeDesign& design) {
    const NaturalShape shape = design_shape(design);
    const double top = shape.meridian.descent_to(design.crown_radius).s;
    std::vector<double> forces;
    for (int panel = 0; panel < design.panels; ++panel)
        forces.push_back(shape.point_at(top * (panel + 0.5) / design.panels).tension / design.gores);
    return forces;
}

CutPlan cut_full_balloon(const EnvelopeDesign& design, double fullness, double tape_stiffness) {
    FlattenOptions options;
    options.fabric = fabric_named("nylon");
    Envelope envelope = balloon(design);
    WantedCloth wanted = drawn_cloth(envelope);
    for (Points3& strain : wanted.strain) strain.col(0).setConstant(0.5 * (1 / ((1 + fullness) * (1 + fullness)) - 1));
    const std::vector<double> forces = tape_forces_by_design(design);
    for (std::size_t s = 0; s < envelope.seams.size(); ++s)
        wanted.tape_strain[s] =
            forces[static_cast<std::size_t>(envelope.seams[s].a.tile % design.panels)] / tape_stiffness;
    compensate_tiles(wanted, envelope);
    CutPlan plan = flatten_envelope(envelope, options);
    tape_meridians(plan);
    plan.tape_factors = tape_factors(wanted, envelope);
    return plan;
}

GasPressure hot_air(const SewnEnvelope& sewn) {
    return {0, buoyancy({}), sewn.floor};
}

Equilibrium rest(const SewnEnvelope& sewn, const Points3& start, double residual) {
    Balance balance(sewn, hot_air(sewn), 0);
    EquilibriumOptions options;
    options.tolerance = 1e-8;
    options.residuals = {1e-2, 1e-4};
    if (residual < 1e-4) options.residuals.push_back(residual);
    return find_equilibrium(balance, start, options);
}

Points3 all_vertices(const SewnEnvelope& sewn, const Points3& nodes) {
    Points3 vertices(static_cast<Eigen::Index>(sewn.places.size()), 3);
    for (std::size_t v = 0; v < sewn.places.size(); ++v)
        vertices.row(static_cast<Eigen::Index>(v)) =
            position(sewn.places[v], nodes, 2 * std::numbers::pi / sewn.sectors) + sewn.origin;
    return vertices;
}

}  // namespace ripstop::testing
