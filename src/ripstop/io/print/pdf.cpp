#include "ripstop/io/print/pdf.h"

#include <algorithm>
#include <ostream>

#include "ripstop/base/error.h"
#include "ripstop/io/print/pdf_pages.h"

namespace ripstop {
namespace {

bool is_cut(const PatternPiece& piece) {
    return piece.quantity + piece.quantity_mirrored > 0;
}

PrintRun plan_run(const std::vector<PatternPiece>& pieces, const PrintOptions& options) {
    const Paper paper = paper_named(options.paper);
    PrintRun run{options.style, paper.name};
    if (!options.revision.empty()) run.title += (run.title.empty() ? "revision " : ", revision ") + options.revision;
    if (!options.date.empty()) run.title += (run.title.empty() ? "" : ", ") + options.date;
    if (paper.name == "Letter" || paper.name == "Tabloid") run.cover_size = {0.2159, 0.2794};
    const bool is_any_cut = std::any_of(pieces.begin(), pieces.end(), is_cut);
    for (const PatternPiece& piece : pieces)
        if (is_any_cut && !is_cut(piece)) {
            ++run.equal_pieces;
        } else if (piece.sew_line.rows() > 0) {
            run.pieces.push_back({&piece, make_page_grid(piece, paper)});
            run.pages += static_cast<int>(run.pieces.back().grid.windows.size());
            if (run.pages > most_pages)
                throw InputError("the pieces take more than " + std::to_string(most_pages) + " pages of " + paper.name +
                                 "; print them on larger paper (--paper a0, --paper roll) or fewer of them (--tile)");
        }
    run.pages = cover_pages(run);
    for (PrintedPiece& printed : run.pieces) {
        if (printed.grid.windows.size() > 1) printed.map_page = ++run.pages;
        printed.first_page = run.pages + 1;
        run.pages = printed.last_page();
    }
    return run;
}

}  // namespace

void require_printable(const std::vector<PatternPiece>& pieces, const std::string& paper) {
    PrintOptions options;
    options.paper = paper;
    plan_run(pieces, options);
}

void write_pdf(std::ostream& out, const std::vector<PatternPiece>& pieces, const PrintOptions& options) {
    const PrintRun run = plan_run(pieces, options);
    PdfCanvas canvas(run.title.empty() ? "Cut patterns" : run.title, options.date);
    draw_cover(canvas, run);
    for (const PrintedPiece& printed : run.pieces) {
        if (printed.map_page > 0) draw_map(canvas, run, printed);
        for (std::size_t i = 0; i < printed.grid.windows.size(); ++i) draw_page(canvas, run, printed, i);
    }
    const std::string bytes = canvas.finish();
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace ripstop
