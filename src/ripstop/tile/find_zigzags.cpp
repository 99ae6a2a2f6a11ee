#include "ripstop/tile/find_zigzags.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "ripstop/base/index.h"
#include "ripstop/mesh/boundary.h"
#include "ripstop/model/tile/corner_turn.h"

namespace ripstop {
namespace {

constexpr double turns_at_all = 6 * degree;
constexpr int farthest = 6;  // edges between consecutive turns
constexpr int fewest_changes = 4;
constexpr double changing_share = 0.55;
constexpr double highest = 0.25;  // height of the teeth, relative to the size of the run
constexpr double strays = 1;      // largest distance from the fair curve, in longest edges
constexpr int margin = 2;         // edges added to a run before its first and after its last turn

/// The neighbour along a boundary edge: the mate, the seam and which of its sides this is.
struct Along {
    int mate = -1;
    bool second = false;
    int seam = -1;

    bool goes_on_in(const Along& next) const { return mate == next.mate && second == next.second; }
};

std::vector<std::vector<Along>> along_boundaries(const std::vector<const Tile*>& tiles,
                                                 const std::vector<Seam>& seams) {
    std::vector<std::vector<Along>> along;
    for (const Tile* tile : tiles) along.emplace_back(tile->boundary.size());
    for (std::size_t s = 0; s < seams.size(); ++s)
        for (const bool second : {false, true}) {
            const SeamSide& side = second ? seams[s].b : seams[s].a;
            const int mate = second ? seams[s].a.tile : seams[s].b.tile;
            for (const SeamPart& part : side.parts)
                along[at(side.tile)][at(part.edge)] = {mate, second && mate == side.tile, static_cast<int>(s)};
        }
    return along;
}

class Finder {
  public:
    Finder(const std::vector<const Tile*>& tiles, std::size_t index, const std::vector<Along>& along,
           const std::vector<Seam>& seams)
        : tiles_(tiles),
          tile_(*tiles[index]),
          index_(static_cast<int>(index)),
          along_(along),
          seams_(seams),
          turning_(surface_turning(tile_.mesh, tile_.boundary)),
          size_(static_cast<int>(tile_.boundary.size())) {}

    std::vector<Zigzag> find() {
        const std::vector<int> breaks = find_breaks();
        if (breaks.empty()) {
            search_loop();
        } else {
            for (std::size_t i = 0; i < breaks.size(); ++i) {
                const int next = i + 1 < breaks.size() ? breaks[i + 1] : breaks.front() + size_;
                search(breaks[i], next);
            }
        }
        return std::move(found_);
    }

  private:
    double turn(int i) const { return turning_[i % size_]; }
    bool turns(int i) const { return std::abs(turn(i)) > turns_at_all; }
    Vec3 point(int i) const { return tile_.mesh.positions.row(tile_.boundary[at((i + size_) % size_)]); }

    /// The places where the neighbour changes, and the corners if they were given (then sharp turns do not count).
    std::vector<int> find_breaks() const {
        std::vector<bool> corner(static_cast<std::size_t>(tile_.mesh.vertex_count()), false);
        if (tile_.chains.size() > 1)
            for (const Chain& chain : tile_.chains) corner[at(chain.vertices.front())] = true;
        const auto is_corner = [&](int i) { return corner[at(tile_.boundary[at(i)])]; };
        bool given = false;
        for (int i = 0; i < size_; ++i) given = given || is_corner(i) != (std::abs(turn(i)) > corner_turn);
        std::vector<int> breaks;
        for (int i = 0; i < size_; ++i) {
            const Along& before = along_[at((i + size_ - 1) % size_)];
            if (!before.goes_on_in(along_[at(i)]) || (given && is_corner(i))) breaks.push_back(i);
        }
        return breaks;
    }

    /// Searches a boundary without breaks: cuts it open at a long straight part, or treats it as one closed run.
    void search_loop() {
        int straight = 0;
        for (int i = 0; i < 2 * size_; ++i) {
            straight = turns(i) ? 0 : straight + 1;
            if (straight <= farthest) continue;
            search(i, i + size_);
            return;
        }
        std::vector<int> sharp;
        for (int i = 0; i < size_; ++i)
            if (turns(i)) sharp.push_back(i);
        if (sharp.empty()) return;
        sharp.push_back(sharp.front() + size_);
        if (size_ >= 6 && alternates(sharp)) add(0, size_, true);
    }

