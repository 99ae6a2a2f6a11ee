#include "ripstop/pipeline/read_envelope.h"

#include <algorithm>

#include "ripstop/assembly/find_seams.h"
#include "ripstop/base/error.h"
#include "ripstop/base/glob.h"
#include "ripstop/io/mesh_file.h"
#include "ripstop/pipeline/grain_lines.h"
#include "ripstop/pipeline/name_tiles.h"
#include "ripstop/pipeline/seam_rules.h"
#include "ripstop/pipeline/surface_lines.h"
#include "ripstop/pipeline/tile_fabrics.h"

namespace ripstop {
namespace {

constexpr std::size_t shown_faults = 20;
constexpr std::size_t shown_names = 10;

bool wanted(const std::string& name, const std::vector<std::string>& only) {
    return only.empty() ||
           std::any_of(only.begin(), only.end(), [&name](const std::string& glob) { return glob_match(glob, name); });
}

/// Every name that was asked for must be there: a mistyped one would silently leave out a part of the job.
void require_wanted(const std::vector<std::string>& names, const std::vector<std::string>& only, const char* what) {
    for (const std::string& glob : only) {
        const auto fits = [&glob](const std::string& name) { return glob_match(glob, name); };
        if (std::any_of(names.begin(), names.end(), fits)) continue;
        std::string shown;
        for (std::size_t i = 0; i < std::min(names.size(), shown_names); ++i) shown += (i ? ", " : "") + names[i];
        throw InputError("no " + std::string(what) + " is called \"" + glob + "\"; the input has " +
                         (names.empty() ? "none" : shown) + (names.size() > shown_names ? ", …" : ""));
    }
}

[[noreturn]] void refuse(const std::vector<std::string>& faults) {
    std::string text;
    for (std::size_t i = 0; i < std::min(faults.size(), shown_faults); ++i) text += (i ? "\n" : "") + faults[i];
    if (faults.size() > shown_faults)
        text += "\nand " + std::to_string(faults.size() - shown_faults) + " more like these";
    throw InputError(text);
}

/// Keeps what lies on the layers asked for. An object whose layer is not known lies on none.
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
    // Grain lines have layers of their own, and lie where they lie.
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

/// What was taken otherwise than it stands goes into the remarks.
Envelope make_envelope(std::vector<NamedMesh> surfaces, const ReadOptions& options, std::vector<std::string>& remarks) {
    std::vector<std::string> names;
    for (const NamedMesh& surface : surfaces) names.push_back(surface.name);
    require_wanted(names, options.only, "tile");
    Envelope envelope;
    std::vector<std::string> faults;
    for (NamedMesh& surface : surfaces) {
        if (!wanted(surface.name, options.only)) continue;
        try {
            TileOptions tile;
            if (options.project)
                tile = tile_options(*options.project, surface.name, options.unit.value_or(LengthUnit{}).metres);
            if (!tile.warp && !tile.grain_turn) take_warp(surface, tile);
            if (!tile.grain_turn) tile.grain_turn = options.grain_turn;
            tile.drawn = std::move(surface.drawn);
            tile.attributes = std::move(surface.attributes);
            envelope.tiles.push_back(make_tile(surface.name, std::move(surface.mesh), tile));
        } catch (const InputError& error) {
            faults.emplace_back(error.what());
        }
    }
    if (!faults.empty()) refuse(faults);
    for (std::string& remark : give_fabrics(envelope, options.project, options.fabric))
        remarks.push_back(std::move(remark));
    add_seams(envelope, {options.seam_tolerance});
    if (options.project) give_seam_types(envelope, *options.project);
    return envelope;
}

}  // namespace

Envelope make_envelope(std::vector<NamedMesh> surfaces, const ReadOptions& options) {
    std::vector<std::string> unheard;
    return make_envelope(std::move(surfaces), options, unheard);
}

EnvelopeInput read_input(const std::filesystem::path& file, const ReadOptions& options) {
    MeshingOptions meshing = options.meshing;
    meshing.sewing_tolerance = options.seam_tolerance;
    if (options.unit) meshing.metres_per_unit = options.unit->metres;
    CadModel model = read_model(file, meshing);
    EnvelopeInput input;
    input.unit_assumed = !options.unit && !model.unit;
    input.unit = options.unit ? *options.unit : model.unit.value_or(LengthUnit{});
    input.remarks = std::move(model.remarks);
    if (options.unit && model.unit && options.unit->metres != model.unit->metres)
        input.remarks.push_back("the file says its unit is " + model.unit->name + ", taken as " + options.unit->name +
                                " as asked");
    if (options.project) name_tiles(model, *options.project);
    const std::vector<std::string> grain_layers =
        options.project ? options.project->grain_layers : std::vector<std::string>();
    keep_layers(model, options.layers, grain_layers);
    require_surfaces(model, input.remarks, file.string());
    for (const UnreadObject& object : model.unread)
        input.remarks.push_back(object.type + " " + object.name + " left out: " + object.reason);
    model = in_metres(std::move(model), input.unit.metres);
    for (std::string& remark : lay_grain_lines(model, grain_layers)) input.remarks.push_back(std::move(remark));
    ReadOptions in_this_unit = options;
    in_this_unit.unit = input.unit;
    input.envelope = make_envelope(std::move(model.surfaces), in_this_unit, input.remarks);
    if (options.project && options.only.empty()) input.unused = unused_entries(*options.project, input.envelope);
    RemeshOptions remesh = options.remesh;
    remesh.seam_tolerance = options.seam_tolerance;
    for (std::string& remark : remesh_envelope(input.envelope, remesh)) input.remarks.push_back(std::move(remark));
    for (std::string& remark : lay_lines(model, input.envelope, grain_layers))
        input.remarks.push_back(std::move(remark));
    if (options.project)
        give_seam_types(input.envelope, *options.project);  // remeshed tiles have seams and chains anew
    return input;
}

Envelope read_envelope(const std::filesystem::path& file, const ReadOptions& options) {
    return read_input(file, options).envelope;
}

}  // namespace ripstop
