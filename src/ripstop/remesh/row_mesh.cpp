#include "ripstop/remesh/row_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr double least_facet_agreement = 0.5;  // cosine between a new triangle and the facet below it
constexpr int most_row_triangles = 6000;

/// A vertex of the new mesh and its place on the row.
struct RowVertex {
    int index = 0;
    double along = 0, across = 0;
};
using Line = std::vector<RowVertex>;

class RowMesher {
  public:
    RowMesher(const Tile& tile, const FacetRow& row, const NewBoundary& boundary)
        : tile_(tile), row_(row), boundary_(boundary), count_(static_cast<int>(boundary.nodes.size())) {}

    std::optional<RowMesh> mesh() {
        if (!divide_boundary()) return {};
        place_rungs();
        const Line &first = rungs_.front(), &last = rungs_.back();
        const auto along = [](const RowVertex& v) { return v.along; };
        const auto across = [](const RowVertex& v) { return v.across; };
        // Counter-clockwise: side a runs along the boundary, the start of the row against it.
        stitch(a_, level(0), along);
        stitch(level(first.size() - 1), b_, along);
        stitch(first, start_, across);
        stitch(end_, last, across);
        for (std::size_t k = 0; k + 1 < rungs_.size(); ++k) stitch(rungs_[k + 1], rungs_[k], across);
        return finished();
    }

  private:
    const BoundaryNode& node(int i) const { return boundary_.nodes[static_cast<std::size_t>(i % count_)]; }

    /// Collects the nodes of both sides and both ends, corners in both. Side b and the start run in the direction of
    /// side a and from a to b.
    bool divide_boundary() {
        std::array<int, 4> at{};
        for (std::size_t k = 0; k < 4; ++k) {
            at[k] = -1;
            for (int i = 0; i < count_; ++i)
                if (node(i).place.edge == row_.corners()[k] && node(i).place.share == 0) at[k] = i;
            if (at[k] < 0) return false;
        }
        const auto between = [&](int from, int to) {
            std::vector<int> list;
            for (int i = 0; i <= (to - from + count_) % count_; ++i) list.push_back((from + i) % count_);
            return list;
        };
        for (const int i : between(at[0], at[1])) a_.push_back({i, row_.along_a(node(i).place).value_or(0), 0});
        for (const int i : between(at[2], at[3])) b_.push_back({i, row_.along_b(node(i).place).value_or(0), 1});
        std::reverse(b_.begin(), b_.end());
        end_ = end_of(between(at[1], at[2]), row_.cell_count());
        std::vector<int> start = between(at[3], at[0]);
        std::reverse(start.begin(), start.end());
        start_ = end_of(start, 0);
        for (Line* side : {&a_, &b_}) {
            if (side->size() == 1) continue;
            side->front().along = 0;
            side->back().along = row_.cell_count();
            for (std::size_t i = 0; i + 1 < side->size(); ++i)
                if (!((*side)[i].along < (*side)[i + 1].along)) return false;
        }
        return a_.size() + b_.size() > 3;
    }

    Line end_of(const std::vector<int>& nodes, double along) const {
        std::vector<double> length{0};
        for (std::size_t i = 1; i < nodes.size(); ++i)
            length.push_back(length.back() + (node(nodes[i]).position - node(nodes[i - 1]).position).norm());
        Line line;
        for (std::size_t i = 0; i < nodes.size(); ++i)
            line.push_back({nodes[i], along, length.back() > 0 ? length[i] / length.back() : 0});
        return line;
    }

    /// The offset from the row's own side to the side of the new nodes, which may lie on a neighbour's curve.
    Vec3 offset_of(const Line& side, double along) const {
        const auto off = [&](const RowVertex& v) { return Vec3(node(v.index).position - row_.at(v.along, v.across)); };
        std::size_t i = 1;
        while (i + 1 < side.size() && side[i].along < along) ++i;
        if (side.size() == 1) return off(side[0]);
        const double share = (along - side[i - 1].along) / (side[i].along - side[i - 1].along);
        return (1 - share) * off(side[i - 1]) + share * off(side[i]);
    }