    /// Searches between two vertices of the boundary.
    void search(int from, int to) {
        std::vector<int> group;
        const auto close = [&] {
            if (alternates(group))
                add(std::max(from, group.front() - margin), std::min(to, group.back() + margin), false);
            group.clear();
        };
        for (int i = from + 1; i < to; ++i) {
            if (!turns(i)) continue;
            if (!group.empty() && i - group.back() > farthest) close();
            group.push_back(i);
        }
        close();
    }

    bool alternates(const std::vector<int>& sharp) const {
        int changes = 0;
        for (std::size_t k = 1; k < sharp.size(); ++k)
            changes += (turn(sharp[k - 1]) > 0) != (turn(sharp[k]) > 0) ? 1 : 0;
        return changes >= fewest_changes && changes >= changing_share * static_cast<double>(sharp.size() - 1);
    }

    void add(int from, int to, bool closed) {
        Zigzag zigzag{index_, tile_.name, {}, closed, from % size_, {}, {}, 0, 0, 0};
        const int mate = along_[at(from % size_)].mate;
        if (mate >= 0) zigzag.mate = tiles_[at(mate)]->name;
        for (int i = from; i < to + (closed ? 0 : 1); ++i) zigzag.vertices.push_back(tile_.boundary[at(i % size_)]);
        double longest = 0;
        for (int i = from; i < to; ++i) {
            const int seam = along_[at(i % size_)].seam;
            if (seam >= 0) {
                const std::string& id = seams_[at(seam)].id;
                if (zigzag.seams.empty() || zigzag.seams.back() != id) zigzag.seams.push_back(id);
            }
            const double edge = (point(i + 1) - point(i)).norm();
            longest = std::max(longest, edge);
            zigzag.length += edge;
            if (!turns(i) || (!closed && i == from)) continue;
            const Vec3 line = (point(i + 1) - point(i - 1)).normalized(), up = point(i) - point(i - 1);
            zigzag.teeth = std::max(zigzag.teeth, (up - up.dot(line) * line).norm());
        }
        const Points3 points = tile_.mesh.positions(zigzag.vertices, Eigen::all);
        if (zigzag.teeth > highest * (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm()) return;
        const FairCurve curve(layout_of(zigzag, tile_, turning_));
        if (curve.line().moves.rowwise().norm().maxCoeff() > strays * longest) return;
        zigzag.fair_length = curve.line().length;
        found_.push_back(std::move(zigzag));
    }

    const std::vector<const Tile*>& tiles_;
    const Tile& tile_;
    int index_;
    const std::vector<Along>& along_;
    const std::vector<Seam>& seams_;
    Eigen::VectorXd turning_;
    int size_;
    std::vector<Zigzag> found_;
};

}  // namespace

std::vector<Zigzag> find_zigzags(const std::vector<const Tile*>& tiles, const std::vector<Seam>& seams) {
    const std::vector<std::vector<Along>> along = along_boundaries(tiles, seams);
    std::vector<Zigzag> all;
    for (std::size_t t = 0; t < tiles.size(); ++t)
        for (Zigzag& zigzag : Finder(tiles, t, along[t], seams).find()) all.push_back(std::move(zigzag));
    return all;
}

std::vector<Zigzag> find_zigzags(const std::vector<Tile>& tiles, const std::vector<Seam>& seams) {
    std::vector<const Tile*> each;
    for (const Tile& tile : tiles) each.push_back(&tile);
    return find_zigzags(each, seams);
}

ChainLayout layout_of(const Zigzag& zigzag, const Tile& tile, const Eigen::VectorXd& turning) {
    ChainLayout layout;
    layout.closed = zigzag.closed;
    layout.lengths = edge_lengths(tile.mesh.positions, zigzag.closed ? closed(zigzag.vertices) : zigzag.vertices);
    layout.turns.resize(static_cast<Eigen::Index>(zigzag.vertices.size()));
    for (Eigen::Index i = 0; i < layout.turns.size(); ++i)
        layout.turns[i] = turning[(zigzag.first + i) % turning.size()];
    return layout;
}

}  // namespace ripstop
