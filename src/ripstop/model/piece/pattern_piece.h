#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "ripstop/geometry/types.h"
#include "ripstop/model/tile/fabric.h"
#include "ripstop/model/tile/seam_type.h"

namespace ripstop {

/// A text on a piece: its centre, letter height and rotation from +x.
struct Label {
    std::string text;
    Vec2 middle = Vec2::Zero();
    double height = 0.02;  ///< [m]
    double turn = 0;       ///< [rad], counter-clockwise
    bool counts = false;   ///< states how many copies the pattern cuts; not written where every copy is drawn
};

/// The piece to which a part of an edge is sewn.
struct Mate {
    std::string seam;       ///< id of the seam
    std::string piece;      ///< the name of the other piece
    double length = 0;      ///< length of that part on the cloth [m]
    std::string type = {};  ///< type of the seam
};

/// An edge of a piece: the part of its sew line from one corner to the next, counter-clockwise. Corners are points of
/// the sew line. An outline without corners is one edge that ends where it starts.
struct PieceEdge {
    int first = 0;         ///< index of its start in `PatternPiece::sew_line`; it ends at the start of the next edge
    double length = 0;     ///< length as flattened, before any points were dropped [m]
    double allowance = 0;  ///< width of cloth beyond the sew line [m]
    std::string seam_type = {};    ///< the seam or finish of most of its length: `flat-felled`, `hem`, …
    std::vector<Mate> mates = {};  ///< in order along the edge; empty if the edge is free
};

/// Two edges of a piece, or two parts of one edge, that are too close for both allowances: the cut line keeps less
/// there.
struct MetAllowances {
    int edge = 0, mate_edge = 0;  ///< indices in `PatternPiece::edges`
    double length = 0;            ///< length of the sew line concerned [m]
    double gap = 0;               ///< smallest clear width between the two [m]
    double left = 0;              ///< smallest allowance left on either side [m]; about 0 where they touch
    Vec2 at = Vec2::Zero();       ///< point of the sew line at the smallest gap
};

/// A match mark on an edge: the same place of the seam on both pieces. It is cut or drawn from the cut line inwards.
struct PieceNotch {
    int edge = 0;                  ///< index in `PatternPiece::edges`
    std::string seam;              ///< id of the seam
    double along = 0;              ///< arc length along the seam's curve from its start, equal on both mates [m]
    Vec2 on_sew = Vec2::Zero();    ///< its place on the sew line
    Vec2 outward = Vec2::UnitX();  ///< unit normal of the sew line there, away from the piece
    double reach = 0;              ///< distance from the sew line to the cut line along `outward` [m]
    double depth = 0;              ///< depth of the cut, less than the reach; 0: drawn, not cut [m]
    int count = 1;                 ///< 2: a double notch, `twin_distance` apart along the edge
    static constexpr double twin_distance = 0.008;  ///< [m]

    Vec2 on_cut() const { return on_sew + reach * outward; }
    Vec2 along_edge() const { return {-outward.y(), outward.x()}; }
    /// The slits from the cut line inwards: one or two, or none if the depth is 0.
    std::vector<std::pair<Vec2, Vec2>> slits() const { return strokes(on_cut(), depth); }
    /// The strokes of the notch from `start` inwards, one or two; none if `length` is 0.
    std::vector<std::pair<Vec2, Vec2>> strokes(const Vec2& start, double length) const {
        std::vector<std::pair<Vec2, Vec2>> lines;
        for (int i = 0; i < count && length > 0; ++i) {
            const Vec2 at = start + twin_distance * (i - (count - 1) / 2.0) * along_edge();
            lines.emplace_back(at, at - length * outward);
        }
        return lines;
    }
};

/// A line that is drawn on the piece but not cut: a load tape, artwork, a fold.
struct DrawnLine {
    std::string name;
    Points2 points;  ///< at least 2 x 2; a closed line repeats its first point
};

/// A pattern piece for the cutter: flat, in metres, +x along the warp, outside face up.
struct PatternPiece {
    std::string name;
    Points2 sew_line;  ///< closed, counter-clockwise, first point not repeated: the points of the edges, with exact
                       ///< corners
    std::vector<PieceEdge> edges =
        {};                 ///< the edges cover the sew line once, in its order; empty for a piece that is not sewn
    Points2 cut_line = {};  ///< closed, counter-clockwise: the line to cut; equal to the sew line if there is no
                            ///< allowance
    std::vector<MetAllowances> met = {};  ///< where the cut line keeps less than the allowance
    std::vector<PieceNotch> notches = {};
    Points2 grain_line = {};  ///< 2 x 2: tail and head of the grain arrow, inside the piece
    std::vector<DrawnLine> lines = {};
    std::vector<Label> labels = {};
    int quantity = 1;           ///< number of copies that this pattern cuts
    int quantity_mirrored = 0;  ///< number of mirrored copies it cuts
    std::string pattern = {};   ///< name of the equal piece whose pattern cuts this one (then `quantity` is 0); empty:
                                ///< its own
    bool mirrored = false;      ///< cut by that pattern turned over
    std::string gore = {}, row = {}, fabric = {}, colour = {}, revision = {};
    std::string file = {};  ///< stem of its file names

    /// The outline that is cut.
    const Points2& outline() const { return cut_line.rows() > 0 ? cut_line : sew_line; }
    Vec2 lower() const { return outline().colwise().minCoeff(); }
    Vec2 upper() const { return outline().colwise().maxCoeff(); }

    /// The sew line of an edge, both ends included (#P x 2).
    Points2 edge_line(std::size_t edge) const;
};

/// All pieces of an envelope with the data for cutting and sewing: the input of `export`, `nest` and the order.
struct PieceSet {
    std::string input;     ///< file that the envelope was read from
    std::string revision;  ///< revision of the patterns
    std::vector<PatternPiece> pieces;
    std::vector<Fabric> fabrics;       ///< every fabric that a piece names
    std::vector<SeamType> seam_types;  ///< every seam type that an edge names

    const Fabric& fabric(const std::string& name) const;  ///< the fabric of that name; the first one if there is none
};

/// The length of a grain line's arrow head along the shaft and half its width [m]; `length` is that of the grain
/// line.
inline double arrow_head(double length) {
    return std::min(0.012, 0.2 * length);
}
inline double arrow_half_width(double length) {
    return 0.3 * arrow_head(length);
}

}  // namespace ripstop
