#include "ripstop/report/tables/order.h"

#include <algorithm>
#include <map>

#include "ripstop/base/text/units.h"
#include "ripstop/geometry/polygon.h"
#include "ripstop/report/tables/csv.h"

namespace ripstop {
namespace {

using Cloth = std::pair<std::string, std::string>;  // fabric, colour

int copies(const PatternPiece& piece) {
    return piece.quantity + piece.quantity_mirrored;
}

double net_area(const PatternPiece& piece) {
    return piece.outline().rows() < 3 ? 0 : std::abs(signed_area(piece.outline()));
}

/// The marker of a cloth, if it contains all its pieces.
const Marker* marker_of(const Cloth& cloth, const PieceSet& set, const Markers* markers) {
    if (markers == nullptr) return nullptr;
    for (const PatternPiece& piece : set.pieces)
        if (Cloth(piece.fabric, piece.colour) == cloth)
            for (const Refusal& refusal : markers->refusals)
                if (refusal.piece == piece.name) return nullptr;
    for (const Marker& marker : markers->markers)
        if (Cloth(marker.fabric, marker.colour) == cloth) return &marker;
    return nullptr;
}

void add_cloths(std::string& text, const PieceSet& set, const Markers* markers) {
    std::map<Cloth, double> areas;
    std::map<Cloth, int> counts;
    for (const PatternPiece& piece : set.pieces) {
        areas[{piece.fabric, piece.colour}] += copies(piece) * net_area(piece);
        counts[{piece.fabric, piece.colour}] += copies(piece);
    }
    for (const auto& [cloth, area] : areas) {
        const Marker* marker = marker_of(cloth, set, markers);
        std::vector<std::string> line = {
            "cloth", "", cloth.first, cloth.second, std::to_string(counts[cloth]), "", csv_figure(area)};
        if (marker != nullptr)
            for (const double figure : {marker->gross_area(), marker->length, marker->roll_width / millimetre,
                                        (1 - marker->utilisation()) / percent})
                line.push_back(csv_figure(figure));
        line.resize(14);
        add_csv_line(text, line);
    }
}

constexpr double no_length = 1e-6;  // [m]

/// Sorts the mates of an edge in one seam by length, longest first; returns the first.
const Mate& longest_first(std::vector<const Mate*>& mates) {
    std::stable_sort(mates.begin(), mates.end(), [](const Mate* p, const Mate* q) { return p->length > q->length; });
    return *mates.front();
}

/// The length of a seam that one edge contributes, so that each seam counts once: half of the edge's length where two
/// sheets are sewn, a third where three are.
double share_of_seam(const std::vector<const Mate*>& longest_first) {
    double share = 0;
    for (std::size_t m = 0; m < longest_first.size(); ++m) {
        const double next = m + 1 < longest_first.size() ? longest_first[m + 1]->length : 0;
        share += (longest_first[m]->length - next) / static_cast<double>(m + 2);
    }
    return share;
}

void add_seams(std::string& text, const PieceSet& set) {
    std::map<std::string, double> lengths;
    for (const PatternPiece& piece : set.pieces)
        for (const PieceEdge& edge : piece.edges) {
            double sewn = 0;
            std::map<std::string, std::vector<const Mate*>> seams;
            for (const Mate& mate : edge.mates) seams[mate.seam].push_back(&mate);
            for (auto& [id, mates] : seams) {
                const Mate& longest = longest_first(mates);
                sewn += longest.length;
                lengths[longest.type.empty() ? edge.seam_type : longest.type] += share_of_seam(mates);
            }
            if (const double free = edge.length - sewn; edge.mates.empty() || free > no_length)
                lengths[edge.seam_type] += free;
        }
    for (const auto& [name, length] : lengths) {
        std::vector<std::string> line(14);
        line[0] = "seam";
        line[1] = name;
        line[11] = csv_figure(length);
        const auto type = std::find_if(set.seam_types.begin(), set.seam_types.end(),
                                       [&name = name](const SeamType& known) { return known.name == name; });
        if (type != set.seam_types.end()) {
            line[12] = csv_figure(type->rows * length * thread_per_row);
            line[13] = csv_figure(type->tape ? length : 0);
        }
        add_csv_line(text, line);
    }
}

}  // namespace

std::string bom_csv(const PieceSet& set, const Markers* markers) {
    std::string text;
    add_csv_line(text, {"kind", "name", "fabric", "colour", "quantity", "quantity_mirrored", "net_m2", "gross_m2",
                        "running_m", "roll_width_mm", "waste_pct", "length_m", "thread_m", "tape_m"});
    add_cloths(text, set, markers);
    add_seams(text, set);
    for (const PatternPiece& piece : set.pieces) {
        if (copies(piece) == 0) continue;
        std::vector<std::string> line = {"piece",
                                         piece.name,
                                         piece.fabric,
                                         piece.colour,
                                         std::to_string(piece.quantity),
                                         std::to_string(piece.quantity_mirrored),
                                         csv_figure(net_area(piece))};
        line.resize(14);
        add_csv_line(text, line);
    }
    return text;
}

}  // namespace ripstop
