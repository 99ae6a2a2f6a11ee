#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "ripstop/geometry/types.h"
#include "ripstop/model/tile/fabric.h"
#include "ripstop/model/tile/seam_type.h"

namespace ripstop {

/// A text on a piece: where its middle is, how high the letters are, turned by how much from +x.
struct Label {
    std::string text;
    Vec2 middle = Vec2::Zero();
    double height = 0.02;  ///< [m]
    double turn = 0;       ///< [rad], counter-clockwise
    bool counts = false;   ///< says how many are cut by the pattern: not written where all of them are drawn
};

/// Whom a piece is sewn to along a part of an edge.
struct Mate {
    std::string seam;       ///< its id
    std::string piece;      ///< the name of the other piece
    double length = 0;      ///< of the part, on the cloth [m]
    std::string type = {};  ///< of the seam
};

/// An edge of a piece: the run of its sew line from one corner to the next, counter-clockwise. Corners are points of
/// the sew line; an outline without corners is one edge that ends where it starts.
struct PieceEdge {
    int first = 0;                 ///< in `PatternPiece::sew_line`: where it starts; it ends where the next edge starts
    double length = 0;             ///< of the edge as flattened, before any point of it was left out [m]
    double allowance = 0;          ///< cloth beyond the sew line [m]
    std::string seam_type = {};    ///< how most of it is sewn, or how it is finished: `flat-felled`, `hem`, …
    std::vector<Mate> mates = {};  ///< in the order of the edge; none where it is free
};

/// Two edges of a piece, or two parts of one, whose allowances do not fit between them: the cut line keeps less there.
struct MetAllowances {
    int edge = 0, mate_edge = 0;  ///< in `PatternPiece::edges`
    double length = 0;            ///< of the sew line where they meet [m]
    double gap = 0;               ///< the least clear width between the two [m]
    double left = 0;              ///< the least allowance that is left to either [m]; about 0 where they touch
    Vec2 at = Vec2::Zero();       ///< on the sew line, where the gap is least
};

/// A match mark on an edge: the same place of the seam on both pieces. It is cut or drawn from the cut line inwards.
struct PieceNotch {
    int edge = 0;                                   ///< in `PatternPiece::edges`
    std::string seam;                               ///< id
    double along = 0;                               ///< the seam's curve from its start, so equal on both mates [m]
    Vec2 on_sew = Vec2::Zero();                     ///< on the sew line
    Vec2 outward = Vec2::UnitX();                   ///< unit normal of the sew line there, away from the piece
    double reach = 0;                               ///< from the sew line to the cut line along `outward` [m]
    double depth = 0;                               ///< of the cut, less than the reach; 0: drawn, not cut [m]
    int count = 1;                                  ///< 2: a double notch, `twin_distance` apart along the edge
    static constexpr double twin_distance = 0.008;  ///< [m]

    Vec2 on_cut() const { return on_sew + reach * outward; }
    Vec2 along_edge() const { return {-outward.y(), outward.x()}; }
    /// The slits, from the cut line inwards; one or two, none where there is no depth.
    std::vector<std::pair<Vec2, Vec2>> slits() const { return strokes(on_cut(), depth); }
    /// Strokes from `start` inwards, as many as the notch has; none without length.
    std::vector<std::pair<Vec2, Vec2>> strokes(const Vec2& start, double length) const {
        std::vector<std::pair<Vec2, Vec2>> lines;
        for (int i = 0; i < count && length > 0; ++i) {
            const Vec2 at = start + twin_distance * (i - (count - 1) / 2.0) * along_edge();
            lines.emplace_back(at, at - length * outward);
        }
        return lines;
    }
};

/// A line that is drawn on the piece and not cut: a load tape, artwork, a fold.
struct DrawnLine {
    std::string name;
    Points2 points;  ///< at least 2 x 2; a closed one ends where it starts
};

/// What is drawn for the cutter: the flat piece in metres, +x the warp, outside face up.
struct PatternPiece {
    std::string name;
    Points2 sew_line;  ///< closed, counter-clockwise, the first point not repeated: the edges' points, corners exact
    std::vector<PieceEdge> edges =
        {};                 ///< they cover the sew line once, in its order; none on a piece that is not sewn
    Points2 cut_line = {};  ///< closed, counter-clockwise: what is cut; the sew line where nothing is allowed
    std::vector<MetAllowances> met = {};  ///< where it keeps less than what is allowed
    std::vector<PieceNotch> notches = {};
    Points2 grain_line = {};  ///< 2 x 2: tail and head of the grain arrow, inside the piece
    std::vector<DrawnLine> lines = {};
    std::vector<Label> labels = {};
    int quantity = 1;           ///< how many are cut by this pattern
    int quantity_mirrored = 0;  ///< and by the pattern turned over
    std::string pattern = {};   ///< name of the equal piece whose pattern cuts it (`quantity` 0); empty: its own
    bool mirrored = false;      ///< it is cut by that pattern turned over
    std::string gore = {}, row = {}, fabric = {}, colour = {}, revision = {};
    std::string file = {};  ///< stem of its files

    /// Of what is cut.
    const Points2& outline() const { return cut_line.rows() > 0 ? cut_line : sew_line; }
    Vec2 lower() const { return outline().colwise().minCoeff(); }
    Vec2 upper() const { return outline().colwise().maxCoeff(); }

    /// The sew line of an edge, both ends included (#P x 2).
    Points2 edge_line(std::size_t edge) const;
};

/// How many the pattern cuts, as it is written on it: `cut 12 + 12 mirrored`; empty where it is itself alone.
std::string cut_count(const PatternPiece& piece);

/// Counts what each pattern cuts once more, where pieces were left out: of equal pieces the first is the pattern and
/// the others are cut by it, turned over where they are its mirror image. A label that states the count states the new
/// one, or is dropped where the piece is cut once.
void count_patterns(std::vector<PatternPiece>& pieces);

/// All the pieces of an envelope, with what cutting and sewing them needs: what `export`, `nest` and the order work
/// from.
struct PieceSet {
    std::string input;     ///< the file the envelope came from
    std::string revision;  ///< of the patterns
    std::vector<PatternPiece> pieces;
    std::vector<Fabric> fabrics;       ///< every fabric a piece names
    std::vector<SeamType> seam_types;  ///< every type an edge names

    const Fabric& fabric(const std::string& name) const;  ///< a fabric of that name; the first where there is none
};

/// Length along the shaft of the arrow head of a grain line `length` long, and half its width [m].
inline double arrow_head(double length) {
    return std::min(0.012, 0.2 * length);
}
inline double arrow_half_width(double length) {
    return 0.3 * arrow_head(length);
}

}  // namespace ripstop
