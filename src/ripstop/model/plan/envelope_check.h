#pragma once

#include <array>
#include <string>
#include <vector>

#include "ripstop/geometry/types.h"
#include "ripstop/model/plan/allowance.h"
#include "ripstop/model/tile/zigzag.h"

namespace ripstop {

/// One thing that is wrong with an envelope as it was given, named at the tile that is wrong.
struct EnvelopeIssue {
    std::string code;     ///< stable, for machines: `unit`, `doubled`, `turned_over`, `scaled`, `shifted`, `gap`,
                          ///< `missing_tile`, `inside_out`, `uncertain`, `no_tile`, `precision`; `apart` and `unsewn`
                          ///< are no issues but notes
    std::string message;  ///< one sentence for the designer, with what to do
    std::vector<std::string> tiles;  ///< by name
    Vec3 at = Vec3::Zero();          ///< where [m]
    double value = 0;                ///< how far [m] for `shifted` and `gap`, the ratio for `scaled`, the size or the
                                     ///< rounding [m] for `unit` and `precision`; else 0
    double limit = 0;                ///< of the value, where it is not the seam tolerance [m]
    std::string fact = {};           ///< the message without what to do; of what may be meant
};

/// The codes of issues that may be meant: who means them accepts them (`accept_issues`).
inline constexpr std::array<const char*, 1> acceptable_issues{"missing_tile"};

/// A closed run of loose edges: a mouth, a crown, the outline of a sheet, a hole.
struct LooseLoop {
    std::vector<int> tiles;  ///< in order, a tile once for each run of its boundary
    double length = 0;       ///< [m]
    int corners = 0;         ///< places where it turns by more than 40 degrees in space
    bool outline = false;    ///< it goes round the outside of a sheet, not round a hole in one
    bool closed = false;     ///< false: its end meets no other loose edge
    double openness = 0;     ///< the area it goes round over its length squared: 1/(4 pi) for a circle, 0 for a slit
    Vec3 centre = Vec3::Zero();
};

/// How finely a seam's edges follow their curve.
struct SeamSampling {
    std::string id;
    double length = 0;       ///< [m]
    double turn = 0;         ///< largest turn of an edge of either side [rad]
    double chord_error = 0;  ///< by how much a polyline turning so is short: theta^2 / 24
};

/// A fabric and how many tiles are of it.
struct FabricUse {
    std::string name;
    int tiles = 0;
};

/// What was understood of an envelope, and what is wrong with it.
struct EnvelopeCheck {
    int tiles = 0, triangles = 0, chains = 0, corners = 0, seams = 0;
    bool seams_sought = true;   ///< false: tiles too small for the tolerance; figures of seams and loops say nothing
    int sewn_in = 0;            ///< of these, further sheets in the seams of two others
    int self_seams = 0;         ///< seams of a tile with itself
    int t_junctions = 0;        ///< ends of seams within an edge or chain of the other side
    int parts = 0;              ///< groups of tiles that seams hold together
    int odd_corners = 0;        ///< corners of a tile in the middle of one neighbour's chain, where nothing else meets
    int loose_ends = 0;         ///< ends of loose edges that meet no other
    double seam_length = 0;     ///< of all seams [m]
    double area = 0;            ///< [m2]
    double gap_max = 0;         ///< largest distance of two edges that count as sewn [m]
    double seam_tolerance = 0;  ///< [m]
    Vec3 size = Vec3::Zero();   ///< of the bounding box [m]
    std::vector<LooseLoop> loops;
    std::vector<SeamSampling> sampling;      ///< one a seam
    std::vector<Zigzag> zigzags;             ///< edges that go along a mesh instead of along a curve
    std::vector<std::string> grain_sources;  ///< where the warps come from, with how many tiles each
    std::vector<FabricUse> fabrics;          ///< in the order of the tiles
    std::vector<SeamTypeUse> seam_types;     ///< of seams and free edges
    std::vector<EnvelopeIssue> issues;
    std::vector<EnvelopeIssue> meant;  ///< no issues: what is sewn to nothing else, and what was accepted
    std::vector<std::string> notes;    ///< worth a look, not wrong; `meant` is among them

    bool sound() const { return issues.empty(); }
};

}  // namespace ripstop
