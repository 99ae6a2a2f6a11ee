#include "ripstop/pipeline/read/seam_doubts.h"

#include <algorithm>

#include "ripstop/base/index.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/measure/judge_seams.h"
#include "ripstop/tile/find_zigzags.h"

namespace ripstop {
namespace {

bool is_certain(const Seam& seam, double tolerance) {
    return seam.uncertainty <= tolerance * seam.length;
}

Vec3 middle_of(const SeamSide& side, const Tile& tile) {
    return tile.mesh.positions.row(tile.boundary[at(side.parts[side.parts.size() / 2].edge)]);
}

void add_uncertain(EnvelopeCheck& check, Envelope envelope, const RemeshOptions& remesh) {
    const auto certain = [&](const Seam& seam) { return is_certain(seam, remesh.length_tolerance); };
    if (std::all_of(envelope.seams.begin(), envelope.seams.end(), certain)) return;
    remesh_envelope(envelope, remesh);
    for (const Seam& seam : envelope.seams) {
        if (certain(seam)) continue;
        const Tile& a = envelope.tiles[at(seam.a.tile)];
        const Tile& b = envelope.tiles[at(seam.b.tile)];
        check.issues.push_back({"uncertain",
                                uncertain_text(seam, a.name, b.name, remesh.length_tolerance * seam.length),
                                {a.name, b.name},
                                middle_of(seam.a, a),
                                seam.uncertainty});
        if (a.name == b.name) check.issues.back().tiles.pop_back();
    }
}

void add_zigzags(EnvelopeCheck& check, const Envelope& envelope) {
    check.zigzags = find_zigzags(envelope.tiles, envelope.seams);
    if (check.zigzags.empty()) return;
    const Zigzag& worst = *std::max_element(check.zigzags.begin(), check.zigzags.end(),
                                            [](const Zigzag& p, const Zigzag& q) { return p.teeth < q.teeth; });
    const auto in_mm = [](double length) { return format_fixed(length / millimetre, 1) + " mm"; };
    check.notes.push_back(
        "the edge of " + worst.tile_name + (worst.mate.empty() ? std::string() : " along " + worst.mate) +
        worst.seams_text() + " zigzags along its mesh, with teeth up to " + in_mm(worst.teeth) +
        " high: " + in_mm(worst.length) + " of edges represent a curve of " + in_mm(worst.fair_length) +
        (check.zigzags.size() > 1 ? ", and " + std::to_string(check.zigzags.size() - 1) + " more edges like it" : "") +
        "; teeth fold on the cloth, so flatten judges the curve, and cuts along it with --fair-seams");
}

}  // namespace

void add_seam_doubts(EnvelopeCheck& check, const Envelope& envelope, const RemeshOptions& remesh) {
    add_uncertain(check, envelope, remesh);
    add_zigzags(check, envelope);
}

}  // namespace ripstop
