#include "ripstop/inflate/sew.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <set>

#include "ripstop/base/error.h"
#include "ripstop/base/index.h"
#include "ripstop/base/text/glob.h"
#include "ripstop/energy/deformation.h"
#include "ripstop/geometry/triangle.h"
#include "ripstop/inflate/joints.h"
#include "ripstop/inflate/rig.h"
#include "ripstop/mesh/surface_finder.h"
#include "ripstop/tile/seam_place.h"
#include "ripstop/tile/seam_sheets.h"
#include "ripstop/tile/targets.h"

namespace ripstop {
namespace {

constexpr double vertex_share = 1e-5;  // fraction of an edge

/// A boundary vertex on a side of a seam, and its arc length along the seam's curve.
struct SideVertex {
    int vertex = 0;
    double along = 0;
};

std::vector<SideVertex> vertices_of_side(const CutPlan& plan, const Seam& seam, bool second) {
    const SeamSide& side = second ? seam.b : seam.a;
    const std::vector<int>& boundary = plan.tiles[static_cast<std::size_t>(side.tile)].tile.boundary;
    const auto at = [&](int i) { return boundary[static_cast<std::size_t>(i) % boundary.size()]; };
    std::vector<SideVertex> found;
    if (const BoundaryPlace first = place_on_side(plan.tiles, seam, second, second ? seam.length : 0);
        first.share < vertex_share)
        found.push_back({at(first.edge), 0});
    double along = 0;
    for (std::size_t i = 0; i + 1 < side.parts.size(); ++i) {
        along += side.parts[i].length;
        found.push_back({at(side.parts[i].edge + 1), along});
    }
    if (const BoundaryPlace last = place_on_side(plan.tiles, seam, second, second ? 0 : seam.length);
        last.share > 1 - vertex_share)
        found.push_back({at(last.edge + 1), seam.length});
    if (second)
        for (SideVertex& each : found) each.along = seam.length - each.along;
    return found;
}

/// Joins the vertices of all tiles along their seams.
class Seamstress {
  public:
    Seamstress(const CutPlan& plan, const Symmetry& symmetry)
        : plan_(plan), symmetry_(symmetry), joints_(count_vertices(plan), symmetry.sectors) {
        for (int sum = 0; const FlatTile& tile : plan.tiles) {
            first_.push_back(sum);
            sum += tile.tile.mesh.vertex_count();
        }
    }

    /// A vertex as a point of its tile in the first sector.
    SewnPoint point(int tile, int vertex) const {
        const TurnedTile& turned = symmetry_.tiles[at(tile)];
        const int there = turned.vertex.empty() ? vertex : turned.vertex[at(vertex)];
        return {{{first_[at(turned.of)] + there, 1, turned.turns}}};
    }

    SewnPoint on_boundary(int tile, const BoundaryPlace& place) const {
        const std::vector<int>& boundary = plan_.tiles[at(tile)].tile.boundary;
        const auto i = static_cast<std::size_t>(place.edge);
        SewnPoint from = point(tile, boundary[i]), to = point(tile, boundary[(i + 1) % boundary.size()]);
        if (place.share < vertex_share) return from;
        if (place.share > 1 - vertex_share) return to;
        from.shares[0].weight = 1 - place.share;
        to.shares[0].weight = place.share;
        return {{from.shares[0], to.shares[0]}};
    }

    /// Joins vertices that coincide with vertices.
    void join_vertices(const Seam& seam) {
        for (const bool second : {false, true})
            for (const SideVertex& each : vertices_of_side(plan_, seam, second))
                if (const SewnPoint mate = on_mate(seam, second, each); mate.is_node())
                    joints_.join(point(side(seam, second).tile, each.vertex), mate);
    }

