#include "ripstop/io/rhino/rhino_surfaces.h"

#include <algorithm>
#include <set>
#include <string_view>

#include "ripstop/base/error.h"

namespace ripstop {
namespace {

constexpr std::string_view whole_file = "Rhino 1 model", no_name = "unnamed_";

bool is_surface(const std::string& type) {
    return type == "Brep" || type == "Surface" || type == "Extrusion" || type == "SubD";
}

/// The reader and the converter visit the file in the same order. So if both count the same number of surfaces of
/// each type, the n-th surface of one is the n-th of the other.
void take_names(ConvertedModel& model, const std::vector<UnreadObject>& unread) {
    std::vector<const UnreadObject*> known;
    for (const UnreadObject& object : unread)
        if (is_surface(object.type)) known.push_back(&object);
    const bool paired = known.size() == model.objects.size() &&
                        std::equal(known.begin(), known.end(), model.objects.begin(),
                                   [](const UnreadObject* a, const ConvertedObject& b) { return a->type == b.type; });
    for (std::size_t i = 0; paired && i < known.size(); ++i) {
        const bool nameless = known[i]->name.rfind(no_name, 0) == 0;
        model.objects[i].name = nameless ? "" : known[i]->name;
        model.objects[i].attributes = known[i]->attributes;
    }
}

}  // namespace

void add_rhino_surfaces(CadModel& model, const std::filesystem::path& file, const MeshingOptions& options) {
    const auto can_be_read = [](const UnreadObject& object) {
        return is_surface(object.type) || object.type == whole_file;
    };
    if (std::none_of(model.unread.begin(), model.unread.end(), can_be_read)) return;
    ConvertedModel converted;
    try {
        converted = convert_rhino(file, options);
    } catch (const InputError& error) {
        model.remarks.emplace_back(error.what());
        return;
    }
    take_names(converted, model.unread);
    std::set<std::string> taken;
    for (const NamedMesh& surface : model.surfaces) taken.insert(surface.name);
    CadModel surfaces = as_surfaces(std::move(converted), options.tiles, file.stem().string(), std::move(taken));
    std::erase_if(model.unread, can_be_read);
    const auto append = [](auto& to, auto& from) {
        to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
    };
    append(model.surfaces, surfaces.surfaces);
    append(model.curves, surfaces.curves);
    append(model.unread, surfaces.unread);
    append(model.remarks, surfaces.remarks);
    if (!model.unit) model.unit = surfaces.unit;
    if (model.layers.empty()) model.layers = surfaces.layers;
}

}  // namespace ripstop
