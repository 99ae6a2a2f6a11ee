#pragma once

#include <vector>

#include "ripstop/geometry/types.h"
#include "ripstop/pattern/cut/cut_corner.h"

namespace ripstop {

/// An edge of a sew line and its allowance.
struct AllowedEdge {
    Points2 sew_line;      ///< #P x 2, both ends included, counter-clockwise round the piece
    double allowance = 0;  ///< [m], not negative
    CornerRule corner = CornerRule::mitre;
};

/// A straight segment of a sew line.
struct SewSegment {
    Vec2 from, to;
    Vec2 way, outward;  ///< unit vectors; the piece is to the left of `way`
    double length = 0;  ///< [m]
    double start = 0;   ///< length of the sew line before it [m]
    int edge = 0;
    double allowance = 0;  ///< of its edge [m]
    CornerRule rule = CornerRule::mitre;
    Vec2 at(double along) const { return from + along * way; }
};

/// A place on the sew line, `along` [m] from the start of a segment.
struct SewPlace {
    std::size_t segment = 0;
    double along = 0;
};

/// What the sew line surrounds between two of its places that face each other across the outside.
struct Pocket {
    double length = 0;    ///< of the sew line between them [m]
    double turn = 0;      ///< clockwise [rad]; pi between two parallel sides that face each other
    bool forward = true;  ///< it runs counter-clockwise from the first place to the second
};

/// The sew line of a piece as segments, with queries about pairs of places. At a corner that turns inward, the two
/// allowances share cloth, and sewers clip into it. So two places are *apart* only if the sew line between them
///
///     is longer than 2 (a + b), with their allowances a and b: a corner of about 55 degrees or less, or a slit;
///     or contains a whole edge and turns by more than 127 degrees: a notch or a keyhole smaller than that
///
/// (edges shorter than a fifth of their allowance do not count). Allowances may overlap unless their places are
/// apart.
class SewContour {
  public:
    /// The edges must form a closed line, in order. Segments shorter than a nanometre are dropped. O(#P).
    explicit SewContour(const std::vector<AllowedEdge>& edges);

    const std::vector<SewSegment>& segments() const { return segments_; }
    std::size_t next(std::size_t segment) const { return (segment + 1) % segments_.size(); }
    std::size_t before(std::size_t segment) const { return (segment + segments_.size() - 1) % segments_.size(); }
    /// The corner at the start of a segment, with these allowances [m].
    SewCorner corner(std::size_t segment, double reach_in, double reach_out) const;
    /// True for a corner between two edges; false for a bend within an edge.
    bool starts_edge(std::size_t segment) const;
    bool turns_outward(std::size_t segment) const;
    double length() const { return length_; }

    /// The pocket between two places. Of the two ways along the sew line, it takes the one that surrounds less.
    /// O(1).
    Pocket pocket(const SewPlace& a, const SewPlace& b) const;
    /// True if the allowances of the two places must not overlap. O(1); O(#edges) for short pockets.
    bool is_apart(const SewPlace& a, const SewPlace& b) const;
    /// False only if no places of the two segments are apart.
    bool may_be_apart(std::size_t a, std::size_t b) const;

    /// The part of segment `other` that is apart from `place`, from one length to another along it; empty unless
    /// `to` is larger.
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
    std::vector<double> turned_, swept_;  ///< up to the start of each segment, and in total
    struct Edge {
        double start, length;
        bool counts;
    };
    std::vector<Edge> edges_;
};

}  // namespace ripstop
