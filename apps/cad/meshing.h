#pragma once

#include <TopoDS_Face.hxx>
#include <functional>
#include <optional>
#include <vector>

#include "drawing.h"
#include "ripstop/io/cad/convert.h"

namespace ripstop::cad {

/// Sews neighbours whose edges lie within `tolerance` [mm], so that they share these edges. Gives each face as it is
/// then, in the order of `faces`; a null face where it was too small to be kept.
std::vector<TopoDS_Face> sewn(const std::vector<TopoDS_Face>& faces, double tolerance);

/// Told the number of the face that is worked on, from 0.
using Told = std::function<void(std::size_t face)>;

/// How long the edges of a mesh are to be [mm].
struct EdgeSizes {
    double longest = 0;                 ///< everywhere
    double turn = 0;                    ///< between the ends of an edge [rad]; infinite: no matter
    double chord_error = 0;             ///< infinite: no matter
    double shortest = 0;                ///< however much the surface is bent
    std::vector<double> finer = {};     ///< what the lengths on a face are multiplied by, `longest` aside; empty: by 1
    std::vector<double> most = {};      ///< triangles of a face, where its border has fewer pieces; empty: no matter
    double border = 1;                  ///< what the lengths on the edges of faces are multiplied by
    double at(double curvature) const;  ///< [1/mm]
};

/// The least of `finer`.
double finest(const EdgeSizes& sizes);

/// From what is asked for; the longest is else a twelfth of the size of the faces that hold the middle of the area.
EdgeSizes edge_sizes(const std::vector<TopoDS_Face>& faces, const MeshingOptions& asked);

/// How many triangles are made unasked: `most_of_face` of a face, `most_of_all` together.
inline constexpr double most_of_face = 20000, most_of_all = 200000;

/// Sets `finer`, `most` and `border` of `sizes` so that no more are made where neither `chord_error` nor `edge_length`
/// is asked for; throws InputError where more than ten million are asked for. The edges of faces keep their own bend,
/// unless they alone have too many pieces.
struct Bounded {
    std::size_t faces = 0;  ///< that get longer edges
    double longer = 1;      ///< how many times longer, at most
    double border = 1;      ///< how many times longer the pieces of the faces' edges are
    double triangles = 0;   ///< about how many come out
};
Bounded bound(const std::vector<TopoDS_Face>& faces, const MeshingOptions& asked, EdgeSizes& sizes);

/// The faces meshed, all in one numbering of vertices: neighbours share those of their common edges. Empty triangles
/// for a null face. `triangles`: about as many are expected.
struct Meshes {
    Points3 positions;  ///< [mm]
    std::vector<Triangles> faces;
    bool plain = false;  ///< by the kernel's own mesher, because the better ones refused
};
Meshes meshed(const std::vector<TopoDS_Face>& faces, const EdgeSizes& sizes, double triangles, const Told& told);

/// The same by gmsh, in a process of its own, which is ended where it takes more than its share: at a pole and on
/// closed surfaces it may refine for ever. Nothing where it fails on a face.
std::optional<Meshes> meshed_by_gmsh(const std::vector<TopoDS_Face>& faces, const EdgeSizes& sizes, double triangles,
                                     const Told& told);

/// By ourselves, in the plane of u and v of each face (`Borders`, `filled`): bounded on any surface. Nothing where the
/// border of a face is not closed there, or crosses itself.
std::optional<Meshes> meshed_in_parameters(const std::vector<TopoDS_Face>& faces, const EdgeSizes& sizes,
                                           const Told& told);

/// By Open CASCADE, with poor triangles.
Meshes meshed_by_kernel(const std::vector<TopoDS_Face>& faces, const EdgeSizes& sizes);

/// What a mesh makes of a face.
struct FaceFigures {
    double area = 0;         ///< of the face itself [mm²]
    double chord_error = 0;  ///< [mm], at samples
    double shortfall = 0;    ///< of its edges' length, as a ratio; 0 where it is closed on itself
    bool turned = false;     ///< the triangles run against the face
};

/// `asked`: the chord error to be kept [mm]; it is then taken on every triangle, in its middle and on its edges; else
/// in the middle of some 80.
FaceFigures figures_of(const TopoDS_Face& face, const Points3& positions, const Triangles& triangles,
                       std::optional<double> asked = {});

/// Turns faces so that all that hang together agree, and closed bodies point outward; else as most of their area
/// already is. Gives which were turned.
std::vector<bool> agree(const Points3& positions, std::vector<Triangles>& faces);

/// Everything of a drawing as a converted model. Throws InputError.
ConvertedModel convert(Drawing drawing, const MeshingOptions& options);

}  // namespace ripstop::cad
