#include "ripstop/io/rhino/rhino_3dm.h"

#include <filesystem>
#include <map>

#include "ripstop/base/error.h"
#include "ripstop/io/rhino/rhino_curve.h"
#include "ripstop/io/rhino/rhino_mesh.h"
#include "ripstop/io/rhino/rhino_names.h"
#include "ripstop/io/text/text.h"

namespace ripstop {
namespace {

constexpr std::size_t shown_names = 5;
constexpr std::size_t free_elements = 1000000, elements_per_byte = 200;

/// The names of the meshes that one remark is about.
struct Happened {
    std::vector<std::string> names = {};
    long count = 0;

    void to(const std::string& name, int how_many) {
        if (how_many == 0) return;
        names.push_back(name);
        count += how_many;
    }
    std::string shown_names_of() const {
        std::string text;
        for (std::size_t i = 0; i < std::min(names.size(), shown_names); ++i) text += (i ? ", " : "") + names[i];
        if (names.size() > shown_names) text += " and " + std::to_string(names.size() - shown_names) + " more";
        return text;
    }
};

std::string plural(long count, const std::string& one) {
    return std::to_string(count) + " " + one + (count == 1 ? "" : "s");
}

/// Why an object of this type is not read as a surface; nullptr if it could not be meant as a tile.
const char* reason_of(std::uint32_t type) {
    switch (type) {
        case rhino_brep:
        case rhino_surface:
            return "a NURBS surface is not read from a Rhino file; mesh it in Rhino (Mesh) and save the mesh";
        case rhino_extrusion:
            return "an extrusion is not read; mesh it in Rhino (Mesh) and save the mesh";
        case rhino_subd:
            return "a SubD is not read; mesh it in Rhino (Mesh) and save the mesh";
        case rhino_curve:
            return "a curve of a kind that is not read; convert it in Rhino (Rebuild, or Explode)";
        case rhino_point_cloud:
            return "points have no surface; make a mesh of them in Rhino";
        default:
            return rhino_type_name(type) == "Object" ? "an object of an unknown type" : nullptr;
    }
}

TriangleMesh moved(const TriangleMesh& mesh, const Eigen::Affine3d& place) {
    TriangleMesh result = mesh;
    result.positions = (mesh.positions * place.linear().transpose()).rowwise() + place.translation().transpose();
    if (place.linear().determinant() < 0) result.triangles.col(1).swap(result.triangles.col(2));
    return result;
}

/// Builds the model from the placed objects.
class Modeller {
  public:
    Modeller(const RhinoArchive& archive, const RhinoTables& tables) : archive_(archive), tables_(tables) {
        model_.unit = tables.unit;
        for (const RhinoLayer& layer : tables.layers) model_.layers.push_back(layer.path);
    }

    CadModel made_of(RhinoPlacing placing) {
        std::vector<RhinoPlaced> surfaces, curves, others;
        for (RhinoPlaced& placed : placing.placed) {
            const RhinoObject& object = *placed.object;
            if (object.geometry.id == rhino_mesh_class)
                (mesh_of(object).mesh.triangle_count() > 0 ? surfaces : others).push_back(std::move(placed));
            else if (curve_of(object))
                curves.push_back(std::move(placed));
            else
                others.push_back(std::move(placed));
        }
        add_surfaces(surfaces);
        add_curves(curves);
        add_unread(others, placing.lost);
        remark(placing);
        return std::move(model_);
    }

  private:
    const RhinoMesh& mesh_of(const RhinoObject& object) {
        auto found = meshes_.find(&object);
        if (found == meshes_.end())
            found =
                meshes_.emplace(&object, read_rhino_mesh(object.geometry, tables_.writer, rhino_called(object))).first;
        return found->second;
    }

    const std::optional<Points3>& curve_of(const RhinoObject& object) {
        auto found = curves_.find(&object);
        if (found == curves_.end())
            found = curves_.emplace(&object, read_rhino_curve(object.geometry, rhino_called(object))).first;
        return found->second;
    }

    /// Limits the work: nested blocks can ask for more than any file of this size can mean.
    void spend(const RhinoPlaced& placed, Eigen::Index elements, const Attributes& attributes) {
        std::size_t cost = static_cast<std::size_t>(elements);
        for (const auto& [key, value] : attributes) cost += key.size() + value.size();
        spent_ += cost;
        if (spent_ > free_elements + elements_per_byte * archive_.bytes.size())
            throw InputError(archive_.name + ": " + rhino_called(*placed.object) +
                             ": nested blocks multiply this file beyond any sensible size; explode some in Rhino");
    }