    void place_rungs() {
        const Line& finer = a_.size() >= b_.size() ? a_ : b_;
        std::vector<double> stations;
        for (std::size_t i = 1; i + 1 < finer.size(); ++i) stations.push_back(finer[i].along);
        if (stations.empty()) stations.push_back(row_.cell_count() / 2.0);
        double across = 0, along = 0;
        for (std::size_t i = 0; i + 1 < finer.size(); ++i)
            along += (node(finer[i + 1].index).position - node(finer[i].index).position).norm();
        for (const double station : stations) across += (row_.at(station, 1) - row_.at(station, 0)).norm();
        const double columns = static_cast<double>(stations.size()) + 1, mean = across / (columns - 1);
        const int rows = static_cast<int>(
            std::clamp(std::round(mean * columns / along), 2.0, std::max(2.0, most_row_triangles / (2 * columns))));
        vertices_.resize(static_cast<std::size_t>(count_));
        for (const Line* side : {&a_, &b_, &start_, &end_})
            for (const RowVertex& v : *side) vertices_[static_cast<std::size_t>(v.index)] = node(v.index).position;
        for (const double station : stations) {
            const Vec3 from = row_.at(station, 0) + offset_of(a_, station),
                       to = row_.at(station, 1) + offset_of(b_, station);
            rungs_.emplace_back();
            for (int j = 1; j < rows; ++j) {
                const double share = static_cast<double>(j) / rows;
                rungs_.back().push_back({static_cast<int>(vertices_.size()), station, share});
                vertices_.push_back((1 - share) * from + share * to);
                distance_ = std::max(distance_, (vertices_.back() - row_.faceted_at(station, share)).norm());
            }
        }
        for (const Line* side : {&a_, &b_})
            for (const RowVertex& v : *side)
                distance_ = std::max(distance_, (node(v.index).position - row_.faceted_at(v.along, v.across)).norm());
    }

    Line level(std::size_t j) const {
        Line line;
        for (const Line& rung : rungs_) line.push_back(rung[j]);
        return line;
    }

    /// Triangulates the strip between two lines, always advancing on the line whose next vertex comes first. `right`
    /// lies to the right of the direction.
    template <class PlaceVertex>
    void stitch(const Line& right, const Line& left, const PlaceVertex& place) {
        std::size_t i = 0, j = 0;
        while (i + 1 < right.size() || j + 1 < left.size()) {
            bool go_right = j + 1 == left.size();
            if (!go_right && i + 1 < right.size()) {
                const double next_right = place(right[i + 1]), next_left = place(left[j + 1]);
                // If both come together, takes the shorter diagonal.
                go_right = std::abs(next_right - next_left) > 1e-9
                               ? next_right < next_left
                               : apart(right[i + 1], left[j]) <= apart(right[i], left[j + 1]);
            }
            if (go_right) {
                triangles_.push_back({right[i], right[i + 1], left[j]});
                ++i;
            } else {
                triangles_.push_back({right[i], left[j + 1], left[j]});
                ++j;
            }
        }
    }

    double apart(const RowVertex& p, const RowVertex& q) const {
        return (vertices_[static_cast<std::size_t>(p.index)] - vertices_[static_cast<std::size_t>(q.index)]).norm();
    }

    /// The parameter along the row of a triangle's centroid; ignores vertices that form a whole side, which have
    /// none.
    double along_of(const std::array<RowVertex, 3>& triangle) const {
        double sum = 0, count = 0;
        for (const RowVertex& v : triangle) {
            if ((a_.size() == 1 && v.index == a_[0].index) || (b_.size() == 1 && v.index == b_[0].index)) continue;
            sum += v.along;
            ++count;
        }
        return sum / count;
    }

    std::optional<RowMesh> finished() const {
        RowMesh made;
        made.distance_max = distance_;
        made.mesh.positions.resize(static_cast<Eigen::Index>(vertices_.size()), 3);
        for (std::size_t v = 0; v < vertices_.size(); ++v)
            made.mesh.positions.row(static_cast<Eigen::Index>(v)) = vertices_[v];
        made.mesh.triangles.resize(static_cast<Eigen::Index>(triangles_.size()), 3);
        for (std::size_t t = 0; t < triangles_.size(); ++t) {
            const auto& [p, q, r] = triangles_[t];
            made.mesh.triangles.row(static_cast<Eigen::Index>(t)) << p.index, q.index, r.index;
            const Vec3 a = vertices_[static_cast<std::size_t>(p.index)],
                       b = vertices_[static_cast<std::size_t>(q.index)];
            const Vec3 c = vertices_[static_cast<std::size_t>(r.index)], middle = (a + b + c) / 3;
            const int beneath = row_.triangle_near(along_of(triangles_[t]), middle);
            const TriangleMesh& old = tile_.mesh;
            const Vec3 normal = (old.corner(beneath, 1) - old.corner(beneath, 0))
                                    .cross(old.corner(beneath, 2) - old.corner(beneath, 0))
                                    .normalized();
            if (!((b - a).cross(c - a).normalized().dot(normal) > least_facet_agreement)) return {};
            made.origin.push_back(beneath);
        }
        return made;
    }

    const Tile& tile_;
    const FacetRow& row_;
    const NewBoundary& boundary_;
    int count_;
    Line a_, b_, start_, end_;
    std::vector<Line> rungs_;
    std::vector<Vec3> vertices_;
    std::vector<std::array<RowVertex, 3>> triangles_;
    double distance_ = 0;
};

}  // namespace

std::optional<RowMesh> mesh_row(const Tile& tile, const FacetRow& row, const NewBoundary& boundary) {
    return RowMesher(tile, row, boundary).mesh();
}

}  // namespace ripstop
