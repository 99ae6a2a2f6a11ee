#include "ripstop/mesh/components.h"

#include <numeric>

namespace ripstop {

std::vector<int> connected_parts(const TriangleMesh& mesh) {
    std::vector<int> root(static_cast<std::size_t>(mesh.vertex_count()));
    std::iota(root.begin(), root.end(), 0);
    const auto find = [&root](int v) {
        while (root[static_cast<std::size_t>(v)] != v) {
            int& parent = root[static_cast<std::size_t>(v)];
            parent = root[static_cast<std::size_t>(parent)];
            v = parent;
        }
        return v;
    };
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 1; k < 3; ++k)
            root[static_cast<std::size_t>(find(mesh.triangles(t, k)))] = find(mesh.triangles(t, 0));

    std::vector<int> number(root.size(), -1);
    std::vector<int> part(static_cast<std::size_t>(mesh.triangle_count()));
    int parts = 0;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        int& id = number[static_cast<std::size_t>(find(mesh.triangles(t, 0)))];
        if (id < 0) id = parts++;
        part[static_cast<std::size_t>(t)] = id;
    }
    return part;
}

Submesh submesh(const TriangleMesh& mesh, const std::vector<int>& triangles) {
    Submesh result;
    std::vector<int> renumbered(static_cast<std::size_t>(mesh.vertex_count()), -1);
    for (const int t : triangles)
        for (int k = 0; k < 3; ++k) renumbered[static_cast<std::size_t>(mesh.triangles(t, k))] = 0;
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        if (renumbered[static_cast<std::size_t>(v)] < 0) continue;
        renumbered[static_cast<std::size_t>(v)] = static_cast<int>(result.kept.size());
        result.kept.push_back(v);
    }
    result.mesh.positions = mesh.positions(result.kept, Eigen::all);
    result.mesh.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
    for (std::size_t i = 0; i < triangles.size(); ++i)
        for (int k = 0; k < 3; ++k)
            result.mesh.triangles(static_cast<Eigen::Index>(i), k) =
                renumbered[static_cast<std::size_t>(mesh.triangles(triangles[i], k))];
    return result;
}

}  // namespace ripstop
