#pragma once

#include <vector>

#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// A mended mesh and what was changed in it.
struct MendedMesh {
    TriangleMesh mesh;
    std::vector<int> vertex;        ///< input vertex of each vertex
    std::vector<int> triangle;      ///< input triangle of each triangle, or the one it replaces
    std::vector<int> becomes = {};  ///< vertex that each input vertex has become; -1: removed
    int joined = 0;                 ///< vertices merged with another at the same place
    int flat = 0;                   ///< triangles without area, removed
    int doubled = 0;                ///< triangles given twice, either way up
    int unused = 0;                 ///< vertices that no triangle uses, removed
    int welded = 0;                 ///< vertices merged at tips where each triangle had its own copy
    int closed = 0;                 ///< tips narrower than `MendOptions::tip_width`, closed
    Vec3 place = Vec3::Zero();      ///< place of the first change

    bool any() const { return joined + flat + doubled + unused + welded + closed > 0; }
};

/// How `mend_mesh` treats tips: narrow ends where two sides of the outline nearly meet.
struct MendOptions {
    bool keep_tips = false;  ///< neither weld nor close tips
    double tip_width = 0;    ///< tips narrower than this are closed, in the mesh's unit
};

/// Mends defects that mesh exporters leave and no designer means, as CAD programs do on import. A disk
/// (`require_disk`) without needles keeps its vertices and triangles bit by bit, except at tips.
///
/// - An edge below 1e-9 of its triangle's longest edge is collapsed and the triangle is removed, such as at a pole.
/// - A needle is a triangle whose height over its longest edge is below 1e-6 of that edge. It is removed by an edge
///   flip with the triangle beyond that edge, or deleted at the boundary.
/// - Triangles given twice, either way up, and unused vertices are removed.
/// - If the result is not a disk, all vertices at the same place are merged, provided that this gives a disk: a mesh
///   in which each triangle, or each patch of texture, has its own vertices.
/// - A tip of which each triangle has its own copy is welded (`weld_tips`); a tip narrower than `tip_width` is closed
///   (`close_tips`).
///
/// A mesh that cannot be made a disk is returned as far as it was mended; the caller's `require_disk` reports the
/// rest. O(#F log #F).
MendedMesh mend_mesh(const TriangleMesh& mesh, const MendOptions& options = {});

/// Merges the copies of a tip: vertices at the same place (within 1e-6 of the edges there) with one vertex between
/// consecutive copies along the boundary. The triangle angles at the place must add up to less than 150 degrees, so
/// that the boundary turns a corner there, and those round each vertex between to 360 within 30. The cracks between
/// the triangles of a fan are like this. A dart that is closed in space is not: it is longer than an edge, begins at
/// a straight edge or removes an angle. Requires a disk and returns one.
MendedMesh weld_tips(const TriangleMesh& mesh);

/// Replaces each tip narrower than `width` by the midpoint of its ends. A tip is a run of boundary edges that is
/// shorter than `width` and than a tenth of the edge before and after it, and at which the boundary turns left by more
/// than 90 degrees. Edges of a hundredth of a millimetre at a gore's end cannot be sewn, and the file's rounding
/// decides their directions. Requires a disk and returns one. O(#F + #boundary).
MendedMesh close_tips(const TriangleMesh& mesh, double width);

}  // namespace ripstop
