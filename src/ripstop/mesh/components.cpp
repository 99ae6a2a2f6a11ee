#include "ripstop/mesh/components.h"

#include "ripstop/base/union_find.h"

namespace ripstop {

std::vector<int> connected_parts(const TriangleMesh& mesh) {
    UnionFind sets(at(mesh.vertex_count()));
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 1; k < 3; ++k) sets.join(mesh.triangles(t, k), mesh.triangles(t, 0));

    std::vector<int> number(at(mesh.vertex_count()), -1), part;
    int parts = 0;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        int& id = number[at(sets.root(mesh.triangles(t, 0)))];
        if (id < 0) id = parts++;
        part.push_back(id);
    }
    return part;
}

}  // namespace ripstop
