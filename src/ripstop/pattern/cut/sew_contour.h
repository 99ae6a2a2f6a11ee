#pragma once

#include <vector>

#include "ripstop/geometry/types.h"
#include "ripstop/pattern/cut/cut_corner.h"

namespace ripstop {

/// One edge of a sew line and the cloth beyond it.
struct AllowedEdge {
    Points2 sew_line;      ///< #P x 2, both ends included, counter-clockwise round the piece
    double allowance = 0;  ///< [m], not negative
    CornerRule corner = CornerRule::mitre;
};

/// A straight part of a sew line.
struct SewSegment {
    Vec2 from, to;
    Vec2 way, outward;  ///< unit vectors; the piece is on the left of `way`
    double length = 0;  ///< [m]
    double start = 0;   ///< length of the sew line before it [m]
    int edge = 0;
    double allowance = 0;  ///< of its edge [m]
    CornerRule rule = CornerRule::mitre;
    Vec2 at(double along) const { return from + along * way; }
};

/// A place on the sew line: `along` [m] from the start of a segment.
struct SewPlace {
    std::size_t segment = 0;
    double along = 0;
};

/// What the sew line runs round between two of its places that face each other across the outside.
struct Pocket {
    double length = 0;    ///< of the sew line between them [m]
    double turn = 0;      ///< clockwise, so that two sides that face each other squarely have pi [rad]
    bool forward = true;  ///< it runs from the first place counter-clockwise to the second
};

/// The sew line of a piece as straight parts, with what is asked of two places of it. A corner that turns inward has
/// allowances that share its cloth, and every sewer clips into it. So two places are *apart* only where the sew line
/// between them
///
///     is longer than 2 (a + b)        with their allowances a and b: a corner of some 55 degrees or less, or a slit
///     or holds a whole edge and turns by more than 127 degrees: a notch or a keyhole smaller than that
///
/// (an edge shorter than a fifth of its allowance does not count). Allowances may overlap unless their places are
/// apart.
class SewContour {
  public:
    /// Edges that close on themselves, in order; parts shorter than a nanometre are left out. O(#P).
    explicit SewContour(const std::vector<AllowedEdge>& edges);

    const std::vector<SewSegment>& segments() const { return segments_; }
    std::size_t next(std::size_t segment) const { return (segment + 1) % segments_.size(); }
    std::size_t before(std::size_t segment) const { return (segment + segments_.size() - 1) % segments_.size(); }
    /// Where the segment starts, with these allowances [m].
    SewCorner corner(std::size_t segment, double reach_in, double reach_out) const;
    /// Is it a corner between two edges, and not a bend within one?
    bool starts_edge(std::size_t segment) const;
    bool turns_outward(std::size_t segment) const;
    double length() const { return length_; }

    /// The pocket between two places: of the two ways round the one that goes round less. O(1).
    Pocket pocket(const SewPlace& a, const SewPlace& b) const;
    /// O(1), O(#edges) for short pockets.
    bool is_apart(const SewPlace& a, const SewPlace& b) const;
    /// False where no places of the two segments are apart.
    bool may_be_apart(std::size_t a, std::size_t b) const;

    /// The part of segment `other` that is apart from `place`, as lengths from its start; none where the second is
    /// not larger.
    struct Part {
        double from = 0, to = 0;
    };
    Part part_apart(const SewPlace& place, std::size_t other) const;

  private:
    double forward_length(const SewPlace& a, const SewPlace& b) const;
    double forward_area(const SewPlace& a, const SewPlace& b) const;
    double forward_turn(const SewPlace& a, const SewPlace& b) const;
    bool holds_edge(const SewPlace& a, const SewPlace& b) const;
    bool is_open(const Pocket& pocket, const SewPlace& a, const SewPlace& b) const;

    std::vector<SewSegment> segments_;
    double length_ = 0;
    std::vector<double> turned_, swept_;  ///< up to the start of each segment, and over all
    struct Edge {
        double start, length;
        bool counts;
    };
    std::vector<Edge> edges_;
};

}  // namespace ripstop