    /// Ties the vertices of the finer side to the edges of the coarser one, and the ends of the coarser side to the
    /// finer.
    void join_edges(const Seam& seam) {
        if (seam.into) {  // an additional sheet depends on the skin, whatever its mesh
            for (const SideVertex& each : vertices_of_side(plan_, seam, false)) join_to_edge(seam, false, each);
            return;
        }
        const std::vector<SideVertex> a = vertices_of_side(plan_, seam, false), b = vertices_of_side(plan_, seam, true);
        const bool b_is_finer = b.size() > a.size();
        for (const SideVertex& each : b_is_finer ? b : a) join_to_edge(seam, b_is_finer, each);
        for (const SideVertex& each : b_is_finer ? a : b)
            if (each.along == 0 || each.along == seam.length) join_to_edge(seam, !b_is_finer, each);
    }

    Joints& joints() { return joints_; }

  private:
    static int count_vertices(const CutPlan& plan) {
        int sum = 0;
        for (const FlatTile& tile : plan.tiles) sum += tile.tile.mesh.vertex_count();
        return sum;
    }
    const Tile& tile_of(int tile) const { return plan_.tiles[at(tile)].tile; }
    Vec3 drawn_point(int tile, const BoundaryPlace& place) const {
        const Tile& there = tile_of(tile);
        const auto i = static_cast<std::size_t>(place.edge);
        const Vec3 from = there.mesh.positions.row(there.boundary[i]);
        const Vec3 to = there.mesh.positions.row(there.boundary[(i + 1) % there.boundary.size()]);
        return from + place.share * (to - from);
    }
    static const SeamSide& side(const Seam& seam, bool second) { return second ? seam.b : seam.a; }

    SewnPoint on_mate(const Seam& seam, bool second, const SideVertex& each) const {
        return on_boundary(side(seam, !second).tile, place_on_side(plan_.tiles, seam, !second, each.along));
    }
    void join_to_edge(const Seam& seam, bool second, const SideVertex& each) {
        const BoundaryPlace there = place_on_side(plan_.tiles, seam, !second, each.along);
        const int tile = side(seam, second).tile, mate_tile = side(seam, !second).tile;
        SewnPoint mate = on_boundary(mate_tile, there);
        if (mate.is_node()) return;
        // An edge is a chord of the seam's curve: a dependent vertex keeps its offset from the chord.
        mate.offset = Vec3(tile_of(tile).mesh.positions.row(each.vertex)) - drawn_point(mate_tile, there);
        joints_.join(point(tile, each.vertex), mate);
    }

    const CutPlan& plan_;
    const Symmetry& symmetry_;
    Joints joints_;
    std::vector<int> first_;
};

void require_flat(const CutPlan& plan) {
    for (const FlatTile& tile : plan.tiles) {
        const TriangleMesh& mesh = tile.tile.mesh;
        if (!tile.is_flat())
            throw InputError(fmt::format(
                "tile {}: has no flat positions, so there is no piece to sew; flatten it first", tile.tile.name));
        for (int t = 0; t < mesh.triangle_count(); ++t)
            if (!(flat_edges(mesh.triangles, tile.flattening.positions, t).determinant() > 0))
                throw InputError(
                    fmt::format("tile {}: triangle {} is flipped or without area on the cloth, so the piece "
                                "cannot be sewn; redesign the tile or flatten it by another method",
                                tile.tile.name, t + 1));
    }
}

bool fits_any(const std::vector<std::string>& globs, const std::string& name) {
    return std::any_of(globs.begin(), globs.end(), [&](const std::string& glob) { return glob_match(glob, name); });
}

/// Finds the point of the skin nearest to a point of the drawing.
class Skin {
  public:
    Skin(const CutPlan& plan, const std::vector<char>& is_inside, const Seamstress& sewn) : plan_(plan), sewn_(sewn) {
        for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
            if (is_inside[i]) continue;
            tiles_.push_back(static_cast<int>(i));
            finders_.emplace_back(plan.tiles[i].tile.mesh);
        }
    }

