#include "ripstop/io/obj.h"

#include <istream>
#include <ostream>

#include "ripstop/base/number_text.h"
#include "ripstop/io/obj_file.h"
#include "ripstop/io/text.h"

namespace ripstop {

CadModel read_obj(std::istream& in, const std::string& name) {
    ObjFile file = parse_obj(read_text(in, name), name);
    CadModel model;
    for (const ObjCurve& curve : file.curves) {
        NamedCurve& named = model.curves.emplace_back();
        named.name = curve.name;
        named.points.resize(static_cast<Eigen::Index>(curve.vertices.size()), 3);
        for (std::size_t i = 0; i < curve.vertices.size(); ++i)
            named.points.row(static_cast<Eigen::Index>(i)) =
                file.mesh.vertices[static_cast<std::size_t>(curve.vertices[i])].transpose();
        if (!curve.layer.empty()) named.attributes["layer"] = curve.layer;
    }
    model.unread = std::move(file.unread);
    model.remarks = std::move(file.remarks);
    model.surfaces = make_surfaces(std::move(file.mesh));
    return model;
}

void write_obj(std::ostream& out, const std::vector<NamedMesh>& meshes) {
    Eigen::Index first_vertex = 1;
    Eigen::Index first_texture = 1;
    for (const NamedMesh& surface : meshes) {
        std::string text = "o " + surface.name + "\n";
        const auto rows = [&text](const char* key, const auto& points) {
            for (Eigen::Index i = 0; i < points.rows(); ++i) {
                text += key;
                for (Eigen::Index k = 0; k < points.cols(); ++k) text += " " + format_shortest(points(i, k));
                text += "\n";
            }
        };
        rows("v", surface.mesh.positions);
        if (surface.drawn) rows("vt", *surface.drawn);
        for (Eigen::Index t = 0; t < surface.mesh.triangles.rows(); ++t) {
            text += "f";
            for (Eigen::Index k = 0; k < 3; ++k) {
                const int v = surface.mesh.triangles(t, k);
                text += " " + std::to_string(first_vertex + v);
                if (surface.drawn) text += "/" + std::to_string(first_texture + v);
            }
            text += "\n";
        }
        out << text;
        first_vertex += surface.mesh.positions.rows();
        if (surface.drawn) first_texture += surface.drawn->rows();
    }
}

}  // namespace ripstop
