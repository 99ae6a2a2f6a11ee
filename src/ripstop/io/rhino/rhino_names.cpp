#include "ripstop/io/rhino/rhino_names.h"

#include <map>
#include <set>

#include "ripstop/base/text/number_text.h"
#include "ripstop/io/text/text.h"

namespace ripstop {
namespace {

const RhinoLayer* layer_of(const RhinoObject& object, const RhinoTables& tables) {
    for (const RhinoLayer& layer : tables.layers)
        if (layer.index == object.layer) return &layer;
    return nullptr;
}

std::string groups_of(const RhinoPlaced& placed, const RhinoTables& tables) {
    std::vector<const RhinoObject*> objects = {placed.object};
    objects.insert(objects.end(), placed.instances.rbegin(), placed.instances.rend());
    std::string text;
    for (const RhinoObject* object : objects) {
        for (const int group : object->groups) {
            const auto name = tables.groups.find(group);
            text += text.empty() ? "" : ", ";
            text += name == tables.groups.end() || name->second.empty() ? std::to_string(group) : name->second;
        }
        if (!text.empty()) break;
    }
    return text;
}

/// Rotates a direction `x, y, z` with the block. Returns any other text as it is; whoever reads it refuses it.
std::string turned(const std::string& direction, const Eigen::Affine3d& place) {
    Vec3 found;
    std::string_view rest = direction;
    for (int k = 0; k < 3; ++k) {
        const std::size_t comma = k < 2 ? rest.find(',') : rest.size();
        if (comma == std::string_view::npos) return direction;
        const auto value = parse_double(trimmed(rest.substr(0, comma)));
        if (!value) return direction;
        found[k] = *value;
        rest.remove_prefix(k < 2 ? comma + 1 : comma);
    }
    found = place.linear() * found;
    return format_shortest(found.x()) + ", " + format_shortest(found.y()) + ", " + format_shortest(found.z());
}

std::string own_name(const RhinoObject& object) {
    const auto tile = object.text.find("tile");
    return tile != object.text.end() && !tile->second.empty() ? tile->second : object.name;
}

std::string after(const std::string& path, const std::string& name) {
    return path.empty() || name.empty() ? path + name : path + "/" + name;
}

/// The designer's name for an object, after the names of the blocks around it; empty if it has none.
std::string given_name(const RhinoPlaced& placed) {
    if (placed.named_by != nullptr) return after(placed.named_in, placed.named_by->text.at("tile"));
    const std::string own = own_name(*placed.object);
    return own.empty() ? "" : after(placed.path, own);
}

void make_unique(std::vector<std::string>& names, const std::vector<Attributes>& attributes) {
    std::map<std::string, int> times;
    for (const std::string& name : names) ++times[name];
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto layer = attributes[i].find("layer");
        if (times[names[i]] > 1 && layer != attributes[i].end()) names[i] = after(layer->second, names[i]);
    }
    times.clear();
    for (const std::string& name : names) ++times[name];
    std::map<std::string, int> last;
    for (std::string& name : names) {
        const int number = ++last[name];
        if (number == 1) continue;
        std::string other;
        for (int n = number; other.empty() || times.contains(other); ++n) {
            other = name + "_" + std::to_string(n);
            last[name] = n;
        }
        times[other] = 1;
        name = other;
    }
}

}  // namespace

Attributes rhino_attributes(const RhinoPlaced& placed, const RhinoTables& tables) {
    Attributes found = placed.object->text;
    if (const auto warp = found.find("warp"); warp != found.end() && !placed.instances.empty())
        warp->second = turned(warp->second, placed.place);
    for (std::size_t i = placed.instances.size(); i-- > 0;)
        for (const auto& [key, value] : placed.instances[i]->text)
            found.emplace(key, key == "warp" && i < placed.around.size() ? turned(value, placed.around[i]) : value);
    if (placed.named_by != nullptr) found["tile"] = placed.named_by->text.at("tile");
    if (const RhinoLayer* layer = layer_of(*placed.object, tables)) found["layer"] = layer->path;
    if (const std::string groups = groups_of(placed, tables); !groups.empty()) found["group"] = groups;
    return found;
}

std::vector<std::string> rhino_surface_names(const std::vector<RhinoPlaced>& surfaces,
                                             const std::vector<Attributes>& attributes, const std::string& stem) {
    std::map<std::string, std::size_t> on_layer, on_path, nameless;
    const auto layer = [&attributes](std::size_t i) {
        const auto found = attributes[i].find("layer");
        return found == attributes[i].end() ? std::string() : found->second;
    };
    const auto last_part = [](const std::string& path) {
        const std::size_t parent = path.rfind("::");
        return parent == std::string::npos ? path : path.substr(parent + 2);
    };
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        ++on_layer[layer(i)];
        ++on_path[surfaces[i].path];
    }
    const auto is_alone = [&](std::size_t i) {
        const std::string& path = surfaces[i].path;
        return path.empty() ? on_layer[layer(i)] == 1 && !last_part(layer(i)).empty() : on_path[path] == 1;
    };
    for (std::size_t i = 0; i < surfaces.size(); ++i)
        if (given_name(surfaces[i]).empty() && !is_alone(i)) ++nameless[surfaces[i].path];
    std::map<std::string, std::size_t> next;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        const std::string& path = surfaces[i].path;
        if (const std::string given = given_name(surfaces[i]); !given.empty()) {
            names.push_back(given);
        } else if (is_alone(i)) {
            names.push_back(path.empty() ? last_part(layer(i)) : path);
        } else {
            const std::string number = padded(++next[path], nameless[path]);
            names.push_back(path.empty() ? stem + "_" + number : path + "/" + number);
        }
    }
    make_unique(names, attributes);
    return names;
}

std::vector<std::string> rhino_other_names(const std::vector<RhinoPlaced>& objects, const std::string& fallback) {
    std::size_t next = 0;
    std::vector<std::string> names;
    for (const RhinoPlaced& placed : objects) {
        std::string name = given_name(placed);
        if (name.empty()) name = placed.path;
        if (name.empty()) name = fallback + "_" + padded(++next, objects.size());
        names.push_back(name);
    }
    return names;
}

}  // namespace ripstop
