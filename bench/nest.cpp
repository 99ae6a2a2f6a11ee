/// Compares nesting on the roll by Ripstop and by libnest2d: pieces like parts of gores, and those of cut plans.
///     ripstop-bench-nest [PLAN ...]
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <string>

#include "ripstop/geometry/polygon.h"
#include "ripstop/geometry/predicates.h"
#include "ripstop/nest/nest_pieces.h"
#include "ripstop/plan_folder/cut_files.h"
#include "support/loose_pieces.h"
#ifdef RIPSTOP_LIBNEST2D
#include "libnest2d_strip.h"
#endif

namespace ripstop {
namespace {

constexpr double gap = 0.005;

struct Row {
    std::string set, who;
    std::size_t pieces;
    double utilisation, length, seconds, processor_seconds;
};

void print(const Row& row) {
    fmt::print("| {} | {} | {} | {:.1f} % | {:.1f} m | {:.1f} s | {:.1f} s |\n", row.set, row.pieces, row.who,
               100 * row.utilisation, row.length, row.seconds, row.processor_seconds);
    std::fflush(stdout);
}

/// Calls `task` and records its wall and processor seconds.
template <class Task>
void timed(Row& row, Task&& task) {
    const std::clock_t processor = std::clock();
    const auto start = std::chrono::steady_clock::now();
    task();
    row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    row.processor_seconds = static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC;
}

void lay(const std::string& name, const PieceSet& set, int rounds) {
    NestOptions options;
    options.gap = gap;
    options.rounds = rounds;
    Row row{name, fmt::format("ripstop, effort {}", rounds), 0, 0, 0, 0, 0};
    Markers markers;
    timed(row, [&] { markers = nest_pieces(set, options); });
    const Marker& marker = markers.markers.at(0);
    row.pieces = marker.placements.size();
    row.utilisation = marker.utilisation();
    row.length = marker.length;
    print(row);
    const std::string faults = testing::faults_of(set, markers, gap);
    if (!faults.empty()) fmt::print("FAULTS {}\n", faults);
}

#ifdef RIPSTOP_LIBNEST2D
/// libnest2d's no-fit polygons are those of convex pieces; it lets concave ones overlap.
PlainOutline convex_hull(const Points2& outline) {
    std::vector<Vec2> points;
    for (Eigen::Index i = 0; i < outline.rows(); ++i) points.push_back(outline.row(i));
    std::sort(points.begin(), points.end(),
              [](const Vec2& a, const Vec2& b) { return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y()); });
    std::vector<Vec2> hull;
    for (int side = 0; side < 2; ++side) {
        const std::size_t start = hull.size();
        for (const Vec2& point : points) {
            while (hull.size() >= start + 2 && orient2d(hull[hull.size() - 2], hull.back(), point) <= 0)
                hull.pop_back();
            hull.push_back(point);
        }
        hull.pop_back();
        std::reverse(points.begin(), points.end());
    }
    PlainOutline plain;
    for (const Vec2& point : hull) plain.push_back({point.x(), point.y()});
    return plain;
}

void lay_with_other(const std::string& name, const PieceSet& set, double accuracy) {
    std::vector<PlainOutline> outlines;
    std::vector<double> areas;
    const double width = set.fabrics.at(0).roll_width;
    for (const PatternPiece& piece : set.pieces)
        for (int copy = 0; copy < piece.quantity; ++copy) {
            const Points2& outline = piece.outline();
            if (outline.col(1).maxCoeff() - outline.col(1).minCoeff() > width) continue;
            outlines.push_back(convex_hull(outline));
            areas.push_back(signed_area(outline));
        }
    Row row{name, fmt::format("libnest2d, accuracy {}", accuracy), 0, 0, 0, 0, 0};
    StripResult result;
    timed(row, [&] { result = lay_with_libnest2d(outlines, width, gap, accuracy); });
    row.length = result.length;
    for (std::size_t i = 0; i < outlines.size(); ++i) {
        if (!result.is_laid[i]) continue;
        ++row.pieces;
        row.utilisation += areas[i] / (width * row.length);
    }
    print(row);
}
#endif

void run(const std::string& name, const PieceSet& set) {
    for (const int rounds : {10, 40, 200}) lay(name, set, rounds);
#ifdef RIPSTOP_LIBNEST2D
    lay_with_other(name, set, 0.2);
#endif
}

}  // namespace
}  // namespace ripstop

int main(int argc, char** argv) {
    using namespace ripstop;
    fmt::print("| pieces | laid | by | used | cloth | wall | processor |\n|---|---|---|---|---|---|---|\n");
    run("like parts of gores", testing::loose_set(testing::gore_like_pieces(200)));
    for (int i = 1; i < argc; ++i) run(argv[i], read_pieces_of(argv[i]));
}
