#include "ripstop/design/special/special_tiles.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

#include "ripstop/base/index.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/base/union_find.h"
#include "ripstop/geometry/triangle.h"

namespace ripstop {
namespace {

bool is_one_piece(const BodyCell& a, const BodyCell& b) {
    return a.below || b.below ? a.below == b.below : a == b;
}

/// A connected set of triangles of one cell.
struct Piece {
    BodyCell cell;
    double area = 0;
    std::map<int, double> borders;  ///< border length with each other piece
};

class Pieces {
  public:
    explicit Pieces(WorkSurface& surface) : surface_(surface) {
        gather();
        measure();
        sets_ = UnionFind(all_.size());
    }

    void join_small() {
        std::vector<double> areas;
        for (const Piece& piece : all_)
            if (!piece.cell.below) areas.push_back(piece.area);
        if (areas.empty()) return;
        std::nth_element(areas.begin(), areas.begin() + static_cast<std::ptrdiff_t>(areas.size() / 2), areas.end());
        const double least = areas[areas.size() / 2] / 20;
        std::vector<int> order(all_.size());
        std::iota(order.begin(), order.end(), 0);
        std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return all_[at(a)].area < all_[at(b)].area; });
        for (const int p : order)
            if (!all_[at(p)].cell.below && all_[at(p)].area < least) join(p);
    }

    const std::vector<Piece>& all() const { return all_; }
    bool is_joined(int p) const { return !sets_.is_root(p); }
    int root(int p) { return sets_.root(p); }

  private:
    void gather() {
        std::vector<int> todo;
        for (int first = 0; first < surface_.triangle_count(); ++first) {
            if (!surface_.is_triangle(first) || surface_.tile[at(first)] >= 0) continue;
            const auto number = static_cast<int>(all_.size());
            all_.push_back({surface_.cell[at(first)], 0, {}});
            todo = {first};
            surface_.tile[at(first)] = number;
            while (!todo.empty()) {
                const int t = todo.back();
                todo.pop_back();
                for (int k = 0; k < 3; ++k) {
                    const int u = surface_.twin(3 * t + k) / 3;
                    if (surface_.tile[at(u)] >= 0 || !is_one_piece(surface_.cell[at(t)], surface_.cell[at(u)]))
                        continue;
                    surface_.tile[at(u)] = number;
                    todo.push_back(u);
                }
            }
        }
    }

    void measure() {
        for (int t = 0; t < surface_.triangle_count(); ++t) {
            if (!surface_.is_triangle(t)) continue;
            Piece& piece = all_[at(surface_.tile[at(t)])];
            piece.area += triangle_area(surface_.place(t, 0), surface_.place(t, 1), surface_.place(t, 2));
            for (int k = 0; k < 3; ++k)
                if (const int other = surface_.tile[at(surface_.twin(3 * t + k) / 3)]; other != surface_.tile[at(t)])
                    piece.borders[other] += surface_.length(3 * t + k);
        }
    }

    void join(int p) {
        std::map<int, double> borders;
        for (const auto& [other, length] : all_[at(p)].borders)
            if (const int now = root(other); now != p && !all_[at(now)].cell.below) borders[now] += length;
        int best = -1;
        for (const auto& [other, length] : borders) {
            const auto rank = [&](int q) { return all_[at(q)].cell.face == all_[at(p)].cell.face; };
            if (best < 0 || std::pair(rank(other), length) > std::pair(rank(best), borders[best])) best = other;
        }
        if (best < 0) return;
        sets_.join_into(p, best);
        all_[at(best)].area += all_[at(p)].area;
        for (const auto& [other, length] : all_[at(p)].borders) all_[at(best)].borders[other] += length;
    }

    WorkSurface& surface_;
    std::vector<Piece> all_;
    UnionFind sets_;
};

}  // namespace

