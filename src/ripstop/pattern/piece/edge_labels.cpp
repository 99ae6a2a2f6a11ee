#include "ripstop/pattern/piece/edge_labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "ripstop/base/text/utf8.h"

namespace ripstop {
namespace {

constexpr double air = 0.004;        // between the sew line and the letters [m]
constexpr double label_share = 0.8;  // largest share of a mate's length for its name
constexpr std::array heights{0.008, 0.006, 0.0045, 0.003};
constexpr std::array label_shares{0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8};

std::array<Vec2, 2> axes(const Box& box) {
    const Vec2 along(std::cos(box.turn), std::sin(box.turn));
    return {along, Vec2(-along.y(), along.x())};
}

double reach(const Box& box, const Vec2& axis) {
    const auto [along, up] = axes(box);
    return box.half.x() * std::abs(along.dot(axis)) + box.half.y() * std::abs(up.dot(axis));
}

struct LabelPoint {
    Vec2 at, way;
};

/// The point at distance `walked` along a polyline, and the direction there.
LabelPoint along(const Points2& line, double walked) {
    LabelPoint place{line.row(0), Vec2::UnitX()};
    for (Eigen::Index i = 0; i + 1 < line.rows(); ++i) {
        const Vec2 from = line.row(i), way = Vec2(line.row(i + 1)) - from;
        const double length = way.norm();
        if (!(length > 0)) continue;
        place = {from + std::min(1.0, walked / length) * way, way / length};
        if (walked <= length) break;
        walked -= length;
    }
    return place;
}

Box label_box(const Label& label) {
    return {label.middle, label.height * Vec2(static_cast<double>(letters_in(label.text)) / 2, 0.5), label.turn};
}

std::optional<Label> place_name(const PatternPiece& piece, const Points2& line, const Mate& mate, double from,
                                const std::vector<Box>& taken) {
    for (const double height : heights) {
        if (height * static_cast<double>(letters_in(mate.piece)) > label_share * mate.length) continue;
        for (const double share : label_shares) {
            const LabelPoint place = along(line, from + share * mate.length);
            const Vec2 inward(-place.way.y(), place.way.x());
            const Label label{mate.piece, place.at + (air + height / 2) * inward, height,
                              std::atan2(place.way.y(), place.way.x())};
            const Box box = label_box(label);
            const auto in_the_way = [&box](const Box& other) { return overlap(box, other); };
            if (contains(piece.sew_line, box) && std::none_of(taken.begin(), taken.end(), in_the_way)) return label;
        }
    }
    return std::nullopt;
}

}  // namespace

bool overlap(const Box& a, const Box& b) {
    const Vec2 apart = b.centre - a.centre;
    for (const Box* box : {&a, &b})
        for (const Vec2& axis : axes(*box))
            if (std::abs(apart.dot(axis)) >= reach(a, axis) + reach(b, axis)) return false;
    return true;
}

std::vector<Label> place_edge_labels(const PatternPiece& piece, std::vector<Box> taken) {
    std::vector<Label> labels;
    for (std::size_t e = 0; e < piece.edges.size(); ++e) {
        const Points2 line = piece.edge_line(e);
        const std::vector<Mate>& mates = piece.edges[e].mates;
        double from = 0;
        for (std::size_t m = 0; m < mates.size(); ++m) {
            const Mate& mate = mates[m];
            if (const std::optional<Label> label = place_name(piece, line, mate, from, taken)) {
                labels.push_back(*label);
                taken.push_back(label_box(*label));
            }
            // the sheets of one seam lie beside each other, and so do their names
            if (m + 1 == mates.size() || mates[m + 1].seam != mate.seam) from += mate.length;
        }
    }
    return labels;
}

}  // namespace ripstop
