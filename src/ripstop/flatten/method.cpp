#include "ripstop/flatten/method.h"

#include <array>

#include "ripstop/base/error.h"
#include "ripstop/flatten/map/arap.h"
#include "ripstop/flatten/map/boundary_first.h"
#include "ripstop/flatten/map/dirichlet.h"
#include "ripstop/flatten/map/lscm.h"
#include "ripstop/flatten/map/wirewarping.h"
#include "ripstop/flatten/seam/seam_exact.h"
#include "ripstop/flatten/seam/seam_matched.h"
#include "ripstop/flatten/spring/energy_release.h"
#include "ripstop/flatten/spring/kubicek_zemcik.h"
#include "ripstop/flatten/spring/mccartney.h"
#include "ripstop/flatten/weave/aono.h"
#include "ripstop/flatten/weave/kub10.h"
#include "ripstop/flatten/weave/woven_mesh.h"

namespace ripstop {
namespace {

constexpr double paper_tolerance = 0.001 - 1e-9;  // of an edge: 1 mm per metre, with a margin for rounding

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
           [](const Tile& tile, const Fabric& fabric) { return flatten_kubicek_zemcik(tile, fabric); }},
    Method{"paper-adaptive", "the same with the adaptive time step the paper leaves to future work",
           [](const Tile& tile, const Fabric& fabric) {
               return flatten_kubicek_zemcik(tile, fabric, {.adaptive = true});
           }},
    Method{"woven", "Wang, Tang, Yeung 2005: a woven mesh fitted to the surface, the paper's first step alone",
           [](const Tile& tile, const Fabric& fabric) { return flatten_woven(tile, fabric); }},
    Method{"woven-1-1-1", "the same with springs that resist shear as much as stretch, its authors' isotropic weave",
           [](const Tile& tile, const Fabric& fabric) {
               return flatten_woven(tile, fabric, {.warp_stiffness = 1, .weft_stiffness = 1});
           }},
    Method{"lscm", "Levy, Petitjean, Ray, Maillot 2002: least squares conformal map, angles true, lengths not",
           [](const Tile& tile, const Fabric&) { return flatten_lscm(tile); }},
    Method{"bff", "Sawhney, Crane 2018: boundary first, conformal with an isometric boundary; the error is in area",
           [](const Tile& tile, const Fabric&) { return flatten_boundary_first(tile); }},
    Method{"arap", "Liu, Zhang, Xu, Gotsman, Gortler 2008: as rigid as possible, isotropic",
           [](const Tile& tile, const Fabric&) { return flatten_arap(tile); }},
    Method{"dirichlet", "Smith, Schaefer 2015: symmetric Dirichlet energy from Tutte's embedding, no flips",
           [](const Tile& tile, const Fabric&) { return flatten_dirichlet(tile); }},
    Method{"energy", "Wang, Smith, Yuen 2002: triangles laid one by one, springs on the edges release their energy",
           [](const Tile& tile, const Fabric&) { return flatten_energy_release(tile); }},
    Method{"mccartney",
           "McCartney, Hinds, Seow 1999: triangles laid one by one, trial moves that lower the edge energy",
           [](const Tile& tile, const Fabric& fabric) { return flatten_mccartney(tile, fabric); }},
    Method{"mccartney-woven", "the same, then under the orthotropic energy of its sequels of 2000 and 2005",
           [](const Tile& tile, const Fabric& fabric) { return flatten_mccartney(tile, fabric, {.woven = true}); }},
    Method{"kub10", "an earlier system of the paper's authors: a planar projection refined by the woven model",
           [](const Tile& tile, const Fabric&) { return flatten_kub10(tile); }},
    Method{"aono", "Aono, Breen, Wozny 1994: threads that do not stretch, swept from two straight lines",
           [](const Tile& tile, const Fabric&) { return flatten_aono(tile); }},
    Method{"wirewarping", "Wang 2008: the outline's edges exact, its angles as close as possible to the surface's",
           [](const Tile& tile, const Fabric&) { return flatten_wirewarping(tile); }},
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
