#pragma once

#include <array>
#include <string>
#include <vector>

#include "ripstop/geometry/types.h"
#include "ripstop/model/tile/seam_type_use.h"
#include "ripstop/model/tile/zigzag.h"

namespace ripstop {

/// A fault of an envelope as given, reported at the tile concerned.
struct EnvelopeIssue {
    /// stable, for machines: `unit`, `doubled`, `turned_over`, `scaled`, `shifted`, `gap`, `missing_tile`,
    /// `inside_out`, `uncertain`, `no_tile`, `precision`; `apart` and `unsewn` are not issues but notes
    std::string code;
    std::string message;             ///< one sentence for the designer, with a remedy
    std::vector<std::string> tiles;  ///< by name
    Vec3 at = Vec3::Zero();          ///< place [m]
    double value = 0;  ///< distance [m] for `shifted` and `gap`, ratio for `scaled`, size or rounding [m] for `unit`
                       ///< and `precision`; else 0
    double limit = 0;  ///< limit of the value, if it is not the seam tolerance [m]
    std::string fact = {};  ///< the message without the remedy, for an issue that may be intended
};

/// The codes of issues that may be intended; a designer can accept them (`accept_issues`).
inline constexpr std::array<const char*, 1> acceptable_issues{"missing_tile"};

/// A closed run of loose edges: a mouth, a crown, the outline of a sheet, a hole.
struct LooseLoop {
    std::vector<int> tiles;  ///< in order, a tile once per run of its boundary
    double length = 0;       ///< [m]
    int corners = 0;         ///< points where it turns by more than 40 degrees in space
    bool outline = false;    ///< it is the outer outline of a sheet, not a hole in one
    bool closed = false;     ///< false: its end meets no other loose edge
    double openness = 0;     ///< enclosed area over length squared: 1/(4 pi) for a circle, 0 for a slit
    Vec3 centre = Vec3::Zero();
};

/// The resolution of a seam: how closely its edges follow the curve.
struct SeamSampling {
    std::string id;
    double length = 0;       ///< [m]
    double turn = 0;         ///< largest turn between edges on either side [rad]
    double chord_error = 0;  ///< relative length error of such a polyline: theta^2 / 24
};

/// A fabric and the number of tiles that use it.
struct FabricUse {
    std::string name;
    int tiles = 0;
};

/// The result of checking an envelope: what was recognised and what is wrong.
struct EnvelopeCheck {
    int tiles = 0, triangles = 0, chains = 0, corners = 0, seams = 0;
    bool seams_sought = true;  ///< false: the tiles are too small for the tolerance, and figures of seams and loops are
                               ///< meaningless
    int sewn_in = 0;           ///< of these, additional sheets in seams between two others
    int self_seams = 0;        ///< seams of a tile with itself
    int t_junctions = 0;       ///< ends of seams inside an edge or chain of the other side
    int parts = 0;             ///< connected groups of tiles
    int odd_corners = 0;       ///< corners of a tile in the middle of a neighbour's chain where nothing else meets
    int loose_ends = 0;        ///< ends of loose edges that meet no other loose edge
    double seam_length = 0;    ///< total length of the seams [m]
    double area = 0;           ///< [m2]
    double gap_max = 0;        ///< largest distance between two edges that count as sewn [m]
    double seam_tolerance = 0;  ///< [m]
    Vec3 size = Vec3::Zero();   ///< size of the bounding box [m]
    std::vector<LooseLoop> loops;
    std::vector<SeamSampling> sampling;      ///< one per seam
    std::vector<Zigzag> zigzags;             ///< edges that follow mesh edges instead of a curve
    std::vector<std::string> grain_sources;  ///< sources of the warp directions, with the number of tiles for each
    std::vector<FabricUse> fabrics;          ///< in the order of the tiles
    std::vector<SeamTypeUse> seam_types;     ///< of seams and free edges
    std::vector<EnvelopeIssue> issues;
    std::vector<EnvelopeIssue> meant;  ///< not issues: edges that are sewn to nothing, and issues that were accepted
    std::vector<std::string> notes;    ///< worth a look but not wrong; `meant` is included

    bool sound() const { return issues.empty(); }
};

}  // namespace ripstop
