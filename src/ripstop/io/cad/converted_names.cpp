#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "ripstop/base/text/number_text.h"
#include "ripstop/io/cad/converted.h"
#include "ripstop/io/text/text.h"
#include "ripstop/mesh/change/coincident.h"

namespace ripstop {
namespace {

constexpr double area_tolerance = 0.01;

std::string attribute(const Attributes& attributes, const char* key) {
    const auto found = attributes.find(key);
    return found == attributes.end() ? "" : found->second;
}

std::string last_part(const std::string& layer) {
    const std::size_t at = layer.rfind("::");
    return at == std::string::npos ? layer : layer.substr(at + 2);
}

/// Returns `wanted`, or a variant of it that is not in `taken`; adds the result to `taken`.
std::string unlike(const std::string& wanted, std::set<std::string>& taken) {
    std::string name = wanted;
    for (int i = 2; !taken.insert(name).second; ++i) name = wanted + "_" + std::to_string(i);
    return name;
}

std::vector<std::string> names_of(const std::vector<ConvertedObject>& objects, const std::string& stem) {
    std::map<std::string, int> on_layer;
    for (const ConvertedObject& object : objects) ++on_layer[attribute(object.attributes, "layer")];
    std::vector<std::string> names;
    std::size_t nameless = 0;
    for (const ConvertedObject& object : objects) {
        const std::string layer = attribute(object.attributes, "layer");
        std::string name = readable_name(object.name);
        if (name.empty() && !layer.empty() && on_layer[layer] == 1) name = last_part(layer);
        if (name.empty()) name = objects.size() == 1 ? stem : stem + "_" + padded(++nameless, objects.size());
        names.push_back(name);
    }
    return names;
}

/// Joins all faces into one mesh and merges vertices in the same place.
TriangleMesh welded(const std::vector<ConvertedFace>& faces) {
    TriangleMesh all;
    for (const ConvertedFace& face : faces) {
        const Eigen::Index vertices = all.positions.rows(), triangles = all.triangles.rows();
        all.positions.conservativeResize(vertices + face.mesh.positions.rows(), 3);
        all.triangles.conservativeResize(triangles + face.mesh.triangles.rows(), 3);
        all.positions.bottomRows(face.mesh.positions.rows()) = face.mesh.positions;
        all.triangles.bottomRows(face.mesh.triangles.rows()) = face.mesh.triangles.array() + static_cast<int>(vertices);
    }
    return join_coincident(all);
}

}  // namespace

CadModel as_surfaces(ConvertedModel model, TilesAs tiles, const std::string& stem, std::set<std::string> taken) {
    CadModel result{{},
                    std::move(model.curves),
                    std::move(model.unread),
                    std::move(model.unit),
                    std::move(model.layers),
                    std::move(model.remarks)};
    std::erase_if(model.objects, [](const ConvertedObject& object) { return object.faces.empty(); });
    const std::vector<std::string> names = names_of(model.objects, stem);
    for (std::size_t o = 0; o < model.objects.size(); ++o) {
        ConvertedObject& object = model.objects[o];
        if (tiles == TilesAs::objects) {
            result.surfaces.push_back({unlike(names[o], taken), welded(object.faces), {}, {}, object.attributes});
            continue;
        }
        for (std::size_t f = 0; f < object.faces.size(); ++f) {
            ConvertedFace& face = object.faces[f];
            const std::string part = readable_name(face.name);
            std::string name = names[o];
            if (object.faces.size() > 1)
                name = part.empty() ? name + "_" + padded(f + 1, object.faces.size()) : name + "/" + part;
            name = unlike(name, taken);
            const double area = surface_area(face.mesh);
            if (face.area > 0 && std::abs(area / face.area - 1) > area_tolerance)
                result.remarks.push_back(
                    name + ": its mesh has " + format_fixed((area / face.area - 1) * 100, 1) +
                    " % more area than the surface of the CAD; mesh it finer with --chord or --edge");
            Attributes attributes = std::move(face.attributes);
            attributes.insert(object.attributes.begin(), object.attributes.end());
            result.surfaces.push_back({std::move(name), std::move(face.mesh), {}, {}, std::move(attributes)});
        }
    }
    return result;
}

}  // namespace ripstop
