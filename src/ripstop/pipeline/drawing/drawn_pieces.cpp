#include "ripstop/pipeline/drawing/drawn_pieces.h"

#include <algorithm>
#include <map>

#include "ripstop/base/error.h"
#include "ripstop/geometry/polygon.h"
#include "ripstop/io/text/escape.h"
#include "ripstop/pattern/drawing/drawing_lines.h"

namespace ripstop {
namespace {

constexpr double same_line = 0.1e-3;  // distance between an outline and its rounded copy in a file [m]
constexpr double join_tolerance = 0.01 * millimetre;

/// A closed line of the drawing [m].
struct Ring {
    Points2 points;
    int group;
    Vec2 lower, upper;
};

/// Whether the points of each outline lie on the other one after their bounding boxes are aligned.
bool fits(const Ring& ring, const PatternPiece& piece) {
    const Vec2 lower = piece.lower(), upper = piece.upper();
    if (((ring.upper - ring.lower) - (upper - lower)).cwiseAbs().maxCoeff() > same_line) return false;
    const Points2& outline = piece.outline();
    const Points2 moved = ring.points.rowwise() + (lower - ring.lower).transpose();
    const auto lies_on = [](const Points2& points, const Points2& line) {
        for (Eigen::Index i = 0; i < points.rows(); ++i)
            if (distance_to_outline(line, points.row(i)) > same_line) return false;
        return true;
    };
    return lies_on(moved, outline) && lies_on(outline, moved);
}

class PieceFinder {
  public:
    PieceFinder(const PatternDrawing& drawing, double metres_per_unit, const PieceSet& set, const std::string& stem)
        : drawing_(drawing),
          set_(set),
          stem_(stem),
          survey_{drawing, convention_of(drawing), metres_per_unit, unused_check_} {
        for (const PatternPiece& piece : set.pieces) {
            by_name_[piece.name] = &piece;
            const auto [found, is_new] = by_ascii_.emplace(ascii_text(piece.name), &piece);
            if (!is_new) found->second = nullptr;
        }
    }

    DrawnPieces run() {
        std::vector<const DrawnPath*> paths;
        for (const DrawnPath& path : drawing_.paths)
            if (path.points.rows() > 1) paths.push_back(&path);
        for (const LayerLines& layer : join_layers(paths, survey_.metres_per_unit, join_tolerance))
            for (const JoinedLine& line : layer.lines)
                if (line.is_closed && line.points.rows() > 2) look_at(layer, line);
        for (const Ring& ring : unknown_)
            if (!is_in_a_piece(ring)) pieces_.strangers.push_back(piece_name(survey_, ring.group, ring.points));
        return std::move(pieces_);
    }

  private:
    void look_at(const LayerLines& layer, const JoinedLine& line) {
        const LayerUse use = use_of(survey_.convention, layer.layer);
        if (use == LayerUse::reference) return;
        const Ring ring{line.points, layer.group, line.points.colwise().minCoeff(), line.points.colwise().maxCoeff()};
        const PatternPiece* named = named_piece(ring);
        const PatternPiece* piece = named ? (fits(ring, *named) ? named : nullptr) : only_piece(ring);
        if (!piece) {
            if (use == LayerUse::cut) unknown_.push_back(ring);
            return;
        }
        DrawnPiece found{piece, ring.lower, ring.upper, {}};
        for (const int part : line.lines) found.outline.push_back(layer.paths[static_cast<std::size_t>(part)]);
        const auto is_same = [&found](const DrawnPiece& other) {
            return other.piece == found.piece && (other.lower - found.lower).cwiseAbs().maxCoeff() < same_line;
        };
        // A piece without allowance has its sew line drawn on top of its cut line.
        if (std::none_of(pieces_.found.begin(), pieces_.found.end(), is_same))
            pieces_.found.push_back(std::move(found));
    }

    /// Whether the ring is a hole drawn inside a piece.
    bool is_in_a_piece(const Ring& ring) const {
        return std::any_of(pieces_.found.begin(), pieces_.found.end(), [&ring](const DrawnPiece& found) {
            return contains(found.piece->outline(), Vec2(Vec2(ring.points.row(0)) + found.shift()));
        });
    }

    const PatternPiece* called(const std::string& name) const {
        if (const auto found = by_name_.find(name); found != by_name_.end()) return found->second;
        const auto found = by_ascii_.find(ascii_text(name));
        return found == by_ascii_.end() ? nullptr : found->second;
    }

    /// Looks for the name at its own place first: the names of neighbours along the edges of a small piece are larger
    /// than its own.
    const PatternPiece* named_piece(const Ring& ring) const {
        if (ring.group >= 0)
            if (const PatternPiece* piece = called(piece_name(survey_, ring.group, ring.points))) return piece;
        for (const DrawnText& text : drawing_.texts) {
            const Vec2 at = text.at * survey_.metres_per_unit;
            if ((at.array() < ring.lower.array()).any() || (at.array() > ring.upper.array()).any()) continue;
            const PatternPiece* piece = called(text.text);
            if (!piece || piece->labels.empty()) continue;
            const Label& label = piece->labels.front();
            if ((at - ring.lower - (label.middle - piece->lower())).norm() <= label.height) return piece;
        }
        return called(piece_name(survey_, -1, ring.points));
    }

    const PatternPiece* only_piece(const Ring& ring) const {
        std::vector<const PatternPiece*> fitting;
        for (const PatternPiece& piece : set_.pieces)
            if (fits(ring, piece)) fitting.push_back(&piece);
        if (fitting.size() < 2) return fitting.empty() ? nullptr : fitting.front();
        for (const PatternPiece* piece : fitting)
            if (piece->file == stem_) return piece;
        std::string names;
        constexpr std::size_t most = 6;
        for (std::size_t i = 0; i < fitting.size() && i < most; ++i) names += (i > 0 ? ", " : "") + fitting[i]->name;
        if (fitting.size() > most) names += ", …";
        throw InputError("the outline at " + place_text(ring.lower) + " fits several pieces: " + names +
                         "; keep the name from cut/ in the drawing, or name the file after the piece");
    }

    const PatternDrawing& drawing_;
    const PieceSet& set_;
    const std::string& stem_;
    DrawingCheck unused_check_;
    DrawingSurvey survey_;
    std::map<std::string, const PatternPiece*> by_name_;
    std::map<std::string, const PatternPiece*> by_ascii_;  // names as written in DXF; null if two pieces share one
    std::vector<Ring> unknown_;
    DrawnPieces pieces_;
};

}  // namespace

DrawnPieces find_drawn_pieces(const PatternDrawing& drawing, double metres_per_unit, const PieceSet& set,
                              const std::string& stem) {
    return PieceFinder(drawing, metres_per_unit, set, stem).run();
}

}  // namespace ripstop
