#include "field/field_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <random>
#include <sstream>
#include <utility>

#include "field/families.h"
#include "ripstop/base/error.h"
#include "ripstop/base/text/units.h"
#include "ripstop/geometry/polygon.h"
#include "ripstop/io/json/fabric_json.h"
#include "ripstop/io/mesh/obj.h"
#include "ripstop/pattern/piece/pieces.h"
#include "ripstop/pipeline/flatten/flatten_envelope.h"
#include "ripstop/pipeline/read/envelope_faults.h"
#include "ripstop/pipeline/read/own_meshes.h"
#include "ripstop/pipeline/read/prepare_model.h"
#include "ripstop/pipeline/read/read_envelope.h"
#include "ripstop/pipeline/read/seam_doubts.h"
#include "support/shapes.h"

namespace ripstop::field {
namespace {

const std::vector<Variant>& variants() {
    static const std::vector<Variant> all{
        {"as made"},
        {"remeshed", true},
        {"moved and shuffled", false, true, 1},
        {"remeshed, moved and shuffled", true, true, 2},
        {"in mm, nylon", false, false, 3, "mm", "nylon"},
        {"remeshed, in mm, polyester", true, true, 0, "mm", "polyester"},
        {"in inches, moved", false, true, 4, "in", "polyester"},
        {"remeshed, nylon, shuffled", true, false, 5, "", "nylon"},
    };
    return all;
}

/// Six decimals, as a CAD writes them.
std::vector<NamedMesh> through_a_file(std::vector<NamedMesh> tiles, const std::string& unit) {
    const double metres = metres_per_unit(unit);
    for (NamedMesh& tile : tiles)
        tile.mesh.positions = (tile.mesh.positions * (1e6 / metres)).array().round().matrix() / 1e6;
    std::stringstream file;
    write_obj(file, tiles);
    return in_metres(read_obj(file, "case.obj"), metres).surfaces;
}

std::vector<NamedMesh> varied(std::vector<NamedMesh> tiles, const Variant& variant) {
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        if (variant.is_moved) tiles[i].mesh = testing::moved(tiles[i].mesh);
        if (variant.order != 0)
            tiles[i].mesh = testing::shuffled(tiles[i].mesh, variant.order + static_cast<unsigned>(i));
    }
    if (variant.order != 0) std::shuffle(tiles.begin(), tiles.end(), std::mt19937(variant.order));
    return variant.unit.empty() ? tiles : through_a_file(std::move(tiles), variant.unit);
}

struct Run {
    EnvelopeCheck check;
    CutPlan plan;
    std::vector<PatternPiece> pieces;
};

Run run(const Case& each) {
    const Fabric fabric = each.variant.fabric.empty() ? Fabric{} : fabric_named(each.variant.fabric);
    ReadOptions reading;
    reading.fabric = fabric;
    Run result;
    EnvelopeInput input;
    CadModel model;
    model.surfaces = varied(each.tiles, each.variant);
    mend_surfaces(model, reading.seam_tolerance, 1);
    input.envelope = make_envelope(std::move(model.surfaces), reading);
    const Envelope drawn = input.envelope;
    RemeshOptions remeshing;
    if (each.variant.remesh) {
        remeshing.mode = RemeshMode::automatic;
        remeshing.threads = 1;
        remesh_envelope(input.envelope, remeshing);
        input.drawn = AsDrawn{drawn, {}};
    }
    FlattenOptions flattening;
    flattening.fabric = fabric;
    flattening.threads = 1;
    const EnvelopeCheck faults = judge_input(input, {});
    result.plan = flatten_envelope(input.envelope, flattening);
    if (each.variant.remesh) prefer_own_meshes(result.plan, input, flattening);
    add_faults(result.plan, faults);
    result.check = faults;
    add_seam_doubts(result.check, drawn, remeshing);
    result.pieces = make_pieces(result.plan, {}, 1);
    return result;
}

std::string why_not(const CutPlan& plan) {
    for (const FlatTile& tile : plan.tiles)
        for (const Finding& finding : tile.verdict.findings) return tile.tile.name + ": " + finding.message;
    for (const Finding& finding : plan.findings) return finding.message;
    for (const SeamWalk& walk : plan.walks)
        if (!walk.ok) return fmt::format("a seam drifts by {:.3f} mm", walk.drift_max / millimetre);
    return "unjudged";
}

void judge_verdict(const Case& each, const Run& run, std::vector<std::string>& wrong) {
    const bool made = run.plan.manufacturable();
    if (each.expected.manufacturable && made != *each.expected.manufacturable)
        wrong.push_back(made ? "is called manufacturable" : "is not manufacturable: " + why_not(run.plan));
    if (!run.check.sound() && made)
        wrong.push_back("check says " + run.check.issues.front().message + ", flatten passes");
    for (std::size_t s = 0; s < run.plan.walks.size() && made; ++s)
        if (!run.plan.walks[s].is_certain())
            wrong.push_back(fmt::format("passes with seam {} open by {:.2f} mm", run.plan.seams[s].id,
                                        run.plan.walks[s].uncertainty / millimetre));
}

void judge_tiles(const Case& each, const Run& run, std::vector<std::string>& wrong) {
    double area = 0, outline = 0;
    for (const FlatTile& tile : run.plan.tiles) {
        const Accuracy& found = tile.accuracy;
        area += found.flat_area;
        outline += found.flat_perimeter;
        const double strain =
            std::max({found.warp_strain_max, -found.warp_strain_min, found.weft_strain_max, -found.weft_strain_min});
        if (each.expected.is_isometric && !(strain < 1e-3))
            wrong.push_back(fmt::format("{} has a strain of {:.3f} %", tile.tile.name, 100 * strain));
    }
    // The file rounds each coordinate, so the outline has an error of the same size.
    const double rounding = each.variant.unit.empty() ? 0 : 1e-6 * metres_per_unit(each.variant.unit) * outline;
    if (!(area >= each.expected.area_least - rounding && area <= each.expected.area_most + rounding))
        wrong.push_back(fmt::format("flat area {:.6f} m2, expected {:.6f} to {:.6f}", area, each.expected.area_least,
                                    each.expected.area_most));
    const auto kinds = std::count_if(run.plan.tiles.begin(), run.plan.tiles.end(),
                                     [](const FlatTile& tile) { return tile.equal_to < 0; });
    if (each.expected.kinds && kinds != *each.expected.kinds)
        wrong.push_back(fmt::format("{} patterns, expected {}", kinds, *each.expected.kinds));
    if (each.expected.seams && std::cmp_not_equal(run.plan.seams.size(), *each.expected.seams))
        wrong.push_back(fmt::format("{} seams, expected {}", run.plan.seams.size(), *each.expected.seams));
}

/// Every point of the sew line lies inside the cut line or on it.
void judge_pieces(const Run& run, std::vector<std::string>& wrong) {
    if (!run.plan.manufacturable()) return;
    for (const PatternPiece& piece : run.pieces) {
        if (piece.cut_line.rows() < 3) {
            wrong.push_back(piece.name + " has no cut line");
            continue;
        }
        const SelfIntersections crossings = self_intersections(piece.cut_line);
        if (crossings.count > 0) wrong.push_back(piece.name + ": the cut line crosses itself");
        if (signed_area(piece.cut_line) < signed_area(piece.sew_line) * (1 - 1e-9))
            wrong.push_back(piece.name + ": the cut line encloses less than the sew line");
        for (Eigen::Index i = 0; i < piece.sew_line.rows(); ++i) {
            const Vec2 point = piece.sew_line.row(i);
            if (contains(piece.cut_line, point) || distance_to_outline(piece.cut_line, point) < 1e-6) continue;
            wrong.push_back(piece.name + ": a point of the sew line is outside the cut line");
            break;
        }
        // The cut line is nowhere farther from the sew line than the widest allowance at a mitred corner.
        double widest = 0;
        for (const PieceEdge& edge : piece.edges) widest = std::max(widest, edge.allowance);
        for (Eigen::Index i = 0; i < piece.sew_line.rows(); ++i) {
            const Vec2 point = piece.sew_line.row(i);
            if (distance_to_outline(piece.cut_line, point) <= 4 * widest + 1e-6) continue;
            wrong.push_back(fmt::format("{}: the cut line leaves out what is near ({:.3f}, {:.3f})", piece.name,
                                        point.x(), point.y()));
            break;
        }
    }
}

}  // namespace

std::vector<Case> field_shapes() {
    std::vector<Case> all;
    for (const auto& family :
         {straps, belts, sleeves, rings, skirts, keyholes, gores, ribs, fins, pools, tents, covers})
        for (Case& each : family()) all.push_back(std::move(each));
    return all;
}

std::vector<Case> field_cases() {
    std::vector<Case> all;
    for (const Case& shape : field_shapes())
        for (const Variant& variant : variants()) {
            all.push_back(shape);
            all.back().variant = variant;
        }
    return all;
}

std::vector<std::string> failures_of(const Case& each) {
    std::vector<std::string> wrong;
    try {
        const Run result = run(each);
        judge_verdict(each, result, wrong);
        judge_tiles(each, result, wrong);
        judge_pieces(result, wrong);
    } catch (const InputError& error) {
        wrong.push_back(std::string("is refused: ") + error.what());
    }
    return wrong;
}

}  // namespace ripstop::field
