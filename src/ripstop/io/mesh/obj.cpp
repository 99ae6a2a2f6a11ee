#include "ripstop/io/mesh/obj.h"

#include <istream>
#include <ostream>

#include "ripstop/base/index.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/io/mesh/obj_file.h"
#include "ripstop/io/text/text.h"

namespace ripstop {

CadModel read_obj(std::istream& in, const std::string& name) {
    ObjFile file = parse_obj(read_text(in, name), name);
    CadModel model;
    for (const ObjCurve& curve : file.curves) {
        NamedCurve& named = model.curves.emplace_back();
        named.name = curve.name;
        named.points.resize(static_cast<Eigen::Index>(curve.vertices.size()), 3);
        for (std::size_t i = 0; i < curve.vertices.size(); ++i)
            named.points.row(static_cast<Eigen::Index>(i)) = file.mesh.vertices[at(curve.vertices[i])].transpose();
        if (!curve.layer.empty()) named.attributes["layer"] = curve.layer;
    }
    model.unread = std::move(file.unread);
    model.remarks = std::move(file.remarks);
    make_surfaces(std::move(file.mesh), model);
    return model;
}

namespace {

/// Appends one record for each row.
template <class Matrix>
void add_rows(std::string& text, const char* key, const Matrix& rows) {
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
        text += key;
        for (Eigen::Index k = 0; k < rows.cols(); ++k) text += " " + format_shortest(rows(i, k));
        text += "\n";
    }
}

}  // namespace

void write_obj(std::ostream& out, const std::vector<NamedMesh>& meshes) {
    Eigen::Index first_vertex = 1;
    Eigen::Index first_texture = 1;
    for (const NamedMesh& surface : meshes) {
        std::string text = "o " + surface.name + "\n";
        add_rows(text, "v", surface.mesh.positions);
        if (surface.drawn) add_rows(text, "vt", *surface.drawn);
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

void write_obj_curves(std::ostream& out, const std::vector<NamedCurve>& curves) {
    Eigen::Index vertex = 0;
    for (const NamedCurve& curve : curves) {
        std::string text = "o " + curve.name + "\n";
        add_rows(text, "v", curve.points);
        text += "l";
        for (Eigen::Index i = 0; i < curve.points.rows(); ++i) text += " " + std::to_string(++vertex);
        out << text << "\n";
    }
}

}  // namespace ripstop
