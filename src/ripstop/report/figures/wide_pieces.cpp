#include "ripstop/report/figures/wide_pieces.h"

#include <fmt/format.h>

#include "ripstop/base/text/units.h"

namespace ripstop {
namespace {

constexpr double rounding = 1e-9;  ///< [m]

double width_of(const PatternPiece& piece) {
    return piece.upper().y() - piece.lower().y();
}

/// The number of pieces that are too wide, of those that are cut, mirror images included.
struct Wide {
    int pieces = 0, of = 0;
    const PatternPiece* widest = nullptr;
};

Wide wide_pieces(const PieceSet& set, const Fabric& fabric) {
    Wide wide;
    for (const PatternPiece& piece : set.pieces) {
        if (set.fabric(piece.fabric).name != fabric.name || piece.outline().rows() == 0) continue;
        const int cut = piece.quantity + piece.quantity_mirrored;
        wide.of += cut;
        if (cut == 0 || width_of(piece) <= fabric.roll_width + rounding) continue;
        wide.pieces += cut;
        if (!wide.widest || width_of(piece) > width_of(*wide.widest)) wide.widest = &piece;
    }
    return wide;
}

}  // namespace

std::vector<std::string> too_wide_pieces(const PieceSet& set) {
    std::vector<std::string> sentences;
    for (const Fabric& fabric : set.fabrics) {
        const Wide wide = wide_pieces(set, fabric);
        if (!wide.widest) continue;
        const bool is_one = wide.pieces == 1;
        sentences.push_back(
            fmt::format("{} of {} {} wider across the warp than the roll of {}, {:.0f} mm; the widest is {}, {:.0f} "
                        "mm. {}, or take a "
                        "wider roll",
                        wide.pieces, wide.of, is_one ? "pieces is" : "pieces are", fabric.name,
                        fabric.roll_width / millimetre, wide.widest->name, width_of(*wide.widest) / millimetre,
                        is_one ? "Divide it, turn its grain" : "Divide them, turn their grain"));
    }
    return sentences;
}

}  // namespace ripstop
