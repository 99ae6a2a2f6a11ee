/// Cuts a small balloon: pieces with seam allowances and notches, side by side in a DXF that is then read back.
#include <algorithm>
#include <cstdio>
#include <fstream>

#include "ripstop/base/error.h"
#include "ripstop/design/natural/gores.h"
#include "ripstop/io/json/fabric_json.h"
#include "ripstop/io/pattern_file.h"
#include "ripstop/io/piece_format.h"
#include "ripstop/pattern/piece/pieces.h"
#include "ripstop/pipeline/flatten/flatten_envelope.h"
#include "ripstop/pipeline/read/read_envelope.h"
#include "ripstop/plan_folder/cut_files.h"

int main(int count, char** arguments) try {
    using namespace ripstop;
    if (count != 2) return std::fputs("usage: pieces_to_dxf FILE.dxf\n", stderr), 2;
    const EnvelopeDesign design{.gores = 8, .panels = 2, .volume = 30, .edge_length = 0.3};
    const Envelope envelope = make_envelope(design_natural(design), {});
    const CutPlan plan = flatten_envelope(envelope, {.fabric = fabric_named("nylon")});

    const std::vector<PatternPiece> pieces = make_pieces(plan, {.revision = "A"});
    for (const PatternPiece& piece : pieces)
        if (piece.pattern.empty())
            std::printf("%s: cut %d, %d edges, %d notches\n", piece.name.c_str(), piece.quantity,
                        static_cast<int>(piece.edges.size()), static_cast<int>(piece.notches.size()));
    {
        std::ofstream file(arguments[1], std::ios::binary);
        piece_format_named("dxf").write(file, pieces, lay_out(pieces, 0.02), {.style = "balloon", .revision = "A"});
        if (!file.flush()) return std::fprintf(stderr, "%s cannot be written\n", arguments[1]), 3;
    }

    const PatternDrawing drawing = read_pattern_file(arguments[1]);
    const auto cut = std::count_if(drawing.paths.begin(), drawing.paths.end(),
                                   [](const DrawnPath& path) { return path.layer == "CUT" && path.is_closed; });
    std::printf("%s: %s, %d closed cut lines\n", arguments[1], drawing.format.c_str(), static_cast<int>(cut));
    return cut == static_cast<long>(pieces.size()) ? 0 : 1;
} catch (const ripstop::InputError& error) {
    return std::fprintf(stderr, "%s\n", error.what()), 3;
}
