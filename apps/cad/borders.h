#pragma once

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Edge.hxx>

#include "face_sizes.h"

namespace ripstop::cad {

/// A point of a face's border: where it is in u and v, and the vertex it is of the whole mesh. A pole is one vertex in
/// several places of u and v.
struct BorderNode {
    Vec2 uv;
    int vertex;
    bool pole = false;
};
using BorderLoop = std::vector<BorderNode>;

/// The edges of faces in straight pieces, divided once for all faces that share them.
class Borders {
  public:
    /// `sizes`: of each face; nothing for a null face. `finer`: what the lengths on the edges of a face are multiplied
    /// by.
    Borders(const std::vector<TopoDS_Face>& faces, const std::vector<std::optional<FaceSizes>>& sizes,
            const EdgeSizes& asked, const std::vector<double>& finer = {});

    /// The closed lines around a face in u and v, as its wires run. Nothing where they are not closed, or an edge has
    /// no place in u and v.
    std::optional<std::vector<BorderLoop>> loops(const TopoDS_Face& face, const FaceSizes& sizes) const;

    double pieces(const TopoDS_Face& face) const;  ///< how many there are around it
    double pieces() const;                         ///< of all edges

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
