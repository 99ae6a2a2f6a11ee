#include "ripstop/report/directory.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <ostream>
#include <string_view>

#include "ripstop/base/error.h"
#include "ripstop/io/dxf.h"
#include "ripstop/io/flat_obj.h"
#include "ripstop/io/svg.h"
#include "ripstop/report/figures.h"
#include "ripstop/report/output_file.h"
#include "ripstop/report/picture.h"
#include "ripstop/report/report_json.h"
#include "ripstop/report/seam_picture.h"
#include "ripstop/report/seam_tables.h"
#include "ripstop/report/tables.h"

namespace ripstop {
namespace {

namespace fs = std::filesystem;

/// What a plan's directory holds; anything else in it is somebody else's.
constexpr std::array<std::string_view, 8> ours{"report.json", "report.html", "tiles.csv", "seams.csv",
                                               "flat",        "cut",         "pictures",  "inflated"};

/// Absolute and without links, so that its parent is where the partial directory can be renamed from.
fs::path resolved(const fs::path& dir) {
    if (dir.empty()) throw InputError("the output directory has no name; give one");
    fs::path path = fs::weakly_canonical(fs::absolute(dir)).lexically_normal();
    if (!path.has_filename()) path = path.parent_path();
    if (!path.has_filename()) throw InputError(dir.string() + ": cannot be the output directory; name one below it");
    return path;
}

/// The stem of each piece's files: that of the tile it is named after.
std::vector<std::string> piece_stems(const CutPlan& plan, const std::vector<PatternPiece>& pieces) {
    const std::vector<std::string> stems = file_stems(plan);
    std::vector<bool> used(stems.size(), false);
    std::vector<std::string> result;
    for (const PatternPiece& piece : pieces) {
        std::size_t i = 0;
        while (i < stems.size() && (used[i] || plan.tiles[i].tile.name != piece.name)) ++i;
        if (i == stems.size()) throw InputError("piece " + piece.name + ": the plan has no tile of that name left");
        used[i] = true;
        result.push_back(stems[i]);
    }
    return result;
}

void write_cut_files(const fs::path& cut, const CutPlan& plan, const std::vector<PatternPiece>& pieces,
                     const std::vector<Vec2>& shifts) {
    fs::create_directories(cut / "tiles");
    write_file(cut / "envelope.dxf", [&](std::ostream& out) { write_dxf(out, pieces, shifts); });
    write_file(cut / "envelope.svg", [&](std::ostream& out) { write_svg(out, pieces, shifts); });
    const std::vector<std::string> stems = piece_stems(plan, pieces);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const std::vector<PatternPiece> piece{pieces[i]};
        const std::vector<Vec2> shift{pieces[i].sew_line.rows() > 0 ? Vec2(-pieces[i].lower()) : Vec2(Vec2::Zero())};
        write_file(cut / "tiles" / (stems[i] + ".dxf"), [&](std::ostream& out) { write_dxf(out, piece, shift); });
        write_file(cut / "tiles" / (stems[i] + ".svg"), [&](std::ostream& out) { write_svg(out, piece, shift); });
    }
}

void write_all(const fs::path& dir, const CutPlan& plan, const std::vector<PatternPiece>& pieces,
               const std::vector<Vec2>& shifts, const DirectoryOptions& options) {
    fs::create_directory(dir);
    fs::create_directory(dir / "flat");
    const std::vector<std::string> stems = file_stems(plan);
    for (std::size_t i = 0; i < plan.tiles.size(); ++i)
        if (is_drawable(plan.tiles[i])) write_file(dir / "flat" / (stems[i] + ".obj"), flat_obj(plan.tiles[i]));
    write_cut_files(dir / "cut", plan, pieces, shifts);
    if (options.pictures) {
        fs::create_directory(dir / "pictures");
        for (std::size_t i = 0; i < plan.tiles.size(); ++i)
            write_file(dir / "pictures" / (stems[i] + ".svg"),
                       tile_picture(plan.tiles[i], plan.tolerances_of(plan.tiles[i].tile)));
        if (!plan.walks.empty()) write_file(dir / "pictures" / "seams.svg", seam_picture(plan));
    }
    write_file(dir / "tiles.csv", tiles_csv(plan));
    write_file(dir / "seams.csv", seams_csv(plan));
    write_file(dir / "report.json", report_json(plan, options.reproducible));
}

/// Puts `fresh` in the place of `dir`. What the old one held besides a plan moves along; only then does it go.
void replace(const fs::path& fresh, const fs::path& dir, const fs::path& aside) {
    if (!fs::exists(dir)) return fs::rename(fresh, dir);
    fs::rename(dir, aside);
    try {
        fs::rename(fresh, dir);
    } catch (const fs::filesystem_error&) {
        fs::rename(aside, dir);
        throw;
    }
    std::vector<fs::path> kept;
    for (const fs::directory_entry& entry : fs::directory_iterator(aside)) kept.push_back(entry.path().filename());
    for (const fs::path& name : kept)
        if (std::find(ours.begin(), ours.end(), name.string()) == ours.end()) fs::rename(aside / name, dir / name);
    fs::remove_all(aside);
}

}  // namespace

void require_writable(const fs::path& dir, bool force) {
    try {
        const fs::path target = resolved(dir);
        if (!fs::is_directory(target.parent_path()))
            throw InputError(dir.string() + ": cannot be written: " + target.parent_path().string() +
                             " is no directory; make it first");
        if (::access(target.parent_path().c_str(), W_OK) != 0)
            throw InputError(dir.string() + ": cannot be written: " + std::generic_category().message(errno) + " (" +
                             target.parent_path().string() + "); choose another place");
        if (!fs::exists(target)) return;
        if (!fs::is_directory(target)) throw InputError(dir.string() + ": is a file, expected a directory or nothing");
        if (!force && !fs::is_empty(target))
            throw InputError(dir.string() + ": is not empty; choose another directory, or replace it with --force");
    } catch (const fs::filesystem_error& error) {
        throw InputError(dir.string() + ": cannot be written: " + error.code().message());
    }
}

void write_directory(const fs::path& dir, const CutPlan& plan, const std::vector<PatternPiece>& pieces,
                     const std::vector<Vec2>& shifts, const DirectoryOptions& options) {
    require_writable(dir, options.force);
    const fs::path target = resolved(dir);
    const std::string id = std::to_string(::getpid());
    const fs::path partial = target.string() + ".partial-" + id;
    const fs::path aside = target.string() + ".old-" + id;
    std::error_code ignored;
    try {
        fs::remove_all(partial);
        write_all(partial, plan, pieces, shifts, options);
        replace(partial, target, aside);
    } catch (const fs::filesystem_error& error) {
        fs::remove_all(partial, ignored);
        throw InputError(dir.string() + ": cannot be written: " + error.code().message() + " (" +
                         error.path1().string() + ")");
    } catch (...) {
        fs::remove_all(partial, ignored);
        throw;
    }
}

}  // namespace ripstop
