#pragma once

#include <TopoDS_Face.hxx>
#include <functional>
#include <optional>
#include <vector>

#include "drawing.h"
#include "ripstop/io/cad/convert.h"

namespace ripstop::cad {

/// Sews faces whose edges lie within `tolerance` [mm], so that they share these edges. Returns the resulting faces
/// in the order of `faces`; a null face for one that was too small to keep.
std::vector<TopoDS_Face> sewn(const std::vector<TopoDS_Face>& faces, double tolerance);

/// Receives the index of the current face, from 0.
using Told = std::function<void(std::size_t face)>;

/// The edge lengths of a mesh [mm].
struct EdgeSizes {
    double longest = 0;                 ///< upper limit everywhere
    double turn = 0;                    ///< between the ends of an edge [rad]; infinite: no limit
    double chord_error = 0;             ///< infinite: no limit
    double shortest = 0;                ///< lower limit, whatever the curvature
    std::vector<double> finer = {};     ///< factors on the lengths of each face, except `longest`; empty: 1
    std::vector<double> most = {};      ///< limit on a face's triangles, unless its border has more pieces; empty: none
    double border = 1;                  ///< factor on the lengths of the faces' edges
    double at(double curvature) const;  ///< the length for a curvature [1/mm]
};

/// The smallest of `finer`.
double finest(const EdgeSizes& sizes);

/// The sizes for the lengths asked for. The default for the longest edge is a twelfth of the size of the faces at
/// the median of the area.
EdgeSizes edge_sizes(const std::vector<TopoDS_Face>& faces, const MeshingOptions& asked);

/// Limits on the number of triangles unless the user asks for more: `most_of_face` per face, `most_of_all`
/// together.
inline constexpr double most_of_face = 20000, most_of_all = 200000;

/// What `bound` changed.
struct Bounded {
    std::size_t faces = 0;  ///< number of faces that get longer edges
    double longer = 1;      ///< largest factor by which they are longer
    double border = 1;      ///< factor by which the pieces of the faces' edges are longer
    double triangles = 0;   ///< expected number
};

/// Sets `finer`, `most` and `border` of `sizes` so that these limits hold, if neither `chord_error` nor
/// `edge_length` is asked for. Edges of faces keep their own curvature, unless they alone have too many pieces.
/// Throws InputError if more than ten million triangles are asked for.
Bounded bound(const std::vector<TopoDS_Face>& faces, const MeshingOptions& asked, EdgeSizes& sizes);

/// The meshed faces with a common numbering of vertices: neighbours share those of their common edges. Triangles
/// are empty for a null face. `triangles` is the expected number.
struct Meshes {
    Points3 positions;  ///< [mm]
    std::vector<Triangles> faces;
    bool plain = false;  ///< made by the kernel's own mesher, because the better ones failed
};
Meshes meshed(const std::vector<TopoDS_Face>& faces, const EdgeSizes& sizes, double triangles, const Told& told);

/// Meshes with gmsh in a separate process, which is stopped if it uses more than its share: at poles and on closed
/// surfaces gmsh may refine for ever. Nothing if it fails on a face.
std::optional<Meshes> meshed_by_gmsh(const std::vector<TopoDS_Face>& faces, const EdgeSizes& sizes, double triangles,
                                     const Told& told);

/// Meshes with our own method, in the plane of u and v of each face (`Borders`, `filled`), which is bounded on any
/// surface. Nothing if the border of a face is not closed there, or crosses itself.
std::optional<Meshes> meshed_in_parameters(const std::vector<TopoDS_Face>& faces, const EdgeSizes& sizes,
                                           const Told& told);

/// Meshes with Open CASCADE, which gives poor triangles.
Meshes meshed_by_kernel(const std::vector<TopoDS_Face>& faces, const EdgeSizes& sizes);

/// The quality of a face's mesh.
struct FaceFigures {
    double area = 0;         ///< of the face itself [mm²]
    double chord_error = 0;  ///< [mm], at samples
    double shortfall = 0;    ///< relative shortfall of its edges' length; 0 if the face is closed on itself
    bool turned = false;     ///< the triangles are oriented against the face
};

/// `asked` is the required chord error [mm]. If it is given, the error is measured on every triangle, in its
/// middle and on its edges; else in the middle of about 80.
FaceFigures figures_of(const TopoDS_Face& face, const Points3& positions, const Triangles& triangles,
                       std::optional<double> asked = {});

/// Orients faces so that connected ones agree and closed bodies point outward; open ones keep the orientation of
/// most of their area. Returns which faces were turned.
std::vector<bool> agree(const Points3& positions, std::vector<Triangles>& faces);

/// Converts a drawing to meshes. Throws InputError.
ConvertedModel convert(Drawing drawing, const MeshingOptions& options);

}  // namespace ripstop::cad
