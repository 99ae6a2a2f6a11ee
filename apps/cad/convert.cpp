#include <BRepBndLib.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <Bnd_Box.hxx>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "meshing.h"
#include "ripstop/base/error.h"
#include "ripstop/base/text/number_text.h"

namespace ripstop::cad {
namespace {

constexpr double finest_sewing = 2e-5;  // of the drawing's diagonal; a wider tolerance would close small tiles

constexpr int most_rounds = 5;         // of meshing; each is finer where the one before was too coarse
constexpr double coarsest_step = 0.3;  // a fault in the surface is not worth a million triangles

double diagonal_of(const std::vector<TopoDS_Face>& faces) {
    Bnd_Box box;
    for (const TopoDS_Face& face : faces)
        if (!face.IsNull()) BRepBndLib::AddOptimal(face, box, false, false);
    return box.IsVoid() ? 0 : std::sqrt(box.SquareExtent());
}

std::string called(const DrawnObject& object, std::size_t face) {
    const std::string name = object.name.empty() ? object.type : object.name;
    return object.faces.size() > 1 ? name + ", face " + std::to_string(face + 1) : name;
}

/// A mesh with only the vertices that its triangles use.
TriangleMesh own_mesh(const Points3& positions, const Triangles& triangles, double millimetres) {
    std::vector<int> number(static_cast<std::size_t>(positions.rows()), -1), used;
    TriangleMesh mesh{{}, triangles};
    for (Eigen::Index t = 0; t < triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k) {
            int& own = number[static_cast<std::size_t>(triangles(t, k))];
            if (own < 0) {
                own = static_cast<int>(used.size());
                used.push_back(triangles(t, k));
            }
            mesh.triangles(t, k) = own;
        }
    mesh.positions.resize(static_cast<Eigen::Index>(used.size()), 3);
    for (std::size_t i = 0; i < used.size(); ++i)
        mesh.positions.row(static_cast<Eigen::Index>(i)) = positions.row(used[i]) / millimetres;
    return mesh;
}

/// Discards surfaces that disagree with their stored mesh: `shape` becomes null, and the stored mesh is used.
void trust_stored(Drawing& drawing, const std::vector<FaceFigures>& figures, std::vector<TopoDS_Face>& faces) {
    std::size_t i = 0;
    for (DrawnObject& object : drawing.objects)
        for (std::size_t f = 0; f < object.faces.size(); ++f, ++i) {
            const ConvertedFace& stored = object.faces[f].stored;
            if (faces[i].IsNull() || stored.mesh.triangle_count() == 0) continue;
            const double unit = drawing.millimetres * drawing.millimetres;
            const double area = surface_area(stored.mesh) * unit;
            if (std::abs(figures[i].area / area - 1) <= area_agreement) continue;
            faces[i] = {};
            drawing.rest.remarks.push_back(called(object, f) + ": its surface has " +
                                           format_fixed((figures[i].area / area - 1) * 100, 1) +
                                           " % more area than the mesh stored with it; the stored mesh was taken");
        }
}

std::vector<TopoDS_Face> faces_of(const Drawing& drawing) {
    std::vector<TopoDS_Face> faces;
    for (const DrawnObject& object : drawing.objects)
        for (const DrawnFace& face : object.faces) faces.push_back(face.shape);
    return faces;
}

/// How messages state lengths: in millimetres, or in the file's own numbers if its unit is unknown.
struct Said {
    double scale = 1;  ///< from the kernel's millimetres
    std::string unit = " mm";
};

std::string percent_text(double ratio) {
    return format_fixed(ratio * 100, 4) + " %";
}

struct Measured {
    Meshes meshes;
    std::vector<FaceFigures> figures;
};

/// Reports the current face to the parent process, a few times a second: `progress 12 160 face`.
Told tell_progress(std::size_t faces) {
    using Clock = std::chrono::steady_clock;
    return [faces, last = Clock::time_point()](std::size_t face) mutable {
        const auto now = Clock::now();
        if (now - last < std::chrono::milliseconds(200)) return;
        last = now;
        std::fprintf(stderr, "progress %zu %zu face\n", face + 1, faces);
    };
}

/// Meshes the faces. The distance of `drawn` from a mesh is known only afterwards; faces with a larger distance
/// than asked for are meshed again, and finer.
Measured meshed_and_measured(const std::vector<TopoDS_Face>& faces, const std::vector<TopoDS_Face>& drawn,
                             EdgeSizes sizes, double triangles) {
    std::optional<double> asked;
    if (std::isfinite(sizes.chord_error)) asked = sizes.chord_error;
    const Told told = tell_progress(faces.size());
    for (int round = 1;; ++round) {
        Measured result{meshed(faces, sizes, triangles, told), std::vector<FaceFigures>(faces.size())};
        bool holds = true;
        for (std::size_t i = 0; i < faces.size(); ++i) {
            if (result.meshes.faces[i].rows() == 0) continue;
            result.figures[i] = figures_of(drawn[i], result.meshes.positions, result.meshes.faces[i], asked);
            const double ratio = sizes.chord_error / result.figures[i].chord_error;
            if (!(ratio < 1)) continue;
            holds = false;
            const double step = std::max(0.95 * std::sqrt(ratio), coarsest_step);
            sizes.finer[i] *= step;
            triangles += static_cast<double>(result.meshes.faces[i].rows()) * (1 / (step * step) - 1);
        }
        if (holds || round == most_rounds) return result;
    }
}

/// Adds a remark on the quality of the meshes.
void add_remark(ConvertedModel& model, const EdgeSizes& sizes, const std::vector<FaceFigures>& figures, bool plain,
                const Said& said) {
    double chord_error = 0, shortfall = 0;
    for (const FaceFigures& face : figures) {
        chord_error = std::max(chord_error, face.chord_error);
        shortfall = std::max(shortfall, face.shortfall);
    }
    model.remarks.push_back("surfaces meshed with edges of at most " + format_fixed(sizes.longest * said.scale, 1) +
                            said.unit + ": at most " + format_fixed(chord_error * said.scale, 3) + said.unit +
                            " off the CAD's, edges at most " + percent_text(shortfall) + " short of its curves");
    if (chord_error > sizes.chord_error)
        model.remarks.push_back("--chord asks for at most " + format_fixed(sizes.chord_error * said.scale, 3) +
                                said.unit +
                                " off the CAD's surfaces, which no mesh can reach: they are faulty, or their edges "
                                "do not meet; repair them in the CAD");
    if (plain)
        model.remarks.push_back(
            "the surfaces were meshed by Open CASCADE, with poor triangles, because no other mesher can fill one; "
            "repair the surfaces in the CAD");
}

void add_bound(ConvertedModel& model, const Bounded& bounded) {
    const std::string finer = "ask for finer ones with --chord or --edge";
    if (bounded.border > 1)
        model.remarks.push_back("the faces have so many edges that the edges are divided " +
                                format_fixed(bounded.border, 1) +
                                " times more coarsely than their curvature requires (a turn of 2.8 degrees); " + finer);
    if (bounded.faces == 0) return;
    const std::string faces = bounded.faces == 1 ? "1 face has" : std::to_string(bounded.faces) + " faces have";
    model.remarks.push_back(
        faces + " triangles up to " + format_fixed(bounded.longer, 1) +
        " times longer inside than their curvature requires (a turn of 2.8 degrees), to avoid more than " +
        format_fixed(most_of_face, 0) + " triangles in a face or " + format_fixed(most_of_all, 0) + " in all; " +
        (bounded.border > 1 ? "" : "their edges are not affected; ") + finer);
}

/// Converts lengths from the user's millimetres to the kernel's; `scale` of the latter are one of the former. The
/// two differ if the file states no unit, or if the user overrides it.
MeshingOptions in_kernel(MeshingOptions options, double scale) {
    options.sewing_tolerance /= scale;
    if (options.chord_error) *options.chord_error /= scale;
    if (options.edge_length) *options.edge_length /= scale;
    return options;
}

}  // namespace

ConvertedModel convert(Drawing drawing, const MeshingOptions& asked) {
    const double metres_per_unit = asked.metres_per_unit.value_or(drawing.rest.unit.value_or(LengthUnit{}).metres);
    const double scale = metres_per_unit / (drawing.millimetres * millimetre);
    const MeshingOptions options = in_kernel(asked, scale);
    std::vector<TopoDS_Face> faces = faces_of(drawing);
    std::vector<FaceFigures> figures(faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i)
        if (!faces[i].IsNull()) figures[i] = figures_of(faces[i], Points3(0, 3), Triangles(0, 3));
    trust_stored(drawing, figures, faces);
    const double tolerance = std::min(options.sewing_tolerance / millimetre, finest_sewing * diagonal_of(faces));
    const std::vector<TopoDS_Face> drawn = faces;
    if (tolerance > 0) faces = sewn(faces, tolerance);
    EdgeSizes sizes = edge_sizes(faces, options);
    const Bounded bounded = bound(faces, options, sizes);
    Measured measured = meshed_and_measured(faces, drawn, sizes, bounded.triangles);
    Meshes& meshes = measured.meshes;
    figures = std::move(measured.figures);
    for (std::size_t i = 0; i < faces.size(); ++i)
        if (figures[i].turned) meshes.faces[i].col(1).swap(meshes.faces[i].col(2));
    const std::vector<bool> turned = agree(meshes.positions, meshes.faces);
    ConvertedModel model = std::move(drawing.rest);
    std::size_t i = 0, meshed_faces = 0, turned_faces = 0;
    for (DrawnObject& object : drawing.objects) {
        ConvertedObject converted{object.name, object.type, object.attributes, {}};
        for (std::size_t f = 0; f < object.faces.size(); ++f, ++i) {
            DrawnFace& face = object.faces[f];
            if (meshes.faces[i].rows() > 0) {
                const double mm = drawing.millimetres;
                converted.faces.push_back({face.name, own_mesh(meshes.positions, meshes.faces[i], mm),
                                           figures[i].area / (mm * mm), figures[i].chord_error / mm, face.attributes});
                ++meshed_faces;
                turned_faces += turned[i] ? 1 : 0;
            } else if (face.stored.mesh.triangle_count() > 0) {
                converted.faces.push_back(std::move(face.stored));
            } else {
                model.unread.push_back({called(object, f), object.type,
                                        "this face could not be meshed; repair it in the CAD, or mesh it there",
                                        object.attributes});
            }
        }
        model.objects.push_back(std::move(converted));
    }
    const bool known = asked.metres_per_unit || model.unit;
    if (meshed_faces > 0)
        add_remark(model, sizes, figures, meshes.plain, known ? Said{scale} : Said{1 / drawing.millimetres, ""});
    add_bound(model, bounded);
    if (turned_faces > 0)
        model.remarks.push_back(
            std::string(turned_faces == 1 ? "1 face was" : std::to_string(turned_faces) + " faces were") +
            " turned over so that neighbours face the same way");
    return model;
}

}  // namespace ripstop::cad
