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

}  // namespace ripstop
