#include "ripstop/plan_folder/update_folder.h"

#include <fstream>
#include <optional>
#include <sstream>

#include "ripstop/base/error.h"
#include "ripstop/io/mesh/mesh_file.h"
#include "ripstop/io/text/output_file.h"
#include "ripstop/plan_folder/whole_directory.h"
#include "ripstop/report/json/report_json.h"
#include "ripstop/report/page/html_report.h"

namespace ripstop {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in)
        throw InputError(file.string() + ": cannot be read, but every cut plan has it; flatten the envelope again");
    return text.str();
}

/// Empty if the folder has no page, or one from another version.
std::optional<PageParts> page_of(const fs::path& folder) {
    const fs::path file = folder / "report.html";
    return fs::exists(file) ? read_page(text_of(file)) : std::nullopt;
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

void write_inflated(const fs::path& folder, const CutPlan& plan, const std::vector<PatternPiece>& pieces,
                    const std::vector<StrainMap>& strains, const Unchanged& read, bool reproducible) {
    PageParts page = page_parts(plan, pieces, strains, report_json(plan, true));
    const Unchanged roll({folder / "report.html"});
    if (const std::optional<PageParts> before = page_of(folder)) page.roll = before->roll;
    const auto write = [&](const fs::path& partial) {
        fs::create_directory(partial / "inflated");
        write_inflated_shape(partial / "inflated" / "envelope.obj", plan);
        if (const std::string text = write_page(page); !text.empty()) write_file(partial / "report.html", text);
        write_file(partial / "report.json", report_json(plan, reproducible));
    };
    write_whole_directory(folder, true, {}, write, [&] {
        read.require();
        roll.require();
    });
}

bool show_roll(const fs::path& folder, const std::string& marker_json, const Unchanged& read) {
    if (!fs::exists(folder / "report.html")) return true;
    const Unchanged before({folder / "report.html"});
    std::optional<PageParts> page = page_of(folder);
    if (!page) return false;
    set_roll(*page, marker_json);
    const auto write = [&](const fs::path& partial) { write_file(partial / "report.html", write_page(*page)); };
    write_whole_directory(folder, true, {}, write, [&] {
        read.require();
        before.require();
    });
    return true;
}

}  // namespace ripstop
