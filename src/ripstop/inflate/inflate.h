#pragma once

#include "ripstop/base/progress.h"
#include "ripstop/inflate/equilibrium.h"
#include "ripstop/inflate/sew.h"
#include "ripstop/model/flight/inflated.h"

namespace ripstop {

struct InflateOptions {
    LoadCase load = {};
    SewOptions sewing = {};
    std::vector<Points3> start = {};  ///< of each tile #V x 3 [m]; as drawn where empty
    int iterations = 300;
    int threads = 0;
    Progress progress = {};
};

/// Sews the pieces (`sew`), fills them with gas and finds where everything is in balance (`find_equilibrium`); then compares with the
/// drawing and reads off what cloth and tapes bear. p = extra + b (z - mouth plane), b of the air (`buoyancy`).
///
/// Numerical failure is a value: `Inflated::summary` says so, and the figures are those of the last state. Throws InputError
/// as `sew` and `buoyancy` do.
Inflated inflate(const CutPlan& plan, const InflateOptions& options);

/// What must hold whatever the shape: factors of CS 31HB.25 and 14 CFR 31.25 against the largest loads. Where seams end in a corner
/// the tension of cloth without thickness has no bound, it only grows with the mesh: what counts of the cloth is the tension that
/// 0.1 % of its area exceeds (1 m2 of 1,000), `Inflated::tension_max` is the largest there is.
///
///     factor = f_T f_age f_seam R / (n load):  n = 1.4; cloth f_T .5, f_age .5, f_seam .8; tapes f_age .5; wires 1
///     required: the stricter of the two. Cloth, load tapes and ties 5 (envelope); wires 5 (14 CFR 31.25(c), not
/// metallic; CS
///               31HB.25 asks 2.25)
std::vector<SafetyFactor> safety_factors(const Inflated& inflated, const CutPlan& plan, const Rigging& rigging);

}  // namespace ripstop
