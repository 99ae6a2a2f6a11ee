#include "ripstop/io/dxf/dxf.h"

#include "ripstop/base/error.h"
#include "ripstop/io/dxf/dxf_blocks.h"
#include "ripstop/io/dxf/dxf_dialect.h"
#include "ripstop/io/dxf/dxf_entities.h"
#include "ripstop/io/dxf/moved_piece.h"
#include "ripstop/io/text/sheet.h"

namespace ripstop {
namespace {

/// The pieces at their places in the drawing, and the sheet they cover.
struct Placing {
    std::vector<PatternPiece> pieces;
    Sheet sheet;
};

Placing place(const std::vector<PatternPiece>& pieces, const std::vector<Vec2>& shifts, bool turned) {
    Placing placing{{}, make_sheet(pieces, shifts)};
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Vec2 shift = placing.sheet.shifts[i];
        placing.pieces.push_back(moved_piece(pieces[i], turned ? Vec2(-shift.y(), shift.x()) : shift, turned));
    }
    if (!turned) return placing;
    const Vec2 back = placing.sheet.lower - make_sheet(placing.pieces, {}).lower;
    for (PatternPiece& piece : placing.pieces) piece = moved_piece(std::move(piece), back);
    placing.sheet = make_sheet(placing.pieces, {});
    return placing;
}

/// The upper corner of the drawing. It includes the reference square only if the dialect draws one.
Vec2 upper_corner(const DxfDialect& dialect, const Placing& placing) {
    if (!dialect.blocks || placing.pieces.empty()) return placing.sheet.upper;
    Vec2 upper = placing.sheet.lower;
    for (const PatternPiece& piece : placing.pieces)
        if (piece.outline().rows() > 0) upper = upper.cwiseMax(piece.upper());
    return upper;
}

void write_header(DxfEntities& out, const DxfDialect& dialect, const Placing& placing) {
    out.begin("HEADER");
    if (!dialect.release.empty()) {
        out.variable("$ACADVER");
        out.pair(1, dialect.release);
        if (dialect.states_insunits) {
            out.variable("$INSUNITS");
            out.pair(70, 4);
            out.variable("$MEASUREMENT");
            out.pair(70, 1);
        }
        if (dialect.blocks) {
            out.variable("$INSBASE");
            out.point(10, Vec2::Zero());
        }
        out.variable("$EXTMIN");
        out.point(10, placing.sheet.lower);
        out.variable("$EXTMAX");
        out.point(10, upper_corner(dialect, placing));
    }
    out.end();
}

void draw_contours(DxfEntities& out, const PatternPiece& piece) {
    out.polyline("CUT", piece.cut_line, true);
    out.polyline("SEW", piece.sew_line, true);
    draw_slits(out, "NOTCH", piece);
    for (const DrawnLine& line : piece.lines) out.polyline("INTERNAL", line.points, false);
    draw_grain_arrow(out, "GRAIN", piece);
    for (const Label& label : piece.labels) out.centred_text("TEXT", label);
}

void write_contours(DxfEntities& out, const Placing& placing) {
    out.begin("ENTITIES");
    for (const PatternPiece& piece : placing.pieces) draw_contours(out, piece);
    constexpr double side = Sheet::square_side;
    const Vec2 corner = placing.sheet.square;
    Points2 square(4, 2);
    square << 0, 0, side, 0, side, side, 0, side;
    square.rowwise() += corner.transpose();
    out.polyline("REF", square, true);
    out.centred_text("REF", {"100 mm", corner + Vec2(side / 2, side / 2), 0.01, 0});
    out.centred_text("REF", {"Units: METRIC", corner + Vec2(side / 2, side / 4), 0.005, 0});
    out.end();
}

bool runs_grain_up(const DxfDialect& dialect, const std::string& axis) {
    if (axis.empty()) return dialect.grain_up;
    if (axis != "x" && axis != "y") throw InputError("no grain axis \"" + axis + "\", expected x or y");
    return axis == "y";
}

}  // namespace

void write_dxf(std::ostream& out, const std::vector<PatternPiece>& pieces, const std::vector<Vec2>& shifts,
               const DxfOptions& options) {
    const DxfDialect& dialect = dxf_dialect_named(options.dialect);
    const Placing placing = place(pieces, shifts, runs_grain_up(dialect, options.grain_axis));
    const std::vector<DxfLayer> named{{"CUT", 1},  {"SEW", 3},      {"NOTCH", 6}, {"GRAIN", 5},
                                      {"TEXT", 7}, {"INTERNAL", 4}, {"REF", 8}};
    DxfEntities entities(out);
    if (!dialect.comment.empty()) entities.pair(999, dialect.comment);
    write_header(entities, dialect, placing);
    if (dialect.tables) entities.tables(dialect.blocks ? numbered_layers() : named);
    if (dialect.blocks)
        write_blocks(entities, dialect, placing.pieces, placing.sheet.lower, options);
    else
        write_contours(entities, placing);
    entities.pair(0, "EOF");
}

}  // namespace ripstop
