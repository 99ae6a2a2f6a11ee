/// Lays the pieces of a balloon on the roll and writes the marker as SVG.
#include <cstdio>
#include <fstream>

#include "ripstop/base/error.h"
#include "ripstop/design/natural/gores.h"
#include "ripstop/io/json/fabric_json.h"
#include "ripstop/io/piece_format.h"
#include "ripstop/nest/nest_pieces.h"
#include "ripstop/pattern/piece/pieces.h"
#include "ripstop/pipeline/flatten/flatten_envelope.h"
#include "ripstop/pipeline/read/read_envelope.h"
#include "ripstop/plan_folder/cut_files.h"
#include "ripstop/plan_folder/marker_files.h"

int main(int count, char** arguments) try {
    using namespace ripstop;
    if (count != 2) return std::fputs("usage: nest FILE.svg\n", stderr), 2;
    const EnvelopeDesign design{.gores = 8, .panels = 4, .volume = 30, .edge_length = 0.3};
    const Envelope envelope = make_envelope(design_natural(design), {});
    const CutPlan plan = flatten_envelope(envelope, {.fabric = fabric_named("nylon")});
    const PieceSet set = make_piece_set(plan, make_pieces(plan), "A");

    const Markers markers = nest_pieces(set, {.roll_width = 1.6, .gap = 0.01, .rounds = 4, .starts = 1});
    for (const Refusal& refusal : markers.refusals)
        std::printf("%s does not fit: %s\n", refusal.piece.c_str(), refusal.reason.c_str());
    std::size_t laid = 0;
    for (const Marker& marker : markers.markers) {
        std::printf("%s: %.2f m of cloth %.2f m wide, %.1f %% used\n", marker.fabric.c_str(), marker.length,
                    marker.roll_width, 100 * marker.utilisation());
        laid += marker.placements.size();
        std::ofstream file(arguments[1], std::ios::binary);
        const std::vector<PatternPiece> drawn = drawn_marker(set, marker);
        piece_format_named("svg").write(file, drawn, {}, {.style = "balloon", .revision = set.revision});
    }
    std::printf("%d of %d pieces laid\n", static_cast<int>(laid), static_cast<int>(plan.tiles.size()));
    return laid == plan.tiles.size() ? 0 : 1;
} catch (const ripstop::InputError& error) {
    return std::fprintf(stderr, "%s\n", error.what()), 3;
}
