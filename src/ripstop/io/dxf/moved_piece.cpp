#include "ripstop/io/dxf/moved_piece.h"

#include <numbers>

namespace ripstop {
namespace {

Vec2 quarter(const Vec2& p) {
    return {-p.y(), p.x()};
}

void place(Points2& points, const Vec2& shift, bool turned) {
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        const Vec2 p = points.row(i);
        points.row(i) = (turned ? quarter(p) : p) + shift;
    }
}

}  // namespace

PatternPiece moved_piece(PatternPiece piece, const Vec2& shift, bool turned) {
    place(piece.sew_line, shift, turned);
    place(piece.cut_line, shift, turned);
    place(piece.grain_line, shift, turned);
    for (DrawnLine& line : piece.lines) place(line.points, shift, turned);
    for (PieceNotch& notch : piece.notches) {
        if (turned) {
            notch.on_sew = quarter(notch.on_sew);
            notch.outward = quarter(notch.outward);
        }
        notch.on_sew += shift;
    }
    for (MetAllowances& met : piece.met) met.at = (turned ? quarter(met.at) : met.at) + shift;
    for (Label& label : piece.labels) {
        label.middle = (turned ? quarter(label.middle) : label.middle) + shift;
        if (turned) label.turn += std::numbers::pi / 2;
    }
    return piece;
}

}  // namespace ripstop
