#pragma once

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Edge.hxx>

#include "face_sizes.h"

namespace ripstop::cad {

/// A point of a face's border: its place in u and v, and its vertex in the whole mesh. A pole is one vertex with
/// several places in u and v.
struct BorderNode {
    Vec2 uv;
    int vertex;
    bool pole = false;
};
using BorderLoop = std::vector<BorderNode>;

/// The edges of faces as straight pieces, divided once for all faces that share them.
class Borders {
  public:
    /// `sizes` belongs to each face; nothing for a null face. `finer` multiplies the lengths on the edges of each
    /// face.
    Borders(const std::vector<TopoDS_Face>& faces, const std::vector<std::optional<FaceSizes>>& sizes,
            const EdgeSizes& asked, const std::vector<double>& finer = {});

    /// The closed lines around a face in u and v, in the direction of its wires. Nothing if they are not closed,
    /// or if an edge has no place in u and v.
    std::optional<std::vector<BorderLoop>> loops(const TopoDS_Face& face, const FaceSizes& sizes) const;

    double pieces(const TopoDS_Face& face) const;  ///< number of pieces around it
    double pieces() const;                         ///< number of pieces of all edges

    const std::vector<Vec3>& points() const { return points_; }  ///< the vertices [mm]

  private:
    struct Divided {
        std::vector<double> parameters;
        std::vector<int> vertices;
    };
    void divide(const TopoDS_Edge& edge, const std::vector<std::size_t>& around, const std::vector<TopoDS_Face>& faces,
                const std::vector<std::optional<FaceSizes>>& sizes, const EdgeSizes& asked,
                const std::vector<double>& finer);
    int vertex(const TopoDS_Shape& shape);
    bool add_edge(const TopoDS_Edge& edge, const TopoDS_Face& face, BorderLoop& loop) const;

    TopTools_IndexedMapOfShape edges_, corners_;
    std::vector<Divided> divided_;
    std::vector<int> corner_vertices_;
    std::vector<Vec3> points_;
};

}  // namespace ripstop::cad
