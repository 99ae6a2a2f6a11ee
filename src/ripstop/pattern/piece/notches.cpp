#include "ripstop/pattern/piece/notches.h"

#include <algorithm>
#include <cmath>

#include "ripstop/geometry/triangle.h"
#include "ripstop/pattern/piece/pieces.h"
#include "ripstop/tile/seam_place.h"
#include "ripstop/tile/seam_sheets.h"

namespace ripstop {
namespace {

constexpr int curve_samples = 256;    // of a seam's curve, for spreading its marks
constexpr double room_for_two = 0.2;  // a shorter seam gets one mark [m]
constexpr double lone_mark = 0.4;     // its place, as a share of the seam's length
constexpr double depth_of_allowance = 0.4;
constexpr double coincident_marks = 1e-3;  // marks closer than this coincide [m]

/// The curvature of a side on the cloth, as a step function of the distance from the seam's start.
struct Bends {
    std::vector<double> until, curvature;

    double at(double along) const {
        const auto i = std::upper_bound(until.begin(), until.end() - 1, along) - until.begin();
        return curvature[static_cast<std::size_t>(i)];
    }
};

/// Half the sum of the turns at both ends of an edge, divided by its length.
double curvature_of_edge(const FlatTile& tile, int edge) {
    const std::size_t n = tile.tile.boundary.size(), i = static_cast<std::size_t>(edge);
    const auto point = [&](std::size_t k) { return Vec2(tile.flattening.positions.row(tile.tile.boundary[k % n])); };
    const Vec2 before = point(i) - point(i + n - 1), here = point(i + 1) - point(i),
               after = point(i + 2) - point(i + 1);
    const auto turn = [](const Vec2& u, const Vec2& v) { return std::abs(std::atan2(cross(u, v), u.dot(v))); };
    constexpr double corner = 0.5;  // [rad]: a larger turn is a corner and no curvature
    const double first = turn(before, here), last = turn(here, after);
    return ((first < corner ? first : 0) + (last < corner ? last : 0)) / 2 / here.norm();
}

Bends bends_of(const std::vector<FlatTile>& tiles, const Seam& seam, bool second) {
    const SeamSide& side = second ? seam.b : seam.a;
    const FlatTile& tile = tiles[static_cast<std::size_t>(side.tile)];
    std::vector<SeamPart> parts = side.parts;
    if (second) std::reverse(parts.begin(), parts.end());
    Bends bends;
    double walked = 0;
    for (const SeamPart& part : parts) {
        bends.until.push_back(walked += part.length);
        bends.curvature.push_back(tile.is_flat() ? curvature_of_edge(tile, part.edge) : 0);
    }
    return bends;
}

/// Collects the notches of one tile, one for each place.
class Collector {
  public:
    Collector(const FlatTile& tile, const PieceOutline& outline, double depth)
        : tile_(tile), outline_(outline), depth_(depth) {}

    bool takes_notches() const { return !outline_.edges.empty(); }

    void add(const Seam& seam, const BoundaryPlace& place, const SeamMark& mark) {
        PieceNotch notch;
        notch.edge = outline_.edge_of[static_cast<std::size_t>(place.edge)];
        notch.seam = seam.id;
        notch.along = mark.along;
        notch.count = mark.count;
        notch.on_sew = flat_point(tile_, place);
        const Vec2 way = (flat_point(tile_, {place.edge, 1}) - flat_point(tile_, {place.edge, 0})).normalized();
        notch.outward = Vec2(way.y(), -way.x());
        notch.reach = outline_.edges[static_cast<std::size_t>(notch.edge)].allowance;
        notch.depth = std::min(depth_, depth_of_allowance * notch.reach);
        for (PieceNotch& other : notches) {
            if ((other.on_sew - notch.on_sew).norm() >= coincident_marks) continue;
            if (notch.reach < other.reach)
                other = std::move(notch);  // the cut line steps here; the shorter one is inside both
            return;
        }
        notches.push_back(std::move(notch));
    }

