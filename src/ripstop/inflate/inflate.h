#pragma once

#include "ripstop/base/progress.h"
#include "ripstop/inflate/equilibrium.h"
#include "ripstop/inflate/sew.h"
#include "ripstop/model/flight/inflated.h"

namespace ripstop {

/// What `inflate` fills an envelope with, and how it solves.
struct InflateOptions {
    LoadCase load = {};
    SewOptions sewing = {};
    std::vector<Points3> start = {};  ///< of each tile #V x 3 [m]; as drawn where empty
    int iterations = 300;
    int threads = 0;
    Progress progress = {};
};

/// Sews the pieces (`sew`), fills them with gas and finds the equilibrium (`find_equilibrium`). Then compares the shape
/// with the drawing and reads off what cloth and tapes bear. The gauge pressure is p = extra + b (z - mouth plane), b
/// of the air (`buoyancy`).
///
/// Numerical failure is a value: `Inflated::summary` says so, and the figures are those of the last state. Throws
/// InputError as `sew` and `buoyancy` do.
Inflated inflate(const CutPlan& plan, const InflateOptions& options);

/// The safety factors of cloth, load tapes, ties and wires under their largest loads, by CS 31HB.25 and 14 CFR 31.25:
///
///     factor = f_T f_age f_seam R / (n load),  R the strength, n = 1.4
///     cloth: f_T 0.5, f_age 0.5, f_seam 0.8;  tapes: f_age 0.5;  wires: 1
///
/// Required is the stricter of the two rules: 5 for cloth, load tapes and ties, and 5 for wires, which are taken as not
/// metallic (14 CFR 31.25(c); CS 31HB.25 asks 2.25).
///
/// In a corner where seams end the tension of cloth without thickness has no bound: it grows as the mesh gets finer.
/// The load of the cloth is therefore the tension that 0.1 % of its area exceeds (1 m2 of 1,000).
/// `Inflated::tension_max` is the largest tension of all.
std::vector<SafetyFactor> safety_factors(const Inflated& inflated, const CutPlan& plan, const Rigging& rigging);

}  // namespace ripstop
