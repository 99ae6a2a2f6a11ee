// The only source that includes CGAL (GPL-3), which is used for comparison in benchmarks and tests only.
#include "cgal_parameterization.h"

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

namespace ripstop {

namespace smp = CGAL::Surface_mesh_parameterization;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

struct CgalParameterization::Data {
    Mesh mesh;
    Mesh::Halfedge_index border;
    Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_2> uv;
};

CgalParameterization::CgalParameterization(const TriangleMesh& mesh) : data_(new Data) {
    std::vector<Mesh::Vertex_index> vertices;
    for (int v = 0; v < mesh.vertex_count(); ++v)
        vertices.push_back(data_->mesh.add_vertex({mesh.positions(v, 0), mesh.positions(v, 1), mesh.positions(v, 2)}));
    const auto corner = [&](int t, int k) { return vertices[static_cast<std::size_t>(mesh.triangles(t, k))]; };
    for (int t = 0; t < mesh.triangle_count(); ++t) data_->mesh.add_face(corner(t, 0), corner(t, 1), corner(t, 2));
    data_->border = CGAL::Polygon_mesh_processing::longest_border(data_->mesh).first;
    data_->uv = data_->mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
}

CgalParameterization::~CgalParameterization() {
    delete data_;
}

bool CgalParameterization::lscm(std::optional<std::array<int, 2>> pins) {
    using Border = smp::Two_vertices_parameterizer_3<Mesh>;
    const auto vertex = [](int v) { return Mesh::Vertex_index(static_cast<Mesh::size_type>(v)); };
    const Border border = pins ? Border(vertex((*pins)[0]), vertex((*pins)[1])) : Border();
    return smp::parameterize(data_->mesh, smp::LSCM_parameterizer_3<Mesh, Border>(border), data_->border, data_->uv) ==
           smp::OK;
}

bool CgalParameterization::arap() {
    return smp::parameterize(data_->mesh, smp::ARAP_parameterizer_3<Mesh>(), data_->border, data_->uv) == smp::OK;
}

Points2 CgalParameterization::positions() const {
    Points2 positions(static_cast<Eigen::Index>(data_->mesh.number_of_vertices()), 2);
    for (const Mesh::Vertex_index v : data_->mesh.vertices())
        positions.row(static_cast<Eigen::Index>(v)) << data_->uv[v].x(), data_->uv[v].y();
    return positions;
}

}  // namespace ripstop
