#include "ripstop/pipeline/read/read_envelope.h"

#include <algorithm>

#include "ripstop/assembly/seams/find_seams.h"
#include "ripstop/base/error.h"
#include "ripstop/base/text/glob.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/io/mesh/mesh_file.h"
#include "ripstop/pipeline/read/grain_lines.h"
#include "ripstop/pipeline/read/name_tiles.h"
#include "ripstop/pipeline/read/prepare_model.h"
#include "ripstop/pipeline/read/seam_rules.h"
#include "ripstop/pipeline/read/surface_lines.h"
#include "ripstop/pipeline/read/tile_fabrics.h"
#include "ripstop/pipeline/read/tile_options.h"
#include "ripstop/pipeline/remesh/fair_seams.h"
#include "ripstop/tile/make_tile.h"

namespace ripstop {
namespace {

constexpr std::size_t shown_faults = 20;
constexpr std::size_t shown_tiles = 10;

bool wanted(const std::string& name, const std::vector<std::string>& only) {
    return only.empty() ||
           std::any_of(only.begin(), only.end(), [&name](const std::string& glob) { return glob_match(glob, name); });
}

/// Every requested name must exist: a mistyped one would silently leave out a part of the job.
void require_wanted(const std::vector<std::string>& names, const std::vector<std::string>& only, const char* what) {
    for (const std::string& glob : only) {
        const auto fits = [&glob](const std::string& name) { return glob_match(glob, name); };
        if (std::any_of(names.begin(), names.end(), fits)) continue;
        std::string shown;
        for (std::size_t i = 0; i < std::min(names.size(), shown_tiles); ++i) shown += (i ? ", " : "") + names[i];
        throw InputError("no " + std::string(what) + " is called \"" + glob + "\"; the input has " +
                         (names.empty() ? "none" : shown) + (names.size() > shown_tiles ? ", …" : ""));
    }
}

[[noreturn]] void refuse(const std::vector<EnvelopeIssue>& faults) {
    std::string text;
    for (std::size_t i = 0; i < std::min(faults.size(), shown_faults); ++i) text += (i ? "\n" : "") + faults[i].message;
    if (faults.size() > shown_faults)
        text += "\nand " + std::to_string(faults.size() - shown_faults) + " more like these";
    throw InputError(text);
}

/// Keeps the objects on the requested layers. An object without a known layer is on none of them.
void keep_layers(CadModel& model, const std::vector<std::string>& layers,
                 const std::vector<std::string>& grain_layers) {
    if (layers.empty()) return;
    require_wanted(model.layers, layers, "layer");
    const bool any = !model.surfaces.empty();
    const auto elsewhere = [&layers](const auto& object) {
        const auto layer = object.attributes.find("layer");
        return layer == object.attributes.end() || !wanted(layer->second, layers);
    };
    std::erase_if(model.surfaces, elsewhere);
    if (any && model.surfaces.empty())
        throw InputError("no surface lies on layer \"" + layers.front() +
                         "\" itself; choose one that has some, or give \"" + layers.front() +
                         "::*\" for the layers below it");
    std::erase_if(model.unread, elsewhere);
    // Grain lines have layers of their own and keep their places.
    std::erase_if(model.curves,
                  [&](const NamedCurve& curve) { return elsewhere(curve) && !is_grain_line(curve, grain_layers); });
}

void require_surfaces(const CadModel& model, const std::vector<std::string>& remarks, const std::string& file) {
    if (!model.surfaces.empty()) return;
    std::string text = file + ": no surface that could be read, expected the tiles as meshes or surfaces";
    for (std::size_t i = 0; i < std::min(model.unread.size(), shown_faults); ++i)
        text += "\n" + model.unread[i].type + " " + model.unread[i].name + ": " + model.unread[i].reason;
    for (std::size_t i = 0; i < std::min(remarks.size(), shown_faults); ++i) text += "\n" + remarks[i];
    throw InputError(text);
}

Tile tile_of(NamedMesh& surface, const ReadOptions& options) {
    if (!surface.fault.empty()) throw InputError("tile " + surface.name + ": " + surface.fault);
    TileOptions tile;
    if (options.project)
        tile = tile_options(*options.project, surface.name, options.unit.value_or(LengthUnit{}).metres);
    if (!tile.warp && !tile.grain_turn) take_warp(surface, tile);
    if (!tile.grain_turn) tile.grain_turn = options.grain_turn;
    tile.drawn = std::move(surface.drawn);
    tile.attributes = std::move(surface.attributes);
    return make_tile(surface.name, std::move(surface.mesh), tile);
}

/// Adds deviations from the file to the remarks, and surfaces that are no tiles to `issues`. Throws for such surfaces
/// if `issues` is null or no tile remains.
Envelope make_envelope(std::vector<NamedMesh> surfaces, const ReadOptions& options, std::vector<std::string>& remarks,
                       std::vector<EnvelopeIssue>* issues) {
    std::vector<std::string> names;
    for (const NamedMesh& surface : surfaces) names.push_back(surface.name);
    require_wanted(names, options.only, "tile");
    Envelope envelope;
    std::vector<EnvelopeIssue> faults;
    for (NamedMesh& surface : surfaces) {
        if (!wanted(surface.name, options.only)) continue;
        const Vec3 middle = box_of(surface.mesh).center();
        try {
            envelope.tiles.push_back(tile_of(surface, options));
            if (options.project && !options.project->flight.rigging.diaphragms.empty())
                envelope.tiles.back().inside = wanted(surface.name, options.project->flight.rigging.diaphragms);
        } catch (const InputError& error) {
            faults.push_back({"no_tile", error.what(), {surface.name}, middle, 0});
        }
    }
    if (!faults.empty() && (!issues || envelope.tiles.empty())) refuse(faults);
    for (EnvelopeIssue& fault : faults) {
        fault.message += "; it is left out, and the edges of its neighbours along it count as free";
        issues->push_back(std::move(fault));
    }
    for (std::string& remark : give_fabrics(envelope, options.project, options.fabric))
        remarks.push_back(std::move(remark));
    add_seams(envelope, {options.seam_tolerance});
    if (options.project) give_seam_types(envelope, *options.project);
    return envelope;
}

std::string in_mm(double length) {
    return format_fixed(length / millimetre, length < millimetre ? 3 : 1) + " mm";
}

/// Reports the loss by single precision if it is at least a tenth of the seam tolerance.
void name_rounding(double rounding, double seam_tolerance, EnvelopeInput& input) {
    if (rounding < seam_tolerance / 10) return;
    const std::string lost = "coordinates are stored in single precision: " + in_mm(rounding) +
                             " of rounding error at this distance from the origin";
    if (rounding <= seam_tolerance) {
        input.remarks.push_back(lost);
        return;
    }
    EnvelopeIssue issue{"precision",
                        lost + ", more than the seam tolerance of " + in_mm(seam_tolerance) +
                            "; move the model to the origin in the CAD and export it again, or in double precision",
                        {},
                        Vec3::Zero(),
                        rounding,
                        seam_tolerance};
    input.issues.push_back(std::move(issue));
}

/// Moves a model that is far from the origin, with its project; the input gets the moved flight.
void come_near(CadModel& model, std::optional<Project>& project, EnvelopeInput& input) {
    const Vec3 origin = far_origin(model);
    const double metres = input.unit.unit.metres;
    if (!origin.isZero()) {
        count_from(origin, model);
        if (project) count_from(origin, metres, *project);
        const auto number = [&](int axis) { return format_fixed(origin[axis], 0); };
        input.remarks.push_back("the model lies " + format_fixed(origin.norm() * metres, 0) +
                                " m from the origin; all positions are relative to (" + number(0) + ", " + number(1) +
                                ", " + number(2) + ") " + input.unit.unit.name);
    }
    if (project) input.flight = project->flight;
}

void doubt_size(const CadModel& model, const ReadOptions& options, EnvelopeInput& input) {
    std::vector<Eigen::AlignedBox3d> boxes;
    for (const NamedMesh& surface : model.surfaces)
        if (wanted(surface.name, options.only)) boxes.push_back(box_of(surface.mesh));
    input.doubt = doubt_unit(boxes, input.unit);
    if (input.doubt && options.doubts) options.doubts(*input.doubt);
}

/// Steps that need the final meshes: lays the lines on them, and sets the types of seams and chains, which remeshed
/// tiles lack.
void finish_meshes(const CadModel& model, const std::optional<Project>& project,
                   const std::vector<std::string>& grain_layers, Envelope& envelope,
                   std::vector<std::string>& remarks) {
    for (std::string& remark : lay_lines(model, envelope, grain_layers)) remarks.push_back(std::move(remark));
    if (project) give_seam_types(envelope, *project);
}

}  // namespace

Envelope make_envelope(std::vector<NamedMesh> surfaces, const ReadOptions& options) {
    std::vector<std::string> unheard;
    return make_envelope(std::move(surfaces), options, unheard, nullptr);
}

void remesh_input(EnvelopeInput& input, const ReadOptions& options) {
    if (options.fair_seams)
        for (std::string& remark : fair_seams(input.envelope, options.seam_tolerance))
            input.remarks.push_back(std::move(remark));
    RemeshOptions remesh = options.remesh;
    remesh.seam_tolerance = options.seam_tolerance;
    if (remesh.mode != RemeshMode::never) input.drawn = AsDrawn{input.envelope, input.remarks};
    for (std::string& remark : remesh_envelope(input.envelope, remesh)) input.remarks.push_back(std::move(remark));
    const std::vector<Tile>& tiles = input.envelope.tiles;
    if (std::none_of(tiles.begin(), tiles.end(), [](const Tile& tile) { return tile.remeshed.has_value(); }))
        input.drawn.reset();
}

EnvelopeInput read_input(const std::filesystem::path& file, const ReadOptions& options) {
    MeshingOptions meshing = options.meshing;
    meshing.sewing_tolerance = options.seam_tolerance;
    if (options.unit) meshing.metres_per_unit = options.unit->metres;
    CadModel model = read_model(file, meshing);
    EnvelopeInput input;
    input.unit_assumed = !options.unit && !model.unit;
    input.unit = {options.unit ? *options.unit : model.unit.value_or(LengthUnit{}),
                  !options.unit && model.unit.has_value(), options.size_is_meant};
    const double metres = input.unit.unit.metres;
    input.remarks = std::move(model.remarks);
    if (options.unit && model.unit && options.unit->metres != model.unit->metres)
        input.remarks.push_back("the file's unit is " + model.unit->name + ", but --unit takes its numbers as " +
                                options.unit->name);
    ReadOptions in_this_unit = options;
    in_this_unit.unit = input.unit.unit;
    std::optional<Project>& project = in_this_unit.project;
    const std::vector<std::string> grain_layers = project ? project->grain_layers : std::vector<std::string>();
    for (std::string& remark : mend_surfaces(model, options.seam_tolerance / metres))
        input.remarks.push_back(std::move(remark));
    if (project) name_tiles(model, *project);
    keep_layers(model, options.layers, grain_layers);
    require_surfaces(model, input.remarks, file.string());
    for (const UnreadObject& object : model.unread)
        input.remarks.push_back(object.type + " " + object.name + " left out: " + object.reason);
    name_rounding(model.rounding * metres, options.seam_tolerance, input);
    come_near(model, project, input);
    model = in_metres(std::move(model), metres);
    doubt_size(model, options, input);
    for (std::string& remark : lay_grain_lines(model, grain_layers)) input.remarks.push_back(std::move(remark));
    input.envelope = make_envelope(std::move(model.surfaces), in_this_unit, input.remarks, &input.issues);
    if (project && options.only.empty()) input.unused = unused_entries(*project, input.envelope);
    remesh_input(input, options);
    finish_meshes(model, project, grain_layers, input.envelope, input.remarks);
    if (input.drawn) finish_meshes(model, project, grain_layers, input.drawn->envelope, input.drawn->remarks);
    return input;
}

Envelope read_envelope(const std::filesystem::path& file, const ReadOptions& options) {
    EnvelopeInput input = read_input(file, options);
    std::erase_if(input.issues, [](const EnvelopeIssue& issue) { return issue.code != "no_tile"; });
    if (!input.issues.empty()) refuse(input.issues);
    return std::move(input.envelope);
}

}  // namespace ripstop