    /// Empty if it is farther than `reach` [m].
    std::optional<SewnPoint> nearest(const Vec3& point, double reach) {
        std::optional<SewnPoint> place;
        for (std::size_t k = 0; k < tiles_.size(); ++k) {
            const auto found = finders_[k].nearest(point, reach);
            if (!found) continue;
            reach = found->distance;
            place.emplace();
            const TriangleMesh& mesh = plan_.tiles[at(tiles_[k])].tile.mesh;
            const int t = found->point.triangle;
            const Vec2 share =
                lay_flat(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)).inverse() * found->point.local;
            for (int c = 0; c < 3; ++c) {
                NodeShare part = sewn_.point(tiles_[k], mesh.triangles(t, c)).shares[0];
                part.weight = c == 0 ? 1 - share.sum() : share[c - 1];
                if (part.weight != 0) place->shares.push_back(part);
            }
        }
        return place;
    }

  private:
    const CutPlan& plan_;
    const Seamstress& sewn_;
    std::vector<int> tiles_;
    std::vector<SurfaceFinder> finders_;
};

/// An edge of a diaphragm or an end of a tie within this distance lies on the skin [m].
constexpr double on_skin = 0.02;

void join_diaphragms(const CutPlan& plan, const std::vector<char>& is_inside, const std::vector<char>& is_named,
                     Seamstress& sewn) {
    Skin skin(plan, is_inside, sewn);
    std::set<std::pair<int, int>> sewn_in;  // those already held by a seam
    for (const Seam& seam : plan.seams)
        if (seam.into)
            for (const SideVertex& each : vertices_of_side(plan, seam, false))
                sewn_in.insert({seam.a.tile, each.vertex});
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        if (!is_named[i]) continue;
        const Tile& tile = plan.tiles[i].tile;
        int joined = 0;
        for (const int vertex : tile.boundary) {
            if (sewn_in.contains({static_cast<int>(i), vertex})) {
                ++joined;
                continue;
            }
            if (const auto there = skin.nearest(tile.mesh.positions.row(vertex), on_skin))
                joined += sewn.joints().join(sewn.point(static_cast<int>(i), vertex), *there);
        }
        if (joined == 0)
            throw InputError(
                fmt::format("diaphragm {}: its edge lies nowhere within {:.0f} mm of the skin; draw it to the "
                            "skin it is sewn to",
                            tile.name, 1000 * on_skin));
    }
}

std::vector<char> find_diaphragms(const CutPlan& plan, const std::vector<std::string>& globs) {
    std::vector<char> is_inside;
    for (const FlatTile& tile : plan.tiles) is_inside.push_back(fits_any(globs, tile.tile.name));
    for (const std::string& glob : globs)
        if (std::none_of(plan.tiles.begin(), plan.tiles.end(),
                         [&](const FlatTile& tile) { return glob_match(glob, tile.tile.name); }))
            throw InputError("diaphragm \"" + glob + "\": fits no tile");
    return is_inside;
}

std::vector<SewnTape> find_ties(const CutPlan& plan, const std::vector<InnerTie>& ties,
                                const std::vector<char>& is_inside, const Seamstress& sewn) {
    std::vector<SewnTape> found;
    Skin skin(plan, is_inside, sewn);
    for (std::size_t i = 0; i < ties.size(); ++i) {
        SewnTape tape{TapeKind::tie};
        for (const bool second : {false, true}) {
            const Vec3& end = second ? ties[i].to : ties[i].from;
            const std::optional<SewnPoint> there = skin.nearest(end, on_skin);
            if (!there)
                throw InputError(
                    fmt::format("tie {}: its end at ({:.3f}, {:.3f}, {:.3f}) m is further than {:.0f} mm "
                                "from the skin; move it onto a tile",
                                ties[i].name, end.x(), end.y(), end.z(), 1000 * on_skin));
            (second ? tape.b : tape.a) = *there;
        }
        tape.rest = ties[i].length > 0 ? ties[i].length : (ties[i].to - ties[i].from).norm();
        tape.stiffness = ties[i].material.stiffness;
        tape.mass = ties[i].material.mass;
        tape.source = static_cast<int>(i);
        found.push_back(tape);
    }
    return found;
}

