#include "ripstop/pipeline/read/tile_fabrics.h"

#include <filesystem>
#include <map>

#include "ripstop/base/error.h"
#include "ripstop/io/json/fabric_json.h"
#include "ripstop/io/text/text.h"

namespace ripstop {
namespace {

/// The fabrics by their names in the project, each looked up once.
class Shelf {
  public:
    explicit Shelf(const std::optional<Project>& project) : project_(project) {}

    const Fabric& named(const std::string& name) {
        const auto [entry, is_new] = fabrics_.try_emplace(name);
        if (is_new) try {
                entry->second = find(name);
            } catch (const InputError&) {
                fabrics_.erase(entry);
                throw;
            }
        return entry->second;
    }

    /// Looks up a fabric named in the project; an error says where.
    const Fabric& named_by_project(const std::string& name, const std::string& place) try {
        return named(name);
    } catch (const InputError& error) {
        throw InputError(project_->file + ": " + place + ": " + error.what());
    }

  private:
    Fabric find(const std::string& name) const {
        if (!project_) return fabric_named(name);
        const std::filesystem::path beside = std::filesystem::path(project_->file).parent_path() / name;
        std::error_code unknown;
        return fabric_named(std::filesystem::is_regular_file(beside, unknown) ? beside.string() : name);
    }

    const std::optional<Project>& project_;
    std::map<std::string, Fabric> fabrics_;
};

std::optional<std::string> attribute(const Tile& tile, const char* key) {
    const auto found = tile.attributes.find(key);
    return found == tile.attributes.end() ? std::nullopt : std::optional(found->second);
}

/// Looks up every name of the project, so a mistyped one is refused even if no tile uses it.
void require_fabrics(const Project& project, Shelf& shelf) {
    for (const ProjectTile& entry : project.tiles)
        if (entry.fabric) shelf.named_by_project(*entry.fabric, "tile " + shown(entry.name) + ": fabric");
    for (const auto& [material, fabric] : project.materials)
        shelf.named_by_project(fabric, "materials: " + shown(material));
}

/// The fabric named for a tile, and whether only the file names it.
struct Said {
    std::string name;
    bool by_file = false;
};

std::optional<Said> said_of(const Tile& tile, const std::optional<Project>& project) {
    const auto mapped = [&](const std::string& word) -> std::optional<Said> {
        if (!project) return std::nullopt;
        const auto found = project->materials.find(word);
        return found == project->materials.end() ? std::nullopt : std::optional(Said{found->second});
    };
    if (project)
        if (const ProjectTile* entry = deciding_entry(project->tiles, tile.name,
                                                      [](const ProjectTile& one) { return one.fabric.has_value(); }))
            return Said{*entry->fabric};
    if (const std::optional<std::string> word = attribute(tile, "fabric")) {
        const std::optional<Said> said = mapped(*word);
        return said ? said : Said{*word, true};
    }
    const std::optional<std::string> material = attribute(tile, "material");
    return material ? mapped(*material) : std::nullopt;
}

}  // namespace

Fabric envelope_fabric(const std::string& named, const std::optional<Project>& project) {
    if (!named.empty()) return fabric_named(named);
    if (!project || !project->fabric) return fabric_named("isotropic");
    return Shelf(project).named_by_project(*project->fabric, "fabric");
}

std::vector<std::string> give_fabrics(Envelope& envelope, const std::optional<Project>& project,
                                      const Fabric& standard) {
    Shelf shelf(project);
    if (project) require_fabrics(*project, shelf);
    std::map<std::string, std::vector<std::string>> unknown;  // the tiles of each fabric
    for (Tile& tile : envelope.tiles) {
        const std::optional<Said> said = said_of(tile, project);
        if (!said) continue;
        if (said->by_file && unknown.count(said->name) > 0) {
            unknown[said->name].push_back(tile.name);
            continue;
        }
        try {
            const Fabric& fabric = shelf.named(said->name);
            if (!(fabric == standard)) tile.fabric = fabric;
        } catch (const InputError&) {
            if (!said->by_file) throw;
            unknown[said->name].push_back(tile.name);
        }
    }
    std::vector<std::string> remarks;
    for (const auto& [name, tiles] : unknown)
        remarks.push_back("tile " + tiles.front() +
                          (tiles.size() > 1 ? " and " + std::to_string(tiles.size() - 1) + " more" : "") +
                          " should have the fabric " + shown(name) + ", which is unknown; " + standard.name +
                          " is used instead; define it under \"materials\" in a project file");
    return remarks;
}

}  // namespace ripstop