    /// Adds a notch at the end of a seam if the edge continues there.
    void add_end(const SeamSide& side, const Seam& seam, const BoundaryPlace& place, double along) {
        const Chain& chain = tile_.tile.chains[static_cast<std::size_t>(side.chain)];
        if (tile_.tile.chains.size() == 1 && side.parts.size() == tile_.tile.boundary.size()) return;
        const Vec2 at = flat_point(tile_, place);
        for (const int corner : {chain.vertices.front(), chain.vertices.back()})
            if (tile_.tile.chains.size() > 1 &&
                (Vec2(tile_.flattening.positions.row(corner)) - at).norm() < coincident_marks)
                return;
        add(seam, place, {along, 1});
    }

    std::vector<PieceNotch> notches;

  private:
    const FlatTile& tile_;
    const PieceOutline& outline_;
    double depth_;
};

}  // namespace

std::vector<SeamMark> seam_marks(const std::vector<FlatTile>& tiles, const Seam& seam, const NotchOptions& options,
                                 MarkDirection direction) {
    if (seam.length < options.shortest_seam) return {};
    if (seam.length < room_for_two) {
        const double share = direction == MarkDirection::from_start ? lone_mark
                             : direction == MarkDirection::from_end ? 1 - lone_mark
                                                                    : 0.5;
        return {{share * seam.length, 1}};
    }
    const Bends a = bends_of(tiles, seam, false), b = bends_of(tiles, seam, true);
    std::vector<double> run(curve_samples + 1, 0);  // the integral of ds / h up to each sample
    for (int i = 0; i < curve_samples; ++i) {
        const double s = seam.length * (i + 0.5) / curve_samples;
        const double curvature = std::max({a.at(s), b.at(s), 1e-9});
        const double spacing = std::clamp(options.turn / curvature, options.curved_spacing, options.straight_spacing);
        run[static_cast<std::size_t>(i) + 1] = run[static_cast<std::size_t>(i)] + seam.length / curve_samples / spacing;
    }
    const int intervals = std::max(3, static_cast<int>(std::ceil(run.back() - 1e-9)));
    const int twice = direction == MarkDirection::from_start ? 1
                      : direction == MarkDirection::from_end ? intervals - 1
                                                             : 0;  // the double mark
    std::vector<SeamMark> marks;
    for (int k = 1; k < intervals; ++k) {
        const double wanted = run.back() * k / intervals;
        const auto i = static_cast<std::size_t>(std::upper_bound(run.begin(), run.end() - 1, wanted) - run.begin());
        const double share = (wanted - run[i - 1]) / (run[i] - run[i - 1]);
        marks.push_back({seam.length * (static_cast<double>(i - 1) + share) / curve_samples, k == twice ? 2 : 1});
    }
    return marks;
}

std::vector<std::vector<PieceNotch>> make_notches(const CutPlan& plan, const std::vector<PieceOutline>& outlines,
                                                  const NotchOptions& options) {
    std::vector<Collector> collectors;
    for (std::size_t i = 0; i < plan.tiles.size(); ++i)
        collectors.emplace_back(plan.tiles[i], outlines[i], options.depth);
    const std::vector<MarkDirection> directions = mark_directions(plan);
    const std::vector<std::vector<SeamSheet>> sheets = sheets_of_seams(plan.seams);
    for (std::size_t s = 0; s < plan.seams.size(); ++s) {
        const Seam& seam = plan.seams[s];
        if (seam.into) continue;
        const std::vector<SeamMark> marks = seam_marks(plan.tiles, seam, options, directions[s]);
        for (const SeamSheet& sheet : sheets[s]) {
            Collector& collector = collectors[static_cast<std::size_t>(sheet.side->tile)];
            if (!collector.takes_notches()) continue;
            for (const SeamMark& mark : marks)
                if (mark.along >= sheet.from && mark.along <= sheet.to)
                    collector.add(seam, place_on_sheet(plan.tiles, sheet, mark.along), mark);
            for (const SeamSheet& other : sheets[s])  // at the end of any sheet, all get a notch
                for (const double end : {other.from, other.to})
                    if (end >= sheet.from && end <= sheet.to)
                        collector.add_end(*sheet.side, seam, place_on_sheet(plan.tiles, sheet, end), end);
        }
    }
    std::vector<std::vector<PieceNotch>> notches;
    for (Collector& collector : collectors) notches.push_back(std::move(collector.notches));
    return notches;
}

}  // namespace ripstop
