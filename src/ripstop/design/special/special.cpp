#include "ripstop/design/special/special.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

#include "ripstop/base/error.h"
#include "ripstop/base/index.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"
#include "ripstop/design/special/special_cut.h"
#include "ripstop/design/special/special_march.h"
#include "ripstop/design/special/special_relax.h"
#include "ripstop/design/special/special_tiles.h"
#include "ripstop/mesh/adjacency.h"
#include "ripstop/mesh/change/coincident.h"
#include "ripstop/mesh/components.h"
#include "ripstop/mesh/disk.h"

namespace ripstop {
namespace {

std::string listed(const SpecialBody& body, const std::set<int>& primitives) {
    std::string text;
    for (const int p : primitives) text += (text.empty() ? "" : ", ") + body.shape().primitives[at(p)].name;
    return text;
}

int primitive_at(const SpecialBody& body, const Vec3& place) {
    return body.primitive_number(body.owner(place));
}

/// The connected components of the first surface.
struct Parts {
    std::vector<int> of_triangle;
    std::vector<std::set<int>> owners;  ///< primitives that each component shows
    std::vector<double> volume;         ///< six times the enclosed volume; negative for a cavity
    int largest = 0;

    Parts(const SpecialBody& body, const TriangleMesh& mesh) : of_triangle(connected_parts(mesh)) {
        for (int t = 0; t < mesh.triangle_count(); ++t) {
            const std::size_t p = at(of_triangle[at(t)]);
            if (p >= owners.size()) {
                owners.resize(p + 1);
                volume.resize(p + 1);
            }
            volume[p] += mesh.corner(t, 0).dot(mesh.corner(t, 1).cross(mesh.corner(t, 2)));
            owners[p].insert(primitive_at(body, mesh.corner(t, 0)));
        }
        largest = static_cast<int>(std::max_element(volume.begin(), volume.end()) - volume.begin());
    }
};

/// Removes small separate components that the grid cut off the thin end of a cone.
TriangleMesh without_specks(const SpecialBody& body, const TriangleMesh& mesh) {
    const Parts parts(body, mesh);
    const double speck = 6 * std::pow(2 * body.shape().edge_length, 3);
    TriangleMesh kept = mesh;
    Eigen::Index count = 0;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const int p = parts.of_triangle[at(t)];
        const bool is_speck = p != parts.largest && std::abs(parts.volume[at(p)]) < speck &&
                              parts.owners[at(p)].size() == 1 &&
                              parts.owners[at(parts.largest)].count(*parts.owners[at(p)].begin()) == 1;
        if (!is_speck) kept.triangles.row(count++) = mesh.triangles.row(t);
    }
    kept.triangles.conservativeResize(count, 3);
    return drop_unused(kept);
}

void require_one_body(const SpecialBody& body, const TriangleMesh& mesh) {
    const Parts parts(body, mesh);
    const std::set<int>& most = parts.owners[at(parts.largest)];
    std::set<int> shown;
    for (std::size_t p = 0; p < parts.owners.size(); ++p) {
        const std::set<int>& some = parts.owners[p];
        shown.insert(some.begin(), some.end());
        if (p == at(parts.largest)) continue;
        if (parts.volume[p] < 0)
            throw InputError("special shape: " + listed(body, some) +
                             " shut in a hollow that no seam reaches; fill it with a primitive or open it");
        throw InputError("special shape: " + listed(body, some) + " and " + listed(body, most) +
                         " lie apart from each other; let primitives overlap by more than an edge length");
    }
    for (int p = 0; p < static_cast<int>(body.shape().primitives.size()); ++p)
        if (shown.count(p) == 0)
            throw InputError("special shape: " + body.shape().primitives[at(p)].name +
                             " lies entirely inside the other primitives; move it out or remove it");
}

void require_mouth_within(const SpecialBody& body, const TriangleMesh& mesh) {
    if (!body.shape().mouth) return;
    const double low = mesh.positions.col(2).minCoeff();
    const double high = mesh.positions.col(2).maxCoeff();
    const double edge = body.shape().edge_length;
    if (*body.shape().mouth > low + edge / 2 && *body.shape().mouth < high - edge) return;
    throw InputError("special shape: the mouth at height " + format_fixed(*body.shape().mouth / millimetre, 0) +
                     " mm misses the body, which reaches from " + format_fixed(low / millimetre, 0) + " to " +
                     format_fixed(high / millimetre, 0) + " mm; put it inside, an edge length from the ends");
}

/// Throws unless every vertex lies on the body and no triangle is flipped.
void require_followed(const WorkSurface& surface, const SpecialBody& body) {
    for (int t = 0; t < surface.triangle_count(); ++t) {
        if (!surface.is_triangle(t) || surface.tile[at(t)] < 0) continue;
        const int face = surface.cell[at(t)].face;
        const Vec3 middle = (surface.place(t, 0) + surface.place(t, 1) + surface.place(t, 2)) / 3;
        const bool stands =
            shape_quality(body, face, surface.place(t, 0), surface.place(t, 1), surface.place(t, 2)) > 0.01;
        bool lies_on = true;
        for (int k = 0; k < 3; ++k) lies_on = lies_on && std::abs(body.level(surface.place(t, k))) < 1e-9;
        if (stands && lies_on) continue;
        throw InputError("special shape: near (" + format_fixed(middle.x() / millimetre, 0) + ", " +
                         format_fixed(middle.y() / millimetre, 0) + ", " + format_fixed(middle.z() / millimetre, 0) +
                         ") mm on " + body.shape().primitives[at(body.primitive_number(face))].name +
                         " the triangles cannot follow both seam and surface; give shorter edges, or move the seams or "
                         "primitives that nearly touch there");
    }
}

void require_disks(const std::vector<NamedMesh>& tiles) {
    for (const NamedMesh& tile : tiles) try {
            require_disk(tile.mesh, Adjacency(tile.mesh.triangles, tile.mesh.vertex_count()), tile.name);
        } catch (const InputError& error) {
            throw InputError("special shape: a tile cannot be laid flat in one piece (" + std::string(error.what()) +
                             "); give its primitive more sectors or rings, so that a seam opens it");
        }
}

/// The number of boundary loops at the mouth: cycles of half-edges of tiles whose twins lie below.
int count_openings(const WorkSurface& surface) {
    std::set<int> rim;
    for (int h = 0; h < surface.half_edge_count(); ++h)
        if (surface.is_triangle(h / 3) && surface.tile[at(h / 3)] >= 0 && surface.tile[at(surface.twin(h) / 3)] < 0)
            rim.insert(h);
    int openings = 0;
    while (!rim.empty()) {
        ++openings;
        for (int h = *rim.begin(); rim.erase(h) > 0;) {
            h = WorkSurface::next(h);
            while (surface.tile[at(surface.twin(h) / 3)] >= 0) h = WorkSurface::next(surface.twin(h));
        }
    }
    return openings;
}

/// Replaces creases by fillets, so that the first surface is smooth and does not fold where it is cut.
SpecialBody soften(SpecialShape shape) {
    shape.joint_radius = std::max(shape.joint_radius, 1.5 * shape.edge_length);
    return SpecialBody(shape, shape.edge_length);
}

}  // namespace

