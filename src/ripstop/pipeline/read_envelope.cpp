#include "ripstop/pipeline/read_envelope.h"

#include <algorithm>

#include "ripstop/assembly/find_seams.h"
#include "ripstop/base/error.h"
#include "ripstop/base/glob.h"
#include "ripstop/io/mesh_file.h"

namespace ripstop {
namespace {

constexpr std::size_t shown_faults = 20;
constexpr std::size_t shown_names = 10;

bool wanted(const std::string& name, const std::vector<std::string>& only) {
    return only.empty() ||
           std::any_of(only.begin(), only.end(), [&name](const std::string& glob) { return glob_match(glob, name); });
}

/// Every name that was asked for must be there: a mistyped one would silently leave out a part of the job.
void require_wanted(const std::vector<NamedMesh>& surfaces, const std::vector<std::string>& only) {
    for (const std::string& glob : only) {
        const auto fits = [&glob](const NamedMesh& surface) { return glob_match(glob, surface.name); };
        if (std::any_of(surfaces.begin(), surfaces.end(), fits)) continue;
        std::string names;
        for (std::size_t i = 0; i < std::min(surfaces.size(), shown_names); ++i)
            names += (i ? ", " : "") + surfaces[i].name;
        throw InputError("no tile is called \"" + glob + "\"; the input has " + names +
                         (surfaces.size() > shown_names ? ", …" : ""));
    }
}

[[noreturn]] void refuse(const std::vector<std::string>& faults) {
    std::string text;
    for (std::size_t i = 0; i < std::min(faults.size(), shown_faults); ++i) text += (i ? "\n" : "") + faults[i];
    if (faults.size() > shown_faults)
        text += "\nand " + std::to_string(faults.size() - shown_faults) + " more like these";
    throw InputError(text);
}

}  // namespace

Envelope make_envelope(std::vector<NamedMesh> surfaces, const ReadOptions& options) {
    require_wanted(surfaces, options.only);
    Envelope envelope;
    std::vector<std::string> faults;
    for (NamedMesh& surface : surfaces) {
        if (!wanted(surface.name, options.only)) continue;
        TileOptions tile;
        if (options.project) tile = tile_options(*options.project, surface.name, options.metres_per_unit);
        tile.grain_turn = options.grain_turn;
        tile.drawn = std::move(surface.drawn);
        try {
            envelope.tiles.push_back(make_tile(surface.name, std::move(surface.mesh), tile));
        } catch (const InputError& error) {
            faults.emplace_back(error.what());
        }
    }
    if (!faults.empty()) refuse(faults);
    add_seams(envelope, {options.seam_tolerance});
    return envelope;
}

Envelope read_envelope(const std::filesystem::path& file, const ReadOptions& options) {
    return make_envelope(read_meshes(file, options.metres_per_unit), options);
}

}  // namespace ripstop
