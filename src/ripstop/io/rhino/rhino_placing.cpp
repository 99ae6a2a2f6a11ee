#include "ripstop/io/rhino/rhino_placing.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "ripstop/base/error.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/io/text/text.h"

namespace ripstop {
namespace {

constexpr std::size_t deepest_block = 50;
constexpr std::size_t fewest_placed = 1000, bytes_of_placed = 4;
constexpr std::size_t longest_path = 4096;

std::string hexadecimal(const RhinoId& id) {
    constexpr std::array<std::size_t, 16> order = {3, 2, 1, 0, 5, 4, 7, 6, 8, 9, 10, 11, 12, 13, 14, 15};
    std::string text;
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i == 4 || i == 6 || i == 8 || i == 10) text += '-';
        for (const int digit : {id[order[i]] >> 4, id[order[i]] & 15}) text += "0123456789abcdef"[digit];
    }
    return text;
}

struct Reference {
    RhinoId definition;
    Eigen::Affine3d place;
};

/// Returns nothing if the transformation is not affine or not invertible.
std::optional<Reference> read_reference(const RhinoObject& object) {
    RhinoBytes data = object.geometry.data;
    data.packed_version();
    Reference reference{data.id(), Eigen::Affine3d::Identity()};
    Eigen::Matrix4d map;
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c) map(r, c) = data.real();
    const double size = map.topLeftCorner<3, 3>().cwiseAbs().maxCoeff();
    if (!map.allFinite() || map.row(3) != Eigen::RowVector4d(0, 0, 0, 1) ||
        !(std::abs(map.topLeftCorner<3, 3>().determinant()) > 1e-12 * size * size * size))
        return std::nullopt;
    reference.place.matrix() = map;
    return reference;
}

class Placer {
  public:
    Placer(const RhinoTables& tables, const std::vector<RhinoObject>& objects, const RhinoArchive& archive)
        : archive_(archive) {
        for (const RhinoLayer& layer : tables.layers) layers_.emplace(layer.index, &layer);
        for (const RhinoObject& object : objects) objects_.emplace(object.id, &object);
        for (const RhinoDefinition& definition : tables.definitions) definitions_.emplace(definition.id, &definition);
        std::vector<const RhinoObject*> model;
        for (const RhinoObject& object : objects)
            if (!object.in_definition) model.push_back(&object);
        name_instances(model);
        for (const auto& [id, definition] : definitions_) name_instances(members(*definition));
        for (const RhinoObject* object : model) place({object, Eigen::Affine3d::Identity()});
        name_by_instances();
    }

    RhinoPlacing placing;

  private:
    std::vector<const RhinoObject*> members(const RhinoDefinition& definition) const {
        std::vector<const RhinoObject*> found;
        for (const RhinoId& id : definition.objects)
            if (const auto object = objects_.find(id); object != objects_.end()) found.push_back(object->second);
        return found;
    }

    /// Names the instances of one level: those of the model, or of one definition.
    void name_instances(const std::vector<const RhinoObject*>& beside) {
        std::map<std::string, std::vector<const RhinoObject*>> nameless;
        for (const RhinoObject* object : beside) {
            if (object->geometry.id != rhino_reference_class) continue;
            const auto text = object->text.find("tile");
            std::string name = object->name;
            if (name.empty() && text != object->text.end()) name = text->second;
            if (!name.empty()) {
                names_.emplace(object, name);
                continue;
            }
            RhinoBytes data = object->geometry.data;
            data.packed_version();
            const auto definition = definitions_.find(data.id());
            name = definition == definitions_.end() ? "" : definition->second->name;
            nameless[name.empty() ? "block" : name].push_back(object);
        }
        for (const auto& [name, instances] : nameless)
            for (std::size_t i = 0; i < instances.size(); ++i)
                names_.emplace(instances[i], name + "_" + padded(i + 1, instances.size()));
    }

    bool is_left_out(const RhinoObject& object) {
        const auto layer = layers_.find(object.layer);
        if (object.on_page)
            ++placing.on_pages;
        else if (object.hidden)
            ++placing.hidden;
        else if (layer != layers_.end() && !layer->second->visible)
            ++placing.on_hidden_layer[layer->second->path];
        else
            return false;
        return true;
    }