std::vector<SpecialTile> number_tiles(WorkSurface& surface, const SpecialBody& body) {
    std::fill(surface.tile.begin(), surface.tile.end(), -1);
    Pieces pieces(surface);
    pieces.join_small();
    std::vector<int> order;
    for (int p = 0; p < static_cast<int>(pieces.all().size()); ++p)
        if (!pieces.is_joined(p) && !pieces.all()[at(p)].cell.below) order.push_back(p);
    const auto key = [&](int p) {
        const BodyCell& cell = pieces.all()[at(p)].cell;
        return std::tuple(body.primitive_number(cell.face), cell.sector, cell.face, cell.ring);
    };
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return key(a) < key(b); });
    std::vector<int> tile_of(pieces.all().size(), -1);
    std::vector<SpecialTile> tiles;
    for (const int p : order) {
        const BodyCell& cell = pieces.all()[at(p)].cell;
        const bool is_further = !tiles.empty() && tiles.back().cell == cell;
        tile_of[at(p)] = static_cast<int>(tiles.size());
        tiles.push_back({cell, is_further ? tiles.back().nth + 1 : 0});
    }
    for (int t = 0; t < surface.triangle_count(); ++t)
        if (surface.is_triangle(t)) surface.tile[at(t)] = tile_of[at(pieces.root(surface.tile[at(t)]))];
    return tiles;
}

std::vector<BodyCurve> draw_curves(WorkSurface& surface, const SpecialBody& body) {
    std::vector<BodyCurve> curves;
    for (int h = 0; h < surface.half_edge_count(); ++h) {
        if (!surface.is_edge(h)) continue;
        const int t = h / 3;
        const int u = surface.twin(h) / 3;
        const BodyCell& one = surface.cell[at(t)];
        const BodyCell& other = surface.cell[at(u)];
        int number = -1;
        if (surface.tile[at(t)] != surface.tile[at(u)] || one.face != other.face) {
            const Vec3 middle = (surface.position[at(surface.from(h))] + surface.position[at(surface.to(h))]) / 2;
            const BodyCurve curve = body.curve_between(one, other, middle);
            const auto found = std::find(curves.begin(), curves.end(), curve);
            number = static_cast<int>(found - curves.begin());
            if (found == curves.end()) curves.push_back(curve);
        }
        surface.draw(h, number);
    }
    return curves;
}

std::string tile_name(const SpecialBody& body, const SpecialTile& tile) {
    const SpecialBody::Face& face = body.faces()[at(tile.cell.face)];
    const SpecialPrimitive& primitive = body.shape().primitives[at(face.primitive)];
    std::string name = primitive.name + "-S" + padded(at(tile.cell.sector + 1), at(primitive.sectors));
    name += face.part == 1   ? "BASE"
            : face.part == 2 ? "TOP"
                             : "R" + padded(at(tile.cell.ring + 1), at(primitive.rings));
    if (tile.nth > 25) return name + "-" + std::to_string(tile.nth + 1);
    return tile.nth > 0 ? name + static_cast<char>('a' + tile.nth) : name;
}

std::vector<NamedMesh> tile_meshes(const WorkSurface& surface, const SpecialBody& body,
                                   const std::vector<SpecialTile>& tiles) {
    std::vector<std::vector<int>> members(tiles.size());
    for (int t = 0; t < surface.triangle_count(); ++t)
        if (surface.is_triangle(t) && surface.tile[at(t)] >= 0) members[at(surface.tile[at(t)])].push_back(t);
    std::vector<NamedMesh> meshes;
    std::vector<int> number(surface.position.size(), -1);
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        std::vector<int> vertices;
        TriangleMesh mesh;
        mesh.triangles.resize(static_cast<Eigen::Index>(members[i].size()), 3);
        for (std::size_t m = 0; m < members[i].size(); ++m)
            for (int k = 0; k < 3; ++k) {
                const int v = surface.corner(members[i][m], k);
                if (number[at(v)] < 0) {
                    number[at(v)] = static_cast<int>(vertices.size());
                    vertices.push_back(v);
                }
                mesh.triangles(static_cast<Eigen::Index>(m), k) = number[at(v)];
            }
        mesh.positions.resize(static_cast<Eigen::Index>(vertices.size()), 3);
        for (std::size_t v = 0; v < vertices.size(); ++v) {
            mesh.positions.row(static_cast<Eigen::Index>(v)) = surface.position[at(vertices[v])];
            number[at(vertices[v])] = -1;
        }
        meshes.push_back({tile_name(body, tiles[i]), std::move(mesh), {}});
    }
    return meshes;
}

}  // namespace ripstop