/// Numbers the free points; afterwards `place` is in terms of nodes.
class Numbering {
  public:
    Numbering(const CutPlan& plan, const Symmetry& symmetry, const Seamstress& sewn, const Joints& joints,
              SewnEnvelope& into)
        : joints_(joints) {
        std::vector<Vec3> drawn;
        for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
            const TurnedTile& turned = symmetry.tiles[i];
            const bool is_simulated = turned.turns == 0 && turned.of == static_cast<int>(i);
            const Points3& x = plan.tiles[i].tile.mesh.positions;
            into.first_vertex.push_back(static_cast<int>(node_.size()));
            for (Eigen::Index v = 0; v < x.rows(); ++v) {
                const bool is_node = is_simulated && joints.is_free(static_cast<int>(node_.size()));
                node_.push_back(is_node ? static_cast<int>(drawn.size()) : -1);
                if (is_node) drawn.push_back(Vec3(x.row(v)) - into.origin);
            }
        }
        into.nodes.resize(static_cast<Eigen::Index>(drawn.size()), 3);
        for (std::size_t n = 0; n < drawn.size(); ++n) into.nodes.row(static_cast<Eigen::Index>(n)) = drawn[n];
        into.freedom.assign(drawn.size(), Freedom::everywhere);
        for (const int point : joints.on_axis()) {
            const int node = node_[at(point)];
            if (node < 0) continue;
            into.nodes.row(node).head<2>().setZero();
            into.freedom[at(node)] = Freedom::vertical;
        }
        for (std::size_t i = 0; i < plan.tiles.size(); ++i)
            for (int v = 0; v < plan.tiles[i].tile.mesh.vertex_count(); ++v)
                into.places.push_back(place(sewn.point(static_cast<int>(i), v)));
    }

    SewnPoint place(const SewnPoint& in_points) const {
        SewnPoint result = joints_.resolved(in_points);
        for (NodeShare& part : result.shares) part.node = node_[at(part.node)];
        return result;
    }

  private:
    const Joints& joints_;
    std::vector<int> node_;
};

Fabric stiffened(Fabric fabric, double stiffer) {
    fabric.warp_stiffness *= stiffer;
    fabric.weft_stiffness *= stiffer;
    fabric.shear_stiffness *= stiffer;
    return fabric;
}

void add_cloth(const CutPlan& plan, const SewOptions& options, const Symmetry& symmetry,
               const std::vector<char>& is_inside, SewnEnvelope& into) {
    std::vector<std::array<int, 3>> triangles;
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        if (symmetry.tiles[i].turns != 0 || symmetry.tiles[i].of != static_cast<int>(i)) continue;
        const FlatTile& tile = plan.tiles[i];
        Fabric fabric = stiffened(plan.fabric_of(tile.tile), options.stiffer);
        if (options.rest == RestState::as_cut)  // shrunk cloth keeps the weight of what was cut
            fabric.mass *= (1 + tile.tile.compensation.warp) * (1 + tile.tile.compensation.weft);
        const std::vector<Mat22> rest = cloth_at_rest(tile, options.rest);
        const auto found = std::find(into.fabrics.begin(), into.fabrics.end(), fabric);
        const int number = static_cast<int>(found - into.fabrics.begin());
        if (found == into.fabrics.end()) into.fabrics.push_back(fabric);
        const Triangles& corners = tile.tile.mesh.triangles;
        for (int t = 0; t < tile.tile.mesh.triangle_count(); ++t) {
            const int first = into.first_vertex[i];
            triangles.push_back({first + corners(t, 0), first + corners(t, 1), first + corners(t, 2)});
            into.flat.push_back(rest[at(t)]);
            into.tile.push_back(static_cast<int>(i));
            into.fabric.push_back(number);
            into.holds_gas.push_back(!is_inside[i]);
        }
    }
    into.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
    for (std::size_t t = 0; t < triangles.size(); ++t)
        into.triangles.row(static_cast<Eigen::Index>(t)) << triangles[t][0], triangles[t][1], triangles[t][2];
}