    void place(RhinoPlaced placed) {
        const RhinoObject& object = *placed.object;
        if (is_left_out(object)) return;
        if (++count_ > fewest_placed + archive_.bytes.size() / bytes_of_placed)
            throw InputError(archive_.name + ": " + rhino_called(object) + ": nested blocks give more than " +
                             std::to_string(count_ - 1) + " objects in this file; explode or delete some in Rhino");
        if (object.geometry.id != rhino_reference_class) {
            placing.placed.push_back(std::move(placed));
            return;
        }
        const std::optional<Reference> read = read_reference(object);
        if (!read) {
            placing.lost.push_back({std::move(placed),
                                    "its transformation flattens it or is invalid, expected one to move, turn, mirror "
                                    "or scale it; explode it in Rhino or place it again"});
            return;
        }
        const Reference& reference = *read;
        const auto definition = definitions_.find(reference.definition);
        const bool here = definition != definitions_.end();
        const auto parts = here ? members(*definition->second) : std::vector<const RhinoObject*>();
        if (parts.empty()) {
            placing.lost.push_back(
                {std::move(placed), here && definition->second->linked
                                        ? "the block is linked to another file; make it an embedded "
                                          "one in Rhino (BlockManager) and save again"
                                        : "what the block is made of is not in the file; explode it in "
                                          "Rhino, or save in a newer version"});
            return;
        }
        follow(placed, reference, parts);
    }

    void follow(const RhinoPlaced& instance, const Reference& reference, const std::vector<const RhinoObject*>& parts) {
        if (std::find(open_.begin(), open_.end(), reference.definition) != open_.end() || open_.size() >= deepest_block)
            throw InputError(archive_.name + ": " + rhino_called(*instance.object) +
                             ": the block contains itself, or blocks are nested more than " +
                             std::to_string(deepest_block) + " deep; explode it in Rhino");
        open_.push_back(reference.definition);
        RhinoPlaced part{nullptr, instance.place * reference.place, instance.instances, instance.path, instance.around};
        part.instances.push_back(instance.object);
        part.around.push_back(instance.place);
        part.path += (part.path.empty() ? "" : "/") + names_[instance.object];
        if (part.path.size() > longest_path)
            throw InputError(archive_.name + ": " + rhino_called(*instance.object) +
                             ": the path of the names of the blocks around it is too long; shorten the names in Rhino");
        for (const RhinoObject* object : parts) {
            part.object = object;
            place(part);
        }
        open_.pop_back();
    }

    using Chain = std::vector<const RhinoObject*>;  // an instance and those around it, outermost first

    /// A user text `tile` of an instance names what is placed there. It overrides that of the block's own parts.
    void name_by_instances() {
        std::map<Chain, int> surfaces;
        for (const RhinoPlaced& placed : placing.placed)
            for (Chain chain = placed.instances; is_surface(*placed.object) && !chain.empty(); chain.pop_back())
                ++surfaces[chain];
        std::set<Chain> told;
        for (RhinoPlaced& placed : placing.placed) {
            Chain chain;
            std::string outside;
            for (std::size_t i = 0; is_surface(*placed.object) && i < placed.instances.size(); ++i) {
                const RhinoObject* instance = placed.instances[i];
                chain.push_back(instance);
                const auto text = instance->text.find("tile");
                const bool has_text = text != instance->text.end() && !text->second.empty();
                const std::string called = outside + (outside.empty() ? "" : "/") + names_[instance];
                if (has_text && surfaces[chain] == 1 && placed.named_by == nullptr) {
                    placed.named_by = instance;
                    placed.named_in = outside;
                } else if (has_text && surfaces[chain] > 1 && !instance->name.empty() && told.insert(chain).second) {
                    placing.unused_tile_texts.push_back(called + " (" + shown(text->second) + ")");
                }
                outside = called;
            }
        }
    }

    static bool is_surface(const RhinoObject& object) {
        return object.geometry.id == rhino_mesh_class || object.type == rhino_surface || object.type == rhino_brep ||
               object.type == rhino_subd || object.type == rhino_extrusion;
    }

    const RhinoArchive& archive_;
    std::map<int, const RhinoLayer*> layers_;
    std::map<RhinoId, const RhinoObject*> objects_;
    std::map<RhinoId, const RhinoDefinition*> definitions_;
    std::map<const RhinoObject*, std::string> names_;
    std::vector<RhinoId> open_;
    std::size_t count_ = 0;
};

}  // namespace

RhinoPlacing place_rhino_objects(const RhinoTables& tables, const std::vector<RhinoObject>& objects,
                                 const RhinoArchive& archive) {
    return std::move(Placer(tables, objects, archive).placing);
}

std::string rhino_called(const RhinoObject& object) {
    return rhino_type_name(object.type) + " " + (object.name.empty() ? hexadecimal(object.id) : shown(object.name));
}

}  // namespace ripstop
