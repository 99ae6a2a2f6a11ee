#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "ripstop/base/text/units.h"
#include "ripstop/geometry/angle.h"
#include "ripstop/remesh/facet_row.h"

namespace ripstop {
namespace {

constexpr double flat_turn = 0.2 * degree;
constexpr double flat_share = 0.5;  // relative to the sharpest edge beside it
constexpr double straight = 1e-3;   // relative to a crease's length
constexpr double same_foot = 1e-6;  // relative to a side's length

}  // namespace

class RowFinder {
  public:
    RowFinder(const Tile& tile, const Adjacency& adjacency)
        : tile_(tile),
          adjacency_(adjacency),
          place_(static_cast<std::size_t>(tile.mesh.vertex_count()), -1),
          count_(static_cast<int>(tile.boundary.size())) {
        for (int i = 0; i < count_; ++i) place_[static_cast<std::size_t>(vertex(i))] = i;
    }

    /// Returns false if the facets do not form a row.
    bool find(FacetRow& row) {
        measure_turns();
        join_facets();
        if (!order_facets() || !order_creases() || !find_ends() || !goes_round_once()) return false;
        std::vector<int> position(order_.size());
        for (std::size_t k = 0; k < order_.size(); ++k)
            position[static_cast<std::size_t>(order_[k])] = static_cast<int>(k);
        for (const int f : facet_) row.facet_.push_back(position[static_cast<std::size_t>(f)]);
        row.first_cell_.push_back(0);
        for (std::size_t k = 0; k < order_.size(); ++k) {
            for (const FacetRow::Cell& cell : cells_between(rungs_[k], rungs_[k + 1])) row.cells_.push_back(cell);
            row.first_cell_.push_back(row.cell_count());
        }
        row.corners_ = {rungs_.front().a, rungs_.back().a, rungs_.back().b, rungs_.front().b};
        return true;
    }

  private:
    /// A crease or an end, from side a to side b, as places in the boundary.
    struct Rung {
        int a, b;
    };

    int vertex(int place) const { return tile_.boundary[static_cast<std::size_t>((place + count_) % count_)]; }
    Vec3 point(int place) const { return tile_.mesh.positions.row(vertex(place)); }
    int forward(int from, int to) const { return (to - from + count_) % count_; }
    bool is_bent(int h) const {
        if (adjacency_.is_boundary(h)) return false;
        double most = 0;
        for (const int side : {h, adjacency_.twin(h)})
            for (const int other : {Adjacency::next(side), Adjacency::previous(side)})
                most = std::max(most, turn_[static_cast<std::size_t>(other)]);
        return turn_[static_cast<std::size_t>(h)] > std::max(flat_turn, flat_share * most);
    }

    void measure_turns() {
        const TriangleMesh& mesh = tile_.mesh;
        const auto normal = [&](int t) {
            return Vec3((mesh.corner(t, 1) - mesh.corner(t, 0)).cross(mesh.corner(t, 2) - mesh.corner(t, 0)));
        };
        turn_.assign(static_cast<std::size_t>(adjacency_.half_edge_count()), 0);
        for (int h = 0; h < adjacency_.half_edge_count(); ++h)
            if (!adjacency_.is_boundary(h))
                turn_[static_cast<std::size_t>(h)] =
                    angle_between(normal(Adjacency::triangle(h)), normal(Adjacency::triangle(adjacency_.twin(h))));
    }

    void join_facets() {
        facet_.assign(static_cast<std::size_t>(tile_.mesh.triangle_count()), -1);
        for (int t = 0; t < tile_.mesh.triangle_count(); ++t) {
            if (facet_[static_cast<std::size_t>(t)] >= 0) continue;
            std::vector<int> open{t};
            facet_[static_cast<std::size_t>(t)] = facets_;
            while (!open.empty()) {
                const int from = open.back();
                open.pop_back();
                for (int k = 0; k < 3; ++k) {
                    const int h = 3 * from + k;
                    if (adjacency_.is_boundary(h) || is_bent(h)) continue;
                    int& other = facet_[static_cast<std::size_t>(Adjacency::triangle(adjacency_.twin(h)))];
                    if (other >= 0) continue;
                    other = facets_;
                    open.push_back(Adjacency::triangle(adjacency_.twin(h)));
                }
            }
            ++facets_;
        }
    }

