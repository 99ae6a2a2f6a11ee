#pragma once

#include <vector>

#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// A mesh mended, and what was done to it.
struct MendedMesh {
    TriangleMesh mesh;
    std::vector<int> vertex;        ///< of each vertex: the one it is in the mesh as given
    std::vector<int> triangle;      ///< of each triangle: the one it is, or takes the place of
    std::vector<int> becomes = {};  ///< of each vertex as given: which one it is now; -1: it is gone
    int joined = 0;                 ///< vertices that lay in one place with another
    int flat = 0;                   ///< triangles without area that are gone
    int doubled = 0;                ///< triangles that were there twice, either way up
    int unused = 0;                 ///< vertices of no triangle
    int welded = 0;                 ///< vertices of a tip that each triangle there had for itself
    int closed = 0;                 ///< tips narrower than `MendOptions::tip_width`
    Vec3 place = Vec3::Zero();      ///< where the first of this was

    bool any() const { return joined + flat + doubled + unused + welded + closed > 0; }
};

/// How `mend_mesh` treats tips: narrow ends where two sides of the outline nearly meet.
struct MendOptions {
    bool keep_tips = false;  ///< tips are neither welded nor closed
    double tip_width = 0;    ///< narrower tips are closed, in the mesh's unit
};

/// Mends what a mesh exporter leaves behind and no designer means, as every CAD does on import. A disk (`require_disk`)
/// without needles keeps its vertices and triangles bit by bit, but for a tip.
///
/// - Vertices that a triangle without area joins become one (edges below 1e-9 of the triangle's longest), and the
///   triangle goes: the row of vertices at a pole.
/// - A needle, a corner of which lies within 1e-6 of the longest edge of that edge, gives its area to the triangle
///   beyond it: the two are divided the other way. At the boundary it goes.
/// - Triangles given twice, either way up, and vertices of no triangle go.
/// - Where that gives no disk, all vertices in one place are joined, if that does: a mesh in which each triangle, or
///   each patch of texture, has vertices of its own.
/// - A tip that each of its triangles has for itself is welded (`weld_tips`), one narrower than `tip_width` is closed
///   (`close_tips`).
///
/// A mesh that is no disk even so comes back as far as it could be mended; the caller's `require_disk` says what is
/// left. O(#F log #F).
MendedMesh mend_mesh(const TriangleMesh& mesh, const MendOptions& options = {});

/// Joins the copies of a tip: vertices in one place (within 1e-6 of the edges there) that follow each other along the
/// boundary with one vertex between, where the triangles' angles at the place add up to less than 150 degrees, so that
/// the boundary turns a corner there, and those round the vertex between to 360 within 30. The cracks between the
/// triangles of a fan are so; a dart that is closed in space is not: it is longer than an edge, begins at a straight
/// edge or takes away an angle. Requires a disk; what comes back is one.
MendedMesh weld_tips(const TriangleMesh& mesh);

/// Replaces each tip narrower than `width` by the midpoint of its ends. A tip is a run of boundary edges that is
/// shorter than `width` and than a tenth of the edge before and after it, and at which the boundary turns left by more
/// than 90 degrees. Edges of a hundredth of a millimetre at a gore's end cannot be sewn, and the file's rounding
/// decides their directions. Requires a disk and returns one. O(#F + #boundary).
MendedMesh close_tips(const TriangleMesh& mesh, double width);

}  // namespace ripstop
