#include "ripstop/flatten/method.h"

#include <array>

#include "ripstop/base/error.h"
#include "ripstop/flatten/arap.h"
#include "ripstop/flatten/boundary_first.h"
#include "ripstop/flatten/lscm.h"
#include "ripstop/flatten/paper.h"
#include "ripstop/flatten/seam_exact.h"
#include "ripstop/flatten/seam_matched.h"
#include "ripstop/flatten/woven_mesh.h"

namespace ripstop {
namespace {

constexpr double paper_tolerance =
    0.001 - 1e-9;  // of an edge: 1 mm on a metre, and that rounding does not carry it over

constexpr std::array table = {
    Method{"seam-exact", "least energy of the woven cloth with every edge exactly as long as drawn",
           [](const Tile& tile, const Fabric& fabric) { return flatten_seam_exact(tile, fabric); }},
    Method{
        "seam-exact-area", "the same with the whole area exact too, which strains the cloth more",
        [](const Tile& tile, const Fabric& fabric) { return flatten_seam_exact(tile, fabric, {.keep_area = true}); }},
    Method{"seam-matched",
           "the whole envelope at once: both sides of a seam equally long, least energy of all the cloth",
           [](const Tile& tile, const Fabric& fabric) { return flatten_seam_exact(tile, fabric); },
           [](const Envelope& envelope, const Fabric& fabric, int threads, const Progress& progress) {
               return flatten_seam_matched(envelope, fabric, {.threads = threads, .progress = progress});
           }},
    Method{"seam-matched-0.1", "the same with every seam within 0.1 % of its drawn length",
           [](const Tile& tile, const Fabric& fabric) { return flatten_seam_exact(tile, fabric); },
           [](const Envelope& envelope, const Fabric& fabric, int threads, const Progress& progress) {
               return flatten_seam_matched(envelope, fabric,
                                           {.slack = paper_tolerance, .threads = threads, .progress = progress});
           }},
    Method{"paper", "Kubicek, Zemcik: woven mesh fit, then springs along warp and weft, midpoint rule",
           [](const Tile& tile, const Fabric& fabric) { return flatten_paper(tile, fabric); }},
    Method{"paper-adaptive", "the same with the adaptive time step the paper leaves to future work",
           [](const Tile& tile, const Fabric& fabric) { return flatten_paper(tile, fabric, {.adaptive = true}); }},
    Method{"woven", "Wang, Tang, Yeung 2005: a woven mesh fitted to the surface, the paper's first step alone",
           [](const Tile& tile, const Fabric& fabric) { return flatten_woven(tile, fabric); }},
    Method{"lscm", "Levy, Petitjean, Ray, Maillot 2002: least squares conformal map, angles true, lengths not",
           [](const Tile& tile, const Fabric&) { return flatten_lscm(tile); }},
    Method{"bff", "Sawhney, Crane 2018: boundary first, conformal with an isometric boundary; area is what gives",
           [](const Tile& tile, const Fabric&) { return flatten_boundary_first(tile); }},
    Method{"arap", "Liu, Zhang, Xu, Gotsman, Gortler 2008: as rigid as possible, isotropic",
           [](const Tile& tile, const Fabric&) { return flatten_arap(tile); }},
};

}  // namespace

std::span<const Method> methods() {
    return table;
}

const Method& method_named(const std::string& name) {
    std::string known;
    for (const Method& method : methods()) {
        if (name == method.name) return method;
        known += (known.empty() ? "" : ", ") + std::string(method.name);
    }
    throw InputError("no method \"" + name + "\"; known: " + known);
}

}  // namespace ripstop