    void add_surfaces(const std::vector<RhinoPlaced>& surfaces) {
        std::vector<Attributes> attributes;
        for (const RhinoPlaced& placed : surfaces) {
            const TriangleMesh& mesh = mesh_of(*placed.object).mesh;
            attributes.push_back(rhino_attributes(placed, tables_));
            spend(placed, mesh.positions.rows() + mesh.triangles.rows(), attributes.back());
        }
        const std::string stem = std::filesystem::path(archive_.name).stem().string();
        std::vector<std::string> names = rhino_surface_names(surfaces, attributes, stem);
        for (std::size_t i = 0; i < surfaces.size(); ++i) {
            const RhinoMesh& found = mesh_of(*surfaces[i].object);
            joined_.to(names[i], found.joined);
            model_.rounding = std::max(model_.rounding, found.rounding);
            narrow_.to(names[i], found.faces_left_out);
            TriangleMesh mesh = surfaces[i].instances.empty() ? found.mesh : moved(found.mesh, surfaces[i].place);
            model_.surfaces.push_back(
                {.name = std::move(names[i]), .mesh = std::move(mesh), .attributes = std::move(attributes[i])});
        }
    }

    void add_curves(const std::vector<RhinoPlaced>& curves) {
        const std::vector<std::string> names = rhino_other_names(curves, "curve");
        for (std::size_t i = 0; i < curves.size(); ++i) {
            Points3 points = *curve_of(*curves[i].object);
            Attributes attributes = rhino_attributes(curves[i], tables_);
            spend(curves[i], points.rows(), attributes);
            const Eigen::Affine3d& place = curves[i].place;
            if (!curves[i].instances.empty())
                points = ((points * place.linear().transpose()).rowwise() + place.translation().transpose()).eval();
            model_.curves.push_back({names[i], std::move(points), std::move(attributes)});
        }
    }

    void add_unread(const std::vector<RhinoPlaced>& others, const std::vector<RhinoLostBlock>& lost) {
        std::vector<RhinoPlaced> unread;
        std::vector<std::string> reasons;
        std::map<std::string, long> of_no_use;
        for (const RhinoPlaced& placed : others) {
            const bool is_mesh = placed.object->geometry.id == rhino_mesh_class;
            const char* reason = is_mesh ? "the mesh has no face; delete it in Rhino" : reason_of(placed.object->type);
            if (!reason) {
                ++of_no_use[rhino_type_name(placed.object->type)];
                continue;
            }
            unread.push_back(placed);
            reasons.emplace_back(reason);
        }
        for (const auto& [block, reason] : lost) {
            unread.push_back(block);
            reasons.push_back(reason);
        }
        const std::vector<std::string> names = rhino_other_names(unread, "unnamed");
        for (std::size_t i = 0; i < unread.size(); ++i) {
            Attributes attributes = rhino_attributes(unread[i], tables_);
            spend(unread[i], 1, attributes);
            model_.unread.push_back(
                {names[i], rhino_type_name(unread[i].object->type), reasons[i], std::move(attributes)});
        }
        std::string kinds;
        for (const auto& [kind, count] : of_no_use)
            kinds += (kinds.empty() ? "" : ", ") + std::to_string(count) + " " + kind;
        if (!kinds.empty()) model_.remarks.push_back("left out because they are not surfaces: " + kinds);
    }

    void remark(const RhinoPlacing& placing) {
        for (const auto& [layer, count] : placing.on_hidden_layer)
            model_.remarks.push_back(plural(count, "object") + " on the hidden layer " + shown(layer) +
                                     " left out; show the layer in Rhino and save to use them");
        if (placing.hidden > 0)
            model_.remarks.push_back(plural(placing.hidden, "hidden object") +
                                     " left out; show them in Rhino (Show) and save to use them");
        if (placing.on_pages > 0)
            model_.remarks.push_back(plural(placing.on_pages, "object") +
                                     " on layouts left out; move them to the model (ChangeSpace) to use them");
        if (!placing.unused_tile_texts.empty())
            model_.remarks.push_back(Happened{placing.unused_tile_texts}.shown_names_of() +
                                     ": the user text tile of a block names no tile if the block holds several "
                                     "surfaces; name the surfaces in the block");
        if (!joined_.names.empty())
            model_.remarks.push_back(joined_.shown_names_of() + ": the faces were not connected, so " +
                                     std::to_string(joined_.count) +
                                     " vertices were merged with others in the same place, like Weld in Rhino");
        if (!narrow_.names.empty())
            model_.remarks.push_back(narrow_.shown_names_of() + ": " + plural(narrow_.count, "face") +
                                     " without three different corners left out");
    }

    const RhinoArchive& archive_;
    const RhinoTables& tables_;
    CadModel model_{{}};
    std::map<const RhinoObject*, RhinoMesh> meshes_;
    std::map<const RhinoObject*, std::optional<Points3>> curves_;
    Happened joined_, narrow_;
    std::size_t spent_ = 0;
};

}  // namespace

CadModel read_rhino_3dm(std::istream& in, const std::string& name) {
    const RhinoArchive archive = read_rhino_archive(in, name);
    if (archive.version == 1) {
        CadModel model{{}};
        model.unread.push_back({std::filesystem::path(name).stem().string(), "Rhino 1 model",
                                "a file of Rhino 1 is not read; open it in Rhino and save it in a newer version"});
        return model;
    }
    const RhinoTables tables = read_rhino_tables(archive);
    std::vector<RhinoObject> objects;
    for (const RhinoBytes& record : tables.objects) objects.push_back(read_rhino_object(record));
    return Modeller(archive, tables).made_of(place_rhino_objects(tables, objects, archive));
}

}  // namespace ripstop
