#pragma once

#include "ripstop/base/progress.h"
#include "ripstop/inflate/equilibrium.h"
#include "ripstop/inflate/sew.h"
#include "ripstop/model/flight/inflated.h"

namespace ripstop {

/// The load case of an inflation and the options of the solver.
struct InflateOptions {
    LoadCase load = {};
    SewOptions sewing = {};
    std::vector<Points3> start = {};  ///< per tile #V x 3 [m]; as drawn if empty
    int iterations = 300;
    int threads = 0;
    Progress progress = {};
};

/// Sews the pieces (`sew`), fills the envelope with gas and finds the equilibrium (`find_equilibrium`). Then compares
/// the shape with the drawing and computes the loads of cloth and tapes. The gauge pressure is
/// p = extra + b (z - mouth plane), where b is the buoyancy of the air (`buoyancy`).
///
/// A numerical failure is reported in `Inflated::summary`, and the figures are those of the last state. Throws
/// InputError as `sew` and `buoyancy` do.
Inflated inflate(const CutPlan& plan, const InflateOptions& options);

/// The safety factors of cloth, load tapes, ties and wires under their largest loads, by CS 31HB.25 and 14 CFR 31.25:
///
///     factor = f_T f_age f_seam R / (n load),  R the strength, n = 1.4
///     cloth: f_T 0.5, f_age 0.5, f_seam 0.8;  tapes: f_age 0.5;  wires: 1
///
/// The stricter of the two rules applies: 5 for cloth, load tapes and ties, and 5 for wires, which are assumed not to
/// be metallic (14 CFR 31.25(c); CS 31HB.25 requires 2.25).
///
/// At a corner where seams end, the tension of a membrane is singular: it grows as the mesh is refined. The load of
/// the cloth is therefore the tension that 0.1 % of its area exceeds (1 m2 of 1,000). `Inflated::tension_max` is the
/// largest tension of all.
std::vector<SafetyFactor> safety_factors(const Inflated& inflated, const CutPlan& plan, const Rigging& rigging);

}  // namespace ripstop
