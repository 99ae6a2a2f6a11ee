#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "meshing.h"

namespace ripstop::cad {
namespace {

/// The other triangle at an edge, and whether both traverse it in the same direction, so that one of them must be
/// turned.
struct Neighbour {
    std::size_t face;
    bool against;
};

std::vector<std::vector<Neighbour>> neighbours_of(const std::vector<Triangles>& faces, std::vector<bool>& open) {
    struct Use {
        std::size_t face;
        bool forward;
    };
    std::map<std::pair<int, int>, std::vector<Use>> edges;
    for (std::size_t f = 0; f < faces.size(); ++f)
        for (Eigen::Index t = 0; t < faces[f].rows(); ++t)
            for (int k = 0; k < 3; ++k) {
                const int a = faces[f](t, k), b = faces[f](t, (k + 1) % 3);
                edges[std::minmax(a, b)].push_back({f, a < b});
            }
    std::vector<std::vector<Neighbour>> neighbours(faces.size());
    open.assign(faces.size(), false);
    for (const auto& [edge, uses] : edges) {
        if (uses.size() != 2) {
            for (const Use& use : uses) open[use.face] = true;
            continue;
        }
        if (uses[0].face == uses[1].face) continue;
        const bool against = uses[0].forward == uses[1].forward;
        neighbours[uses[0].face].push_back({uses[1].face, against});
        neighbours[uses[1].face].push_back({uses[0].face, against});
    }
    return neighbours;
}

struct Sums {
    double area = 0, volume = 0;
};

Sums sums_of(const Points3& positions, const Triangles& triangles, const Vec3& origin) {
    Sums sums;
    for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
        const Vec3 a = positions.row(triangles(t, 0)).transpose() - origin,
                   b = positions.row(triangles(t, 1)).transpose() - origin,
                   c = positions.row(triangles(t, 2)).transpose() - origin;
        sums.area += (b - a).cross(c - a).norm() / 2;
        sums.volume += a.dot(b.cross(c)) / 6;
    }
    return sums;
}

}  // namespace

std::vector<bool> agree(const Points3& positions, std::vector<Triangles>& faces) {
    std::vector<bool> open, seen(faces.size(), false), turned(faces.size(), false);
    const auto neighbours = neighbours_of(faces, open);
    const Vec3 origin = positions.rows() > 0 ? Vec3(positions.colwise().mean()) : Vec3(0, 0, 0);
    for (std::size_t first = 0; first < faces.size(); ++first) {
        if (seen[first] || faces[first].rows() == 0) continue;
        std::vector<std::size_t> shell{first};
        seen[first] = true;
        for (std::size_t i = 0; i < shell.size(); ++i)
            for (const Neighbour& next : neighbours[shell[i]]) {
                if (seen[next.face]) continue;
                seen[next.face] = true;
                turned[next.face] = turned[shell[i]] != next.against;
                shell.push_back(next.face);
            }
        double kept = 0, against = 0, volume = 0;
        bool closed = true;
        for (const std::size_t face : shell) {
            const Sums sums = sums_of(positions, faces[face], origin);
            (turned[face] ? against : kept) += sums.area;
            volume += turned[face] ? -sums.volume : sums.volume;
            closed = closed && !open[face];
        }
        if (closed ? volume < 0 : against > kept)
            for (const std::size_t face : shell) turned[face] = !turned[face];
    }
    for (std::size_t f = 0; f < faces.size(); ++f)
        if (turned[f]) faces[f].col(1).swap(faces[f].col(2));
    return turned;
}

}  // namespace ripstop::cad
