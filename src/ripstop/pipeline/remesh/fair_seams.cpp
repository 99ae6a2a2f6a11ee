#include "ripstop/pipeline/remesh/fair_seams.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <map>
#include <optional>
#include <stdexcept>

#include "ripstop/assembly/seams/find_seams.h"
#include "ripstop/base/index.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/flatten/map/dirichlet.h"
#include "ripstop/geometry/polygon.h"
#include "ripstop/geometry/triangle.h"
#include "ripstop/mesh/boundary.h"
#include "ripstop/mesh/change/delaunay.h"
#include "ripstop/model/tile/corner_turn.h"
#include "ripstop/model/tile/zigzag.h"
#include "ripstop/tile/find_zigzags.h"
#include "ripstop/tile/make_tile.h"

namespace ripstop {
namespace {

constexpr double too_near = 0.55;  // in new edges: inner vertices closer to one are removed
constexpr std::size_t most_remarks = 12;

/// Displacements by place in space, in a grid of cells.
class Places {
  public:
    explicit Places(double tolerance) : tolerance_(tolerance) {}

    void add(const Vec3& from, const Vec3& to) { moves_[cell(from)].push_back({from, to}); }

    /// The new place of a vertex at `from`; empty if it does not move.
    std::optional<Vec3> find(const Vec3& from) const {
        const std::array<long, 3> middle = cell(from);
        for (long i = -1; i <= 1; ++i)
            for (long j = -1; j <= 1; ++j)
                for (long k = -1; k <= 1; ++k) {
                    const auto here = moves_.find({middle[0] + i, middle[1] + j, middle[2] + k});
                    if (here == moves_.end()) continue;
                    for (const auto& [at, to] : here->second)
                        if ((at - from).norm() <= tolerance_) return to;
                }
        return {};
    }

  private:
    std::array<long, 3> cell(const Vec3& x) const {
        return {std::lround(x.x() / tolerance_), std::lround(x.y() / tolerance_), std::lround(x.z() / tolerance_)};
    }