    /// Sorts the facets from one end of the row to the other.
    bool order_facets() {
        for (int h = 0; h < adjacency_.half_edge_count(); ++h) {
            if (!is_bent(h)) continue;
            const int one = facet_[static_cast<std::size_t>(Adjacency::triangle(h))];
            const int other = facet_[static_cast<std::size_t>(Adjacency::triangle(adjacency_.twin(h)))];
            if (one == other) return false;
            creases_[{one, other}].push_back(h);
        }
        std::vector<std::vector<int>> beside(static_cast<std::size_t>(facets_));
        for (const auto& [pair, edges] : creases_) beside[static_cast<std::size_t>(pair[0])].push_back(pair[1]);
        int start = -1;
        for (int f = facets_ - 1; f >= 0; --f) {
            if (beside[static_cast<std::size_t>(f)].size() > 2) return false;
            if (beside[static_cast<std::size_t>(f)].size() == 1) start = f;
        }
        if (start < 0) return false;
        for (int f = start, before = -1; f >= 0;) {
            order_.push_back(f);
            int next = -1;
            for (const int other : beside[static_cast<std::size_t>(f)])
                if (other != before) next = other;
            before = f;
            f = next;
        }
        return static_cast<int>(order_.size()) == facets_;
    }

    /// Turns each crease into a straight path from boundary to boundary, in the orientation of the facet before it,
    /// so that it begins where the boundary of the following facets begins.
    bool order_creases() {
        rungs_.push_back({});
        for (std::size_t k = 0; k + 1 < order_.size(); ++k) {
            std::map<int, int> next;
            std::map<int, int> ends;
            for (const int h : creases_.at({order_[k], order_[k + 1]})) {
                if (!next.emplace(adjacency_.from(h), adjacency_.to(h)).second) return false;
                ++ends[adjacency_.from(h)];
                --ends[adjacency_.to(h)];
            }
            int first = -1;
            for (const auto& [v, sum] : ends) {
                if (sum == 1 && first >= 0) return false;
                if (sum == 1) first = v;
            }
            if (first < 0) return false;
            std::vector<int> path{first};
            while (next.contains(path.back()) && path.size() <= next.size()) path.push_back(next.at(path.back()));
            if (path.size() != next.size() + 1 || !is_straight(path)) return false;
            const int a = place_[static_cast<std::size_t>(path.front())],
                      b = place_[static_cast<std::size_t>(path.back())];
            if (a < 0 || b < 0) return false;
            for (std::size_t i = 1; i + 1 < path.size(); ++i)
                if (place_[static_cast<std::size_t>(path[i])] >= 0) return false;
            rungs_.push_back({a, b});
        }
        rungs_.push_back({});
        return true;
    }

    bool is_straight(const std::vector<int>& path) const {
        const auto at = [&](int v) { return Vec3(tile_.mesh.positions.row(v)); };
        const Vec3 start = at(path.front()), along = at(path.back()) - start;
        for (const int v : path)
            if (along.cross(at(v) - start).norm() > straight * along.squaredNorm()) return false;
        return true;
    }

    bool find_ends() {
        const std::size_t creases = rungs_.size() - 2;
        const Rung &start = rungs_[1], &last = rungs_[creases];
        const Rung after = creases > 1 ? rungs_[2] : Rung{-1, -1};
        const Rung before = creases > 1 ? rungs_[creases - 1] : Rung{-1, -1};
        // In a zigzag of triangles two creases share a vertex too, but the side continues there.
        const auto stays = [&](int at, int next) { return at == next && is_corner(at); };
        const std::optional<Rung> first =
            end_between(start.b, start.a, stays(start.b, after.b), stays(start.a, after.a));
        const std::optional<Rung> second =
            end_between(last.a, last.b, stays(last.a, before.a), stays(last.b, before.b));
        if (!first || !second) return false;
        rungs_.front() = {first->b, first->a};  // here the boundary arrives from side b
        rungs_.back() = *second;
        return true;
    }

    /// The end of a row on the boundary between two places: the edge between its two corners, or a tip. `from_stays`,
    /// `to_stays`: the creases before it fan out from that place, so the end does too.
    std::optional<Rung> end_between(int from, int to, bool from_stays, bool to_stays) const {
        const int edges = forward(from, to);
        const bool fans_out = (from_stays && is_straight_between(from, from + edges - 1)) ||
                              (to_stays && is_straight_between(from + 1, from + edges));
        if (edges == 3 && !fans_out) return Rung{(from + 1) % count_, (from + 2) % count_};
        std::vector<int> corners;
        for (int i = 1; i < edges; ++i)
            if (is_corner(from + i)) corners.push_back((from + i) % count_);
        if (edges == 2) corners = {(from + 1) % count_};
        if (corners.size() == 1) {
            const int corner = from + forward(from, corners[0]);
            if (from_stays && is_straight_between(from, corner)) return Rung{from, corners[0]};
            if (to_stays && is_straight_between(corner, from + edges)) return Rung{corners[0], to};
            return end_at(corners[0], from, edges);
        }
        if (corners.size() != 2) return {};
        if (!is_straight_between(corners[0], corners[0] + forward(corners[0], corners[1]))) return {};
        return Rung{corners[0], corners[1]};
    }

