#include "ripstop/mesh/disk.h"

#include <algorithm>

#include "ripstop/base/error.h"
#include "ripstop/base/index.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/mesh/components.h"

namespace ripstop {
namespace {

std::string place(const Vec3& at) {
    return "(" + format_fixed(at.x(), 4) + ", " + format_fixed(at.y(), 4) + ", " + format_fixed(at.z(), 4) + ") m";
}

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
    throw InputError("tile " + name + ": " + what);
}

void require_sound_triangles(const TriangleMesh& mesh, const std::string& name) {
    if (mesh.triangle_count() == 0) refuse(name, "has no triangle; a tile is a surface with at least one");
    const double tiny = 1e-14 * bounding_diagonal(mesh);
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const Vec3 a = mesh.corner(t, 0);
        const Vec3 b = mesh.corner(t, 1);
        const Vec3 c = mesh.corner(t, 2);
        const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
        if (!(2 * triangle_area(mesh, t) > tiny * longest))
            refuse(name, "a triangle without area at " + place((a + b + c) / 3) +
                             "; remove degenerate faces in the CAD or mesh the tile again");
    }
}

/// A vertex whose triangles form more than one fan: two parts of the surface touch at a point. -1 if there is none.
int pinched_vertex(const Adjacency& adjacency) {
    for (int v = 0; v < adjacency.vertex_count(); ++v) {
        const std::vector<int> outgoing = adjacency.outgoing(v);
        if (outgoing.empty()) continue;
        int start = outgoing.front();
        for (const int h : outgoing)
            if (adjacency.is_boundary(h)) start = h;
        std::size_t seen = 0;
        int h = start;
        do {
            ++seen;
            h = adjacency.twin(Adjacency::previous(h));
        } while (h >= 0 && h != start && seen <= outgoing.size());
        if (seen != outgoing.size()) return v;
    }
    return -1;
}

}  // namespace

std::vector<std::vector<int>> boundary_loops(const Adjacency& adjacency) {
    std::vector<std::vector<int>> loops;
    std::vector<bool> seen(static_cast<std::size_t>(adjacency.half_edge_count()), false);
    for (int start = 0; start < adjacency.half_edge_count(); ++start) {
        if (!adjacency.is_boundary(start) || seen[at(start)]) continue;
        std::vector<int> loop;
        int h = start;
        do {
            seen[at(h)] = true;
            loop.push_back(adjacency.from(h));
            h = Adjacency::next(h);
            while (!adjacency.is_boundary(h)) h = Adjacency::next(adjacency.twin(h));
        } while (h != start && !seen[at(h)]);
        std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
        loops.push_back(std::move(loop));
    }
    return loops;
}

std::vector<int> require_disk(const TriangleMesh& mesh, const Adjacency& adjacency, const std::string& name) {
    require_sound_triangles(mesh, name);
    const auto at = [&mesh](int v) { return place(mesh.positions.row(v)); };
    if (!adjacency.irregular_edges().empty()) {
        const auto [a, b] = adjacency.irregular_edges().front();
        refuse(name, "the edge from " + at(a) + " to " + at(b) +
                         " belongs to more than two triangles, or to two that face opposite ways; "
                         "split the surface there, or "
                         "unify its normals in the CAD");
    }
    for (int v = 0; v < mesh.vertex_count(); ++v)
        if (adjacency.outgoing(v).empty())
            refuse(name, "the vertex at " + at(v) + " belongs to no triangle; remove stray points");
    const std::vector<int> parts = connected_parts(mesh);
    for (int t = 0; t < mesh.triangle_count(); ++t)
        if (parts[static_cast<std::size_t>(t)] != 0)
            refuse(name, "is in more than one piece; one of them is at " + at(mesh.triangles(t, 0)) +
                             "; give each piece its own name, or join them");
    if (const int v = pinched_vertex(adjacency); v >= 0)
        refuse(name, "two parts of the surface touch only in the point " + at(v) + "; separate or join them there");
    std::vector<std::vector<int>> loops = boundary_loops(adjacency);
    if (loops.empty())
        refuse(name, "is closed; it has no edge to cut along, so draw a seam on it; one of its points is " + at(0));
    if (loops.size() > 1) {
        const auto shortest = std::min_element(loops.begin(), loops.end(), [&mesh](const auto& a, const auto& b) {
            const auto length = [&mesh](const std::vector<int>& loop) {
                double sum = 0;
                for (std::size_t i = 0; i < loop.size(); ++i)
                    sum += (mesh.positions.row(loop[i]) - mesh.positions.row(loop[(i + 1) % loop.size()])).norm();
                return sum;
            };
            return length(a) < length(b);
        });
        refuse(name, "has " + std::to_string(loops.size()) + " boundary loops, the shortest through " +
                         at(shortest->front()) + "; a tile has one: close the hole, or cut the tile along a seam");
    }
    const int euler = mesh.vertex_count() - static_cast<int>(adjacency.edges().size()) + mesh.triangle_count();
    if (euler != 1)
        refuse(name, "has a handle (Euler number " + std::to_string(euler) + ", a disk has 1), near " +
                         at(loops.front().front()) + "; cut it along a seam");
    return loops.front();
}

}  // namespace ripstop
