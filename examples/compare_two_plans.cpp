/// Compares two cut plans piece by piece: what must be cut again.
#include <cstdio>

#include "ripstop/base/error.h"
#include "ripstop/base/text/units.h"
#include "ripstop/pattern/revision/compare_pieces.h"
#include "ripstop/pipeline/plan.h"
#include "ripstop/report/words/revision_report.h"

int main(int count, char** arguments) try {
    using namespace ripstop;
    if (count != 3) return std::fputs("usage: compare_two_plans FOLDER FOLDER\n", stderr), 2;
    const Plan before = read_plan(arguments[1]), after = read_plan(arguments[2]);
    const double tolerance = 0.1 * millimetre;
    const std::vector<PieceChange> changes = compare_pieces(before.pieces, after.pieces, tolerance);
    std::printf("%s", revision_text(changes, compare_seam_types(before.pieces, after.pieces, tolerance)).c_str());
    std::printf("%.2f m2 before, %.2f m2 after; %d pieces differ by more than %.1f mm\n", before.cut.area(),
                after.cut.area(), static_cast<int>(changes.size()), tolerance / millimetre);
    return compare_pieces(after.pieces, after.pieces, tolerance).empty() ? 0 : 1;  // a plan is like itself
} catch (const ripstop::InputError& error) {
    return std::fprintf(stderr, "%s\n", error.what()), 3;
}
