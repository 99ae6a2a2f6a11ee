#include "ripstop/plan_folder/cut_files.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

#include "ripstop/base/error.h"
#include "ripstop/io/json/pieces_json.h"
#include "ripstop/io/text/output_file.h"
#include "ripstop/report/figures/figures.h"

namespace ripstop {
namespace {

namespace fs = std::filesystem;

constexpr double sheet_gap = 0.1;  // [m]

/// The stem of each piece's files: that of its tile.
void name_files(PieceSet& set, const CutPlan& plan) {
    const std::vector<std::string> stems = file_stems(plan);
    std::size_t next = 0;  // pieces stand in the order of their tiles
    for (PatternPiece& piece : set.pieces) {
        while (next < stems.size() && plan.tiles[next].tile.name != piece.name) ++next;
        if (next == stems.size()) throw InputError("piece " + piece.name + ": the plan has no more tiles of that name");
        piece.file = stems[next++];
    }
}

template <class Item>
void add_once(std::vector<Item>& items, const Item& item) {
    const auto same = [&item](const Item& other) { return other.name == item.name; };
    if (std::none_of(items.begin(), items.end(), same)) items.push_back(item);
}

}  // namespace

PieceSet make_piece_set(const CutPlan& plan, std::vector<PatternPiece> pieces, const std::string& revision) {
    PieceSet set{plan.input_file, revision, std::move(pieces), plan.fabrics(), {}};
    name_files(set, plan);
    for (const Seam& seam : plan.seams) add_once(set.seam_types, seam.type);
    for (const FlatTile& tile : plan.tiles)
        for (const Chain& chain : tile.tile.chains) add_once(set.seam_types, chain.finish);
    return set;
}

void write_cut_files(const fs::path& cut, const PieceSet& set, const std::vector<std::string>& formats,
                     PieceFileOptions options) {
    constexpr double one_row = std::numeric_limits<double>::infinity();
    const std::vector<Vec2> shifts = lay_out(set.pieces, sheet_gap, options.frame > 0 ? one_row : 0);
    options.style = set.input;
    options.revision = set.revision;
    fs::create_directories(cut);
    std::vector<PatternPiece> all = set.pieces;
    for (PatternPiece& piece : all) std::erase_if(piece.labels, [](const Label& label) { return label.counts; });
    for (const std::string& name : formats) {
        const PieceFormat& format = piece_format_named(name);
        // an overview draws all pieces if each has its own file, else each pattern once
        const std::vector<PatternPiece>& sheet = format.one_a_piece ? all : set.pieces;
        write_file(cut / ("envelope." + format.extension),
                   [&](std::ostream& out) { format.write(out, sheet, shifts, options); });
        if (!format.one_a_piece) continue;
        fs::create_directories(cut / "tiles");
        for (const PatternPiece& piece : set.pieces)
            write_file(cut / "tiles" / (piece.file + "." + format.extension),
                       [&](std::ostream& out) { format.write(out, {piece}, {-piece.lower()}, options); });
    }
}

void write_pieces(const fs::path& file, const PieceSet& set) {
    write_file(file, pieces_json(set));
}

PieceSet read_pieces_of(const fs::path& directory) {
    const fs::path file = directory / "cut" / "pieces.json";
    std::ifstream in(file, std::ios::binary);
    if (std::error_code unknown; fs::exists(directory, unknown) && !fs::is_directory(directory, unknown))
        throw InputError(directory.string() + ": is a file, expected a folder that `ripstop flatten` wrote; name that");
    if (!in)
        throw InputError(directory.string() +
                         ": no cut plan in it (cut/pieces.json cannot be opened), expected a folder that `ripstop "
                         "flatten` wrote; flatten the envelope first");
    return read_pieces(in, file.string());
}

std::vector<Vec2> lay_out(const std::vector<PatternPiece>& pieces, double gap, double width) {
    double total = 0, widest = 0;
    for (const PatternPiece& piece : pieces) {
        if (piece.sew_line.rows() == 0) continue;
        const Vec2 size = piece.upper() - piece.lower();
        total += (size.x() + gap) * (size.y() + gap);
        widest = std::max(widest, size.x());
    }
    // Rows are not full: a tenth more than the square root gives a roughly square sheet.
    const double sheet_width = std::max(widest, width > 0 ? width : 1.1 * std::sqrt(total));
    std::vector<Vec2> shifts(pieces.size(), Vec2::Zero());
    double x = 0, top = 0, row_height = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (pieces[i].sew_line.rows() == 0) continue;
        const Vec2 lower = pieces[i].lower(), upper = pieces[i].upper();
        if (x > 0 && x + (upper - lower).x() > sheet_width) {
            top -= row_height + gap;
            x = row_height = 0;
        }
        shifts[i] = Vec2(x - lower.x(), top - upper.y());
        x += (upper - lower).x() + gap;
        row_height = std::max(row_height, (upper - lower).y());
    }
    const double bottom = top - row_height;
    for (std::size_t i = 0; i < pieces.size(); ++i)
        if (pieces[i].sew_line.rows() > 0) shifts[i].y() -= bottom;
    return shifts;
}

}  // namespace ripstop