std::vector<NamedMesh> design_special(const SpecialShape& shape) {
    require_valid(shape, "special shape");
    const SpecialBody body(shape);
    const double edge = shape.edge_length;
    const SpecialBody softened = soften(shape);
    const TriangleMesh first = without_specks(body, march(softened, 0.9 * edge));
    require_one_body(body, first);
    require_mouth_within(body, first);
    WorkSurface surface(first);
    relax(surface, softened, {}, edge, 3);
    set_poles(surface, body);
    relax(surface, softened, {}, edge, 2);
    cut_creases(surface, body);
    for (int round = 0; round < 2; ++round) {
        straighten_creases(surface, body);
        relax(surface, body, draw_curves(surface, body), edge, 2);
    }
    cut_seams(surface, body);
    const std::vector<SpecialTile> tiles = number_tiles(surface, body);
    const std::vector<BodyCurve> curves = draw_curves(surface, body);
    if (const int openings = count_openings(surface); openings > 1)
        throw InputError("special shape: the mouth opens the body in " + std::to_string(openings) +
                         " places, expected one; raise or lower it");
    relax(surface, body, curves, edge, 10);
    relax_corners(surface, body, curves, edge);
    require_followed(surface, body);
    std::vector<NamedMesh> meshes = tile_meshes(surface, body, tiles);
    require_disks(meshes);
    return meshes;
}

}  // namespace ripstop
