#include "ripstop/design/special/special_march.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "ripstop/base/error.h"
#include "ripstop/base/index.h"
#include "ripstop/base/parallel.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"

namespace ripstop {
namespace {

using Node = std::array<std::int64_t, 3>;

/// Paths along the three axes in each order: the corners on a path are a tetrahedron of the cube.
constexpr int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};

class Grid {
  public:
    Grid(const SpecialBody& body, double step) : step_(step) {
        const auto [low, high] = body.box();
        // An offset by irrational fractions of a step, so that nodes hardly ever lie on the surface.
        origin_ = low - step * Vec3(1.3819660, 1.2360680, 1.4721360);
        double nodes = 1;
        for (int axis = 0; axis < 3; ++axis) {
            const double count = std::ceil((high[axis] - origin_[axis]) / step) + 2;
            nodes *= count;
            count_[at(axis)] = static_cast<std::int64_t>(std::min(count, 1e8));
        }
        if (!(nodes <= 20e6))
            throw InputError("the edge length is " + format_shortest(body.shape().edge_length / millimetre) +
                             " mm, which asks for a grid of " + format_fixed(nodes / 1e6, 0) +
                             " million nodes; give one that asks for at most 20");
        levels_.resize(static_cast<std::size_t>(nodes));
        parallel_for(static_cast<int>(count_[2]), 0, [&](int k) {
            for (std::int64_t j = 0; j < count_[1]; ++j)
                for (std::int64_t i = 0; i < count_[0]; ++i) {
                    const Node node{i, j, k};
                    levels_[number(node)] = body.level(place(node));
                }
        });
    }

    const Node& count() const { return count_; }
    std::size_t number(const Node& n) const {
        return static_cast<std::size_t>((n[2] * count_[1] + n[1]) * count_[0] + n[0]);
    }
    Vec3 place(const Node& n) const {
        return origin_ + step_ * Vec3(static_cast<double>(n[0]), static_cast<double>(n[1]), static_cast<double>(n[2]));
    }
    double level(const Node& n) const { return levels_[number(n)]; }
    bool is_inside(const Node& n) const { return level(n) < 0; }

  private:
    double step_;
    Vec3 origin_;
    Node count_{};
    std::vector<double> levels_;
};

class Marching {
  public:
    explicit Marching(const Grid& grid) : grid_(grid) {}

    void tetrahedron(const std::array<Node, 4>& nodes) {
        std::vector<int> in;
        std::vector<int> out;
        for (int k = 0; k < 4; ++k) (grid_.is_inside(nodes[at(k)]) ? in : out).push_back(k);
        if (in.empty() || out.empty()) return;
        const auto node = [&](int k) { return nodes[at(k)]; };
        const Vec3 outward = grid_.place(node(out[0])) - grid_.place(node(in[0]));
        if (in.size() == 2) {
            const int a = vertex(node(in[0]), node(out[0]));
            const int b = vertex(node(in[0]), node(out[1]));
            const int c = vertex(node(in[1]), node(out[1]));
            const int d = vertex(node(in[1]), node(out[0]));
            triangle(a, b, c, outward);
            triangle(a, c, d, outward);
        } else if (in.size() == 1) {
            triangle(vertex(node(in[0]), node(out[0])), vertex(node(in[0]), node(out[1])),
                     vertex(node(in[0]), node(out[2])), outward);
        } else {
            triangle(vertex(node(in[0]), node(out[0])), vertex(node(in[1]), node(out[0])),
                     vertex(node(in[2]), node(out[0])), outward);
        }
    }

    TriangleMesh mesh() const {
        TriangleMesh mesh;
        mesh.positions.resize(static_cast<Eigen::Index>(places_.size()), 3);
        mesh.triangles.resize(static_cast<Eigen::Index>(triangles_.size()), 3);
        for (std::size_t v = 0; v < places_.size(); ++v) mesh.positions.row(static_cast<Eigen::Index>(v)) = places_[v];
        for (std::size_t t = 0; t < triangles_.size(); ++t)
            mesh.triangles.row(static_cast<Eigen::Index>(t)) = triangles_[t];
        return mesh;
    }

  private:
    int vertex(Node a, Node b) {
        if (grid_.number(b) < grid_.number(a)) std::swap(a, b);
        const std::int64_t way = (b[0] - a[0]) + 2 * (b[1] - a[1]) + 4 * (b[2] - a[2]);
        const auto key = static_cast<std::int64_t>(grid_.number(a)) * 8 + way;
        const auto [entry, fresh] = numbers_.try_emplace(key, static_cast<int>(places_.size()));
        if (fresh) {
            const double share = std::clamp(grid_.level(a) / (grid_.level(a) - grid_.level(b)), 0.1, 0.9);
            places_.push_back((1 - share) * grid_.place(a) + share * grid_.place(b));
        }
        return entry->second;
    }

    void triangle(int a, int b, int c, const Vec3& outward) {
        const Vec3& p = places_[at(a)];
        const Vec3 normal = (places_[at(b)] - p).cross(places_[at(c)] - p);
        if (normal.dot(outward) < 0) std::swap(b, c);
        triangles_.emplace_back(a, b, c);
    }

    const Grid& grid_;
    std::unordered_map<std::int64_t, int> numbers_;
    std::vector<Vec3> places_;
    std::vector<Eigen::RowVector3i> triangles_;
};

}  // namespace

TriangleMesh march(const SpecialBody& body, double step) {
    const Grid grid(body, step);
    Marching marching(grid);
    for (std::int64_t k = 0; k + 1 < grid.count()[2]; ++k)
        for (std::int64_t j = 0; j + 1 < grid.count()[1]; ++j)
            for (std::int64_t i = 0; i + 1 < grid.count()[0]; ++i) {
                int inside = 0;
                for (int c = 0; c < 8; ++c) inside += grid.is_inside({i + (c & 1), j + (c >> 1 & 1), k + (c >> 2)});
                if (inside == 0 || inside == 8) continue;
                for (const auto& order : orders) {
                    std::array<Node, 4> nodes;
                    nodes.fill({i, j, k});
                    for (std::size_t step_of = 1; step_of < 4; ++step_of)
                        for (std::size_t later = step_of; later < 4; ++later) ++nodes[later][at(order[step_of - 1])];
                    marching.tetrahedron(nodes);
                }
            }
    return marching.mesh();
}

}  // namespace ripstop
