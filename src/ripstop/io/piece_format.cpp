#include "ripstop/io/piece_format.h"

#include <array>

#include "ripstop/base/error.h"
#include "ripstop/io/dxf/dxf.h"
#include "ripstop/io/print/hpgl.h"
#include "ripstop/io/print/pdf.h"
#include "ripstop/io/svg/svg.h"

namespace ripstop {

std::span<const PieceFormat> piece_formats() {
    static const std::array formats{
        PieceFormat{"dxf", "dxf", "DXF for cutters and CAD", true,
                    [](std::ostream& out, const std::vector<PatternPiece>& pieces, const std::vector<Vec2>& shifts,
                       const PieceFileOptions& options) {
                        write_dxf(out, pieces, shifts,
                                  {options.dialect, options.style, options.revision, options.date, options.grain_axis});
                    }},
        PieceFormat{"svg", "svg", "SVG at true size, one path per edge", true,
                    [](std::ostream& out, const std::vector<PatternPiece>& pieces, const std::vector<Vec2>& shifts,
                       const PieceFileOptions&) { write_svg(out, pieces, shifts); }},
        PieceFormat{"pdf", "pdf", "PDF at true size for printers, one page per piece or on sheets (--paper)", false,
                    [](std::ostream& out, const std::vector<PatternPiece>& pieces, const std::vector<Vec2>&,
                       const PieceFileOptions& options) {
                        write_pdf(out, pieces, {options.style, options.revision, options.paper, options.date});
                    }},
        PieceFormat{"hpgl", "plt", "HPGL for plotters and cutters: pen 1 draws, 2 cuts, 3 notches (--frame)", true,
                    [](std::ostream& out, const std::vector<PatternPiece>& pieces, const std::vector<Vec2>& shifts,
                       const PieceFileOptions& options) { write_hpgl(out, pieces, shifts, {options.frame}); }},
    };
    return formats;
}

const PieceFormat& piece_format_named(const std::string& name) {
    std::string known;
    for (const PieceFormat& format : piece_formats()) {
        if (format.name == name) return format;
        known += (known.empty() ? "" : ", ") + format.name;
    }
    throw InputError("no format \"" + name + "\" for pieces; known: " + known);
}

}  // namespace ripstop
