#include "ripstop/plan_folder/inflated_files.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "ripstop/base/error.h"
#include "ripstop/base/system/folder_lock.h"
#include "ripstop/io/mesh/mesh_file.h"
#include "ripstop/io/text/output_file.h"
#include "ripstop/plan_folder/cut_files.h"
#include "ripstop/report/json/report_json.h"
#include "ripstop/report/page/html_report.h"

namespace ripstop {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string text_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in)
        throw InputError(file.string() + ": cannot be read, expected it in a cut plan; flatten the envelope again");
    return text.str();
}

/// Takes the keys of flight from the entries of one list into those of another.
void take_keys(const Json& from, Json& into, const char* list, std::initializer_list<const char*> keys,
               const std::string& name) {
    if (!into.contains(list) || into[list].size() != from[list].size())
        throw InputError(name + ": has other " + list + " than flat/sewing.json beside it; flatten the envelope again");
    for (std::size_t i = 0; i < from[list].size(); ++i)
        for (const char* key : keys) {
            into[list][i].erase(key);
            if (from[list][i].contains(key)) into[list][i][key] = from[list][i][key];
        }
}

std::string inflated_report(const std::string& report, const CutPlan& plan, const std::string& name,
                            bool reproducible) {
    Json whole = Json::parse(report, nullptr, false);
    if (!whole.is_object()) throw InputError(name + ": is no report.json; flatten the envelope again");
    const Json fresh = Json::parse(report_json(plan, reproducible));
    take_keys(fresh, whole, "tiles", {"inflated"}, name);
    take_keys(fresh, whole, "seams", {"type", "tape_cut_mm", "tape_force_max_n"}, name);
    whole["seam_types"] = fresh["seam_types"];
    const Json before = whole.value("inflated", Json::object());
    whole["inflated"] = fresh["inflated"];
    // How the patterns were corrected stays true however they are inflated.
    const Json none = Json::array();
    if (fresh["inflated"].value("rounds", none).empty() && !before.value("rounds", none).empty())
        whole["inflated"]["rounds"] = before["rounds"];
    return whole.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string report_of(const fs::path& folder) {
    return text_of(folder / "report.json");
}

void write_inflated_shape(const fs::path& file, const CutPlan& plan) {
    std::vector<NamedMesh> tiles;
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        const Tile& tile = plan.tiles[i].tile;
        tiles.push_back({tile.name, {plan.inflated->tiles[i].positions, tile.mesh.triangles}});
    }
    replace_file(file, [&](std::ostream& out) { write_model(out, file, tiles); });
}

void write_inflated(const fs::path& folder, const CutPlan& plan, const std::vector<StrainMap>& strains,
                    bool reproducible) {
    const FolderLock turn(folder);
    const fs::path file = folder / "report.json", page = folder / "report.html";
    const std::string before = text_of(file);
    const std::string report = inflated_report(before, plan, file.string(), reproducible);
    std::string html =
        html_report(plan, read_pieces_of(folder).pieces, strains, inflated_report(before, plan, file.string(), true));
    std::ifstream marker(folder / "marker" / "marker.json", std::ios::binary);
    if (marker) {
        std::ostringstream text;
        text << marker.rdbuf();
        html = with_roll(html, text.str());
    }
    fs::create_directory(folder / "inflated");
    write_inflated_shape(folder / "inflated" / "envelope.obj", plan);
    if (!html.empty()) replace_file(page, html);
    replace_file(file, report);
}

}  // namespace ripstop