    bool is_corner(int place) const {
        return std::any_of(tile_.chains.begin(), tile_.chains.end(),
                           [&](const Chain& chain) { return chain.vertices.front() == vertex(place); });
    }

    bool is_straight_between(int first, int last) const {
        std::vector<int> path;
        for (int i = first; i <= last; ++i) path.push_back(vertex(i));
        return is_straight(path);
    }

    /// The end with a single corner of the tile: a tip, or an edge whose other end meets its side at too small an
    /// angle for a corner. Such an edge is straight between sides of one edge each and continues neither of them.
    Rung end_at(int corner, int from, int edges) const {
        const int low = from + 1, high = from + edges - 1;
        const bool begins_or_ends = corner == low % count_ || corner == high % count_;
        if (edges > 2 && begins_or_ends && is_straight_between(low, high) && !is_straight_between(from, high) &&
            !is_straight_between(low, high + 1))
            return {low % count_, high % count_};
        return {corner, corner};
    }

    /// Whether both sides and both ends cover the boundary exactly once.
    bool goes_round_once() const {
        int sum = forward(rungs_.front().b, rungs_.front().a) + forward(rungs_.back().a, rungs_.back().b);
        for (std::size_t k = 0; k + 1 < rungs_.size(); ++k)
            sum += forward(rungs_[k].a, rungs_[k + 1].a) + forward(rungs_[k + 1].b, rungs_[k].b);
        return sum == count_;
    }

    /// The relative arc length of the vertices of a side, 0 to 1, between two rungs; `step` is +1 or -1.
    std::vector<double> shares(int from, int edges, int step) const {
        std::vector<double> along{0};
        for (int i = 0; i < edges; ++i)
            along.push_back(along.back() + (point(from + step * (i + 1)) - point(from + step * i)).norm());
        for (double& share : along) share = along.back() > 0 ? share / along.back() : 0;
        return along;
    }

    /// Locates a fraction of a side: the edge it lies on and the range there, in boundary direction.
    FacetRow::Side side_between(int start, const std::vector<double>& along, int step, double low, double high) const {
        if (along.size() == 1) return {(start + count_) % count_, 0, 0};
        const double middle = (low + high) / 2;
        std::size_t i = 0;
        while (i + 2 < along.size() && along[i + 1] < middle) ++i;
        const double size = along[i + 1] - along[i];
        const double from = std::clamp((low - along[i]) / size, 0.0, 1.0);
        const double to = std::clamp((high - along[i]) / size, 0.0, 1.0);
        const int edge = start + step * static_cast<int>(i);
        if (step > 0) return {(edge + count_) % count_, from, to};
        return {(edge - 1 + count_) % count_, 1 - from, 1 - to};
    }

    std::vector<FacetRow::Cell> cells_between(const Rung& first, const Rung& second) const {
        const std::vector<double> a = shares(first.a, forward(first.a, second.a), 1);
        const std::vector<double> b = shares(first.b, forward(second.b, first.b), -1);
        const bool alike = a.size() == b.size() && a.size() > 1;
        std::vector<double> breaks = a;
        if (!alike) breaks.insert(breaks.end(), b.begin(), b.end());
        if (!alike) breaks.push_back(1);
        std::sort(breaks.begin(), breaks.end());
        std::vector<FacetRow::Cell> cells;
        double low = 0;
        for (std::size_t i = 1; i < breaks.size(); ++i) {
            if (breaks[i] - low < same_foot) continue;
            const double b_low = alike ? b[i - 1] : low, b_high = alike ? b[i] : breaks[i];
            cells.push_back({side_between(first.a, a, 1, low, breaks[i]), side_between(first.b, b, -1, b_low, b_high)});
            low = breaks[i];
        }
        return cells;
    }

    const Tile& tile_;
    const Adjacency& adjacency_;
    std::vector<int> place_;  ///< place of each vertex in the boundary; -1 for interior vertices
    int count_;
    std::vector<double> turn_;  ///< dihedral turn at each half-edge [rad]
    std::vector<int> facet_;
    int facets_ = 0;
    std::map<std::array<int, 2>, std::vector<int>> creases_;  ///< for each pair of facets: the half-edges of the first
                                                              ///< along the second
    std::vector<int> order_;
    std::vector<Rung> rungs_;
};

std::optional<FacetRow> FacetRow::find(const Tile& tile, const Adjacency& adjacency, const BoundarySlopes& slopes) {
    FacetRow row;
    row.tile_ = &tile;
    row.slopes_ = slopes;
    if (!RowFinder(tile, adjacency).find(row)) return {};
    return row;
}

}  // namespace ripstop
