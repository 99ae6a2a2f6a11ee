#include "ripstop/plan_folder/directory.h"

#include <algorithm>
#include <functional>

#include "ripstop/io/json/sewing_json.h"
#include "ripstop/io/mesh/flat_obj.h"
#include "ripstop/io/text/output_file.h"
#include "ripstop/plan_folder/cut_files.h"
#include "ripstop/plan_folder/update_folder.h"
#include "ripstop/report/figures/figures.h"
#include "ripstop/report/json/report_json.h"
#include "ripstop/report/page/html_report.h"
#include "ripstop/report/picture/picture.h"
#include "ripstop/report/picture/png_pictures.h"
#include "ripstop/report/picture/seam_picture.h"
#include "ripstop/report/tables/order.h"
#include "ripstop/report/tables/seam_tables.h"
#include "ripstop/report/tables/tables.h"

namespace ripstop {
namespace {

namespace fs = std::filesystem;

/// The files of a plan's directory; anything else in it belongs to the user.
const std::vector<std::string_view> ours{"report.json", "report.html",      "tiles.csv", "seams.csv", "bom.csv", "flat",
                                         "cut",         "cut-*/envelope.*", "marker",    "pictures",  "inflated"};

void write_all(const fs::path& dir, const CutPlan& plan, const PieceSet& pieces, const WriteOptions& options,
               const std::vector<StrainMap>& strains) {
    fs::create_directory(dir / "flat");
    const std::vector<std::string> stems = file_stems(plan);
    for (std::size_t i = 0; i < plan.tiles.size(); ++i)
        if (plan.tiles[i].is_flat()) write_file(dir / "flat" / (stems[i] + ".obj"), flat_obj(plan.tiles[i]));
    if (std::all_of(plan.tiles.begin(), plan.tiles.end(), std::mem_fn(&FlatTile::is_flat)))
        write_file(dir / "flat" / "sewing.json", sewing_json(plan, stems, options.reproducible));
    write_cut_files(dir / "cut", pieces, options.formats, options.files);
    write_pieces(dir / "cut" / "pieces.json", pieces);
    if (options.pictures || options.png) fs::create_directory(dir / "pictures");
    if (options.png) write_png_pictures(dir / "pictures", plan, pieces.pieces, strains, options.threads);
    if (options.pictures) {
        for (std::size_t i = 0; i < plan.tiles.size(); ++i)
            write_file(dir / "pictures" / (stems[i] + ".svg"),
                       tile_picture(plan.tiles[i], plan.tolerances_of(plan.tiles[i].tile)));
        if (!plan.walks.empty()) write_file(dir / "pictures" / "seams.svg", seam_picture(plan));
    }
    if (plan.inflated) {
        fs::create_directory(dir / "inflated");
        write_inflated_shape(dir / "inflated" / "envelope.obj", plan);
    }
    write_file(dir / "tiles.csv", tiles_csv(plan));
    write_file(dir / "seams.csv", seams_csv(plan));
    const std::string page = html_report(plan, pieces.pieces, strains, report_json(plan, true));
    if (!page.empty()) write_file(dir / "report.html", page);
    write_file(dir / "bom.csv", bom_csv(pieces, nullptr));
    write_file(dir / "report.json", report_json(plan, options.reproducible));
}

}  // namespace

void write_directory(const fs::path& dir, const CutPlan& plan, const PieceSet& pieces, const WriteOptions& options,
                     const std::vector<StrainMap>& strains) {
    write_whole_directory(dir, options.force, ours,
                          [&](const fs::path& partial) { write_all(partial, plan, pieces, options, strains); });
}

}  // namespace ripstop