double largest_gap(const CutPlan& plan, const Symmetry& symmetry, const SewnEnvelope& sewn) {
    double most = 0;
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        const Points3& x = plan.tiles[i].tile.mesh.positions;
        for (Eigen::Index v = 0; v < x.rows(); ++v) {
            const SewnPoint& place = sewn.places[at(sewn.first_vertex[i] + v)];
            most =
                std::max(most, (position(place, sewn.nodes, symmetry.angle()) + sewn.origin - Vec3(x.row(v))).norm());
        }
    }
    return most;
}

}  // namespace

std::vector<Mat22> cloth_at_rest(const FlatTile& tile, RestState rest) {
    const TriangleMesh& mesh = tile.tile.mesh;
    std::vector<Mat22> triangles;
    const Compensation& given = tile.tile.compensation;
    if (rest == RestState::as_cut) {
        const Mat22 shrunk = Vec2(1 / (1 + given.warp), 1 / (1 + given.weft)).asDiagonal();
        for (int t = 0; t < mesh.triangle_count(); ++t)
            triangles.push_back(shrunk * flat_edges(mesh.triangles, tile.flattening.positions, t));
        return triangles;
    }
    Tile wanted = tile.tile;
    if (rest == RestState::as_drawn) wanted.compensation = {};
    wanted.compensation.warp = wanted.compensation.weft = 0;
    wanted.compensation.chains.clear();
    triangles = target_triangles(wanted);
    const Eigen::Matrix2Xd warp = warp_in_triangles(wanted);
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        Mat22 axes;
        axes << warp(0, t), -warp(1, t), warp(1, t), warp(0, t);
        triangles[at(t)] = axes.transpose() * triangles[at(t)];
    }
    return triangles;
}

Symmetry no_symmetry(const CutPlan& plan) {
    Symmetry symmetry;
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) symmetry.tiles.push_back({static_cast<int>(i), 0, {}});
    return symmetry;
}

SewnEnvelope sew(const CutPlan& plan, const SewOptions& options) {
    require_flat(plan);
    const Symmetry symmetry = options.symmetry.tiles.empty() ? no_symmetry(plan) : options.symmetry;
    const std::vector<char> is_named = find_diaphragms(plan, options.rigging.diaphragms);
    std::vector<char> is_inside = find_inner_sheets(static_cast<int>(plan.tiles.size()), plan.seams);
    for (std::size_t i = 0; i < is_inside.size(); ++i) is_inside[i] = is_inside[i] || is_named[i];
    Seamstress seamstress(plan, symmetry);
    for (const Seam& seam : plan.seams) seamstress.join_vertices(seam);
    for (const Seam& seam : plan.seams) seamstress.join_edges(seam);
    join_diaphragms(plan, is_inside, is_named, seamstress);

    SewnEnvelope sewn;
    sewn.sectors = symmetry.sectors;
    sewn.origin = Vec3(symmetry.axis.x(), symmetry.axis.y(), 0);
    const Numbering numbering(plan, symmetry, seamstress, seamstress.joints(), sewn);
    add_cloth(plan, options, symmetry, is_inside, sewn);
    sewn.seam_gap = largest_gap(plan, symmetry, sewn);
    for (SewnTape tie : find_ties(plan, options.rigging.ties, is_inside, seamstress)) {
        tie.a = numbering.place(tie.a);
        tie.b = numbering.place(tie.b);
        sewn.tapes.push_back(tie);
    }
    const auto place_of = [&](int tile, const BoundaryPlace& place) {
        return numbering.place(seamstress.on_boundary(tile, place));
    };
    const std::vector<double> as_drawn;
    add_rigging(plan, options.rigging, symmetry, is_inside,
                options.rest == RestState::as_drawn ? as_drawn : plan.tape_factors, place_of, sewn);
    for (SewnTape& tape : sewn.tapes) tape.stiffness *= options.stiffer;
    return sewn;
}

}  // namespace ripstop
