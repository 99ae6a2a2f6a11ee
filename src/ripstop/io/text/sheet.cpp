#include "ripstop/io/text/sheet.h"

#include "ripstop/base/error.h"

namespace ripstop {
namespace {

/// The points that bound what is cut; if there is no outline, those of the drawn lines.
Points2 extent(const PatternPiece& piece) {
    if (piece.sew_line.rows() > 0) return piece.outline();
    Points2 points(0, 2);
    for (const DrawnLine& line : piece.lines) {
        points.conservativeResize(points.rows() + line.points.rows(), 2);
        points.bottomRows(line.points.rows()) = line.points;
    }
    return points;
}

}  // namespace

Sheet make_sheet(const std::vector<PatternPiece>& pieces, const std::vector<Vec2>& shifts) {
    if (!shifts.empty() && shifts.size() != pieces.size())
        throw InputError("a drawing of " + std::to_string(pieces.size()) + " pieces got " +
                         std::to_string(shifts.size()) + " shifts; give one per piece or none");
    Sheet sheet;
    sheet.shifts = shifts.empty() ? std::vector<Vec2>(pieces.size(), Vec2::Zero()) : shifts;
    bool any = false;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Points2 points = extent(pieces[i]);
        if (points.rows() == 0) continue;
        const Vec2 lower = Vec2(points.colwise().minCoeff()) + sheet.shifts[i];
        const Vec2 upper = Vec2(points.colwise().maxCoeff()) + sheet.shifts[i];
        sheet.lower = any ? Vec2(sheet.lower.cwiseMin(lower)) : lower;
        sheet.upper = any ? Vec2(sheet.upper.cwiseMax(upper)) : upper;
        any = true;
    }
    sheet.square = Vec2(sheet.upper.x() + 0.02, sheet.lower.y());
    sheet.upper = sheet.upper.cwiseMax(sheet.square + Vec2::Constant(Sheet::square_side));
    return sheet;
}

Points2 grain_arrow(const PatternPiece& piece) {
    if (piece.grain_line.rows() != 2) return Points2(0, 2);
    const Vec2 tail = piece.grain_line.row(0), head = piece.grain_line.row(1);
    const double length = (head - tail).norm();
    if (length == 0) return Points2(0, 2);
    const Vec2 along = (head - tail) / length;
    const Vec2 across(-along.y(), along.x());
    const Vec2 neck = head - arrow_head(length) * along;
    Points2 arrow(4, 2);
    arrow.row(0) = tail.transpose();
    arrow.row(1) = head.transpose();
    arrow.row(2) = (neck + arrow_half_width(length) * across).transpose();
    arrow.row(3) = (neck - arrow_half_width(length) * across).transpose();
    return arrow;
}

}  // namespace ripstop