    double tolerance_;
    std::map<std::array<long, 3>, std::vector<std::pair<Vec3, Vec3>>> moves_;
};

/// A tile with its layout, for its zigzags.
struct LaidTile {
    Points2 flat;              ///< #V x 2; empty if the layout failed
    Points3 normals;           ///< #V x 3, at boundary vertices
    std::map<int, int> place;  ///< index in the boundary, by vertex
};

/// The direction of the boundary at a vertex: the mean of the edges before and after.
template <class Points>
auto along(const Tile& tile, const Points& at, int place) {
    const auto size = static_cast<int>(tile.boundary.size());
    const auto vertex = [&](int i) { return tile.boundary[static_cast<std::size_t>((i + size) % size)]; };
    using Vector = Eigen::Matrix<double, Points::ColsAtCompileTime, 1>;
    const Vector before = at.row(vertex(place)) - at.row(vertex(place - 1));
    const Vector after = at.row(vertex(place + 1)) - at.row(vertex(place));
    return Vector((before.normalized() + after.normalized()).normalized());
}

struct Frame {
    Vec3 along, left;
    Vec2 flat_along, flat_left;
};

Frame frame_at(const Tile& tile, const LaidTile& laid, int vertex) {
    const int place = laid.place.at(vertex);
    Frame frame;
    frame.left = Vec3(laid.normals.row(vertex)).cross(along(tile, tile.mesh.positions, place)).normalized();
    frame.along = frame.left.cross(Vec3(laid.normals.row(vertex)));
    frame.flat_along = along(tile, laid.flat, place);
    frame.flat_left = Vec2(-frame.flat_along.y(), frame.flat_along.x());
    return frame;
}

LaidTile lay(const Tile& tile) {
    LaidTile laid;
    const Flattening flattening = flatten_dirichlet(tile);
    if (!flattening.summary.usable() || flattening.positions.rows() != tile.mesh.vertex_count()) return laid;
    laid.flat = flattening.positions;
    laid.normals = Points3::Zero(tile.mesh.vertex_count(), 3);
    for (int t = 0; t < tile.mesh.triangle_count(); ++t) {
        const Vec3 a = tile.mesh.corner(t, 0);
        const Vec3 area = (tile.mesh.corner(t, 1) - a).cross(tile.mesh.corner(t, 2) - a);
        for (int k = 0; k < 3; ++k) laid.normals.row(tile.mesh.triangles(t, k)) += area;
    }
    laid.normals.rowwise().normalize();
    for (std::size_t i = 0; i < tile.boundary.size(); ++i) laid.place[tile.boundary[i]] = static_cast<int>(i);
    return laid;
}

/// Whether corners were given: those that do not follow from the boundary's turns. They stay corners.
bool has_given_corners(const Tile& tile) {
    if (tile.chains.size() < 2) return false;
    const Eigen::VectorXd turning = surface_turning(tile.mesh, tile.boundary);
    std::map<int, bool> corner;
    for (const Chain& chain : tile.chains) corner[chain.vertices.front()] = true;
    for (std::size_t i = 0; i < tile.boundary.size(); ++i)
        if (corner.contains(tile.boundary[i]) != (std::abs(turning[static_cast<Eigen::Index>(i)]) > corner_turn))
            return true;
    return false;
}

/// The tile with its boundary moved by `moves`.
Tile moved_tile(const Tile& tile, const LaidTile& laid, const Places& moves) {
    const auto outline = static_cast<Eigen::Index>(tile.boundary.size());
    Points2 polygon(outline, 2);
    Points3 positions(outline, 3);
    std::vector<bool> moved;
    for (Eigen::Index i = 0; i < outline; ++i) {
        const int v = tile.boundary[at(i)];
        const Vec3 here = tile.mesh.positions.row(v);
        const std::optional<Vec3> to = moves.find(here);
        moved.push_back(to.has_value());
        positions.row(i) = to.value_or(here);
        polygon.row(i) = laid.flat.row(v);
        if (!to) continue;
        const Frame frame = frame_at(tile, laid, v);
        polygon.row(i) +=
            (frame.along.dot(*to - here) * frame.flat_along + frame.left.dot(*to - here) * frame.flat_left).transpose();
    }
    const auto is_near_new_edge = [&](const Vec2& point) {
        for (Eigen::Index i = 0; i < outline; ++i) {
            const Eigen::Index next = (i + 1) % outline;
            if (!moved[at(i)] && !moved[at(next)]) continue;
            const Vec2 from = polygon.row(i), edge = Vec2(polygon.row(next)) - from;
            const double share = std::clamp((point - from).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
            if ((point - from - share * edge).norm() < too_near * edge.norm()) return true;
        }
        return false;
    };
    std::vector<int> inner;
    for (int v = 0; v < tile.mesh.vertex_count(); ++v) {
        if (laid.place.contains(v)) continue;
        const Vec2 point = laid.flat.row(v);
        if (contains(polygon, point) && !is_near_new_edge(point)) inner.push_back(v);
    }
    Points2 flat(outline + static_cast<Eigen::Index>(inner.size()), 2);
    flat.topRows(outline) = polygon;
    flat.bottomRows(flat.rows() - outline) = laid.flat(inner, Eigen::all);
    TriangleMesh mesh;
    mesh.positions.resize(flat.rows(), 3);
    mesh.positions.topRows(outline) = positions;
    mesh.positions.bottomRows(flat.rows() - outline) = tile.mesh.positions(inner, Eigen::all);
    mesh.triangles = delaunay_inside(flat, static_cast<int>(outline));
    if (mesh.triangles.rows() == 0) throw std::runtime_error("no triangulation within the fair curve is possible");

    TileOptions options{.warp = tile.grain.direction,
                        .warp_source = tile.grain.source,
                        .compensation = tile.compensation,
                        .attributes = tile.attributes};
    if (has_given_corners(tile))
        for (const Chain& chain : tile.chains)
            options.corners.emplace_back(positions.row(laid.place.at(chain.vertices.front())));
    Tile made = make_tile(tile.name, std::move(mesh), options);
    made.fabric = tile.fabric;
    return made;
}

class Fairing {
  public:
    Fairing(Envelope& envelope, double tolerance)
        : envelope_(envelope),
          tolerance_(tolerance),
          zigzags_(find_zigzags(envelope.tiles, envelope.seams)),
          laid_(envelope.tiles.size()),
          failure_(envelope.tiles.size()) {}

    std::vector<std::string> run() {
        if (zigzags_.empty()) return {"--fair-seams: no edge zigzags, all tiles stay as they are"};
        drop_one_sided();
        for (const Zigzag& zigzag : zigzags_) {
            LaidTile& laid = laid_[at(zigzag.tile)];
            if (laid.flat.rows() == 0) laid = lay(tile(zigzag.tile));
            if (laid.flat.rows() == 0) failure_[at(zigzag.tile)] = "it could not be laid flat";
        }
        while (!try_all()) {
        }
        return finish();
    }

  private:
    const Tile& tile(int t) const { return envelope_.tiles[at(t)]; }

    /// Moves the zigzags of tiles that have not failed. Returns false if another tile failed.
    bool try_all() {
        Places moves(tolerance_);
        std::vector<bool> touched(envelope_.tiles.size(), false);
        for (const Zigzag& zigzag : zigzags_)
            if (failure_[at(zigzag.tile)].empty()) add_moves(zigzag, moves);
        for (std::size_t t = 0; t < envelope_.tiles.size(); ++t)
            touched[t] =
                std::any_of(envelope_.tiles[t].boundary.begin(), envelope_.tiles[t].boundary.end(),
                            [&](int v) { return moves.find(envelope_.tiles[t].mesh.positions.row(v)).has_value(); });
        made_.clear();
        bool all = true;
        for (std::size_t t = 0; t < touched.size(); ++t) {
            if (!touched[t]) continue;
            try {
                if (envelope_.tiles[t].grain.field.rows() > 0)
                    throw std::runtime_error("each of its triangles has a warp of its own");
                if (!envelope_.tiles[t].compensation.chains.empty())
                    throw std::runtime_error("its edges are compensated one by one");
                if (laid_[t].flat.rows() == 0) laid_[t] = lay(envelope_.tiles[t]);
                if (laid_[t].flat.rows() == 0) throw std::runtime_error("it could not be laid flat");
                made_.emplace(t, moved_tile(envelope_.tiles[t], laid_[t], moves));
            } catch (const std::exception& error) {
                give_up(static_cast<int>(t), error.what());
                all = false;
            }
        }
        return all;
    }

    bool lies_on_boundary(int t, const Vec3& point) const {
        const std::vector<int>& boundary = tile(t).boundary;
        return std::any_of(boundary.begin(), boundary.end(),
                           [&](int v) { return (Vec3(tile(t).mesh.positions.row(v)) - point).norm() <= tolerance_; });
    }

    /// Restores both sides if they do not have the same vertices.
    void drop_one_sided() {
        std::erase_if(zigzags_, [&](const Zigzag& zigzag) {
            if (zigzag.mate.empty()) return false;
            const auto mate = std::find_if(envelope_.tiles.begin(), envelope_.tiles.end(),
                                           [&](const Tile& other) { return other.name == zigzag.mate; });
            const bool shared = std::all_of(zigzag.vertices.begin(), zigzag.vertices.end(), [&](int v) {
                return lies_on_boundary(static_cast<int>(mate - envelope_.tiles.begin()),
                                        tile(zigzag.tile).mesh.positions.row(v));
            });
            if (!shared) failure_[at(zigzag.tile)] = zigzag.mate + " has different vertices along it";
            return !shared;
        });
    }

    /// Keeps a failed tile, and the zigzags of its neighbours that run along it.
    void give_up(int t, const std::string& why) {
        failure_[at(t)] = why;
        std::erase_if(zigzags_, [&](const Zigzag& zigzag) {
            return zigzag.tile == t || std::any_of(zigzag.vertices.begin(), zigzag.vertices.end(), [&](int v) {
                       return lies_on_boundary(t, tile(zigzag.tile).mesh.positions.row(v));
                   });
        });
    }

    void add_moves(const Zigzag& zigzag, Places& moves) const {
        const Tile& mine = tile(zigzag.tile);
        const LaidTile& laid = laid_[at(zigzag.tile)];
        const Points2 chain = laid.flat(zigzag.vertices, Eigen::all), fair = fair_points(chain, zigzag.closed);
        const std::size_t skip = zigzag.closed ? 0 : 1;
        for (std::size_t i = skip; i + skip < zigzag.vertices.size(); ++i) {
            const int v = zigzag.vertices[i];
            const Vec3 here = mine.mesh.positions.row(v);
            if (moves.find(here)) continue;  // moved by the neighbour's zigzag
            const Frame frame = frame_at(mine, laid, v);
            const Vec2 step = fair.row(static_cast<Eigen::Index>(i)) - chain.row(static_cast<Eigen::Index>(i));
            moves.add(here, here + step.dot(frame.flat_along) * frame.along + step.dot(frame.flat_left) * frame.left);
        }
    }

    std::vector<std::string> finish() {
        std::vector<std::string> remarks;
        for (const auto& [t, made] : made_) {
            double farthest = 0;
            for (std::size_t i = 0; i < made.boundary.size(); ++i)
                farthest = std::max(farthest, (made.mesh.positions.row(static_cast<Eigen::Index>(i)) -
                                               envelope_.tiles[t].mesh.positions.row(envelope_.tiles[t].boundary[i]))
                                                  .norm());
            remarks.push_back("tile " + made.name +
                              " cut along a fair curve where its edge zigzagged: vertices moved by up to " +
                              format_fixed(farthest / millimetre, 1) + " mm, area " +
                              format_fixed(surface_area(envelope_.tiles[t].mesh), 4) + " to " +
                              format_fixed(surface_area(made.mesh), 4) + " m2");
        }
        for (std::size_t t = 0; t < failure_.size(); ++t)
            if (!failure_[t].empty())
                remarks.push_back("tile " + envelope_.tiles[t].name + " not cut along a fair curve: " + failure_[t]);
        if (remarks.size() > most_remarks) {
            const std::string rest = std::to_string(remarks.size() - most_remarks);
            remarks.resize(most_remarks);
            remarks.push_back("and " + rest + " more tiles like these");
        }
        for (auto& [t, made] : made_) envelope_.tiles[t] = std::move(made);
        if (!made_.empty()) {
            envelope_.seams.clear();
            add_seams(envelope_, {tolerance_});
        }
        return remarks;
    }

    Envelope& envelope_;
    double tolerance_;
    std::vector<Zigzag> zigzags_;
    std::vector<LaidTile> laid_;
    std::vector<std::string> failure_;
    std::map<std::size_t, Tile> made_;
};

}  // namespace

std::vector<std::string> fair_seams(Envelope& envelope, double seam_tolerance) {
    return Fairing(envelope, seam_tolerance).run();
}

}  // namespace ripstop
