#include "ripstop/io/rhino/rhino_tables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "ripstop/base/index.h"

namespace ripstop {
namespace {

constexpr std::uint32_t properties_table = 0x10000014, settings_table = 0x10000015, layer_table = 0x10000011,
                        group_table = 0x10000018, definition_table = 0x10000021, object_table = 0x10000013,
                        end_of_table = 0xFFFFFFFF, end_of_file = 0x00007FFF;
constexpr std::uint32_t writer_record = 0xA0000026, unit_record = 0x20008031, layer_record = 0x20008050,
                        group_record = 0x20008073, definition_record = 0x20008076, object_record = 0x20008070;
constexpr std::uint32_t class_chunk = 0x00027FFA, class_id_chunk = 0x0002FFFB, class_data_chunk = 0x0002FFFC,
                        user_data_chunk = 0x00027FFD, user_data_header = 0x0002FFF9;

/// The codes that openNURBS gives units. The file states the scale of a custom unit.
constexpr int no_unit = 0, own_unit = 11;
struct KnownUnit {
    const char* name;
    double metres;
};
constexpr std::array<KnownUnit, 26> units = {{{"", 0},
                                              {"µm", 1e-6},
                                              {"mm", 1e-3},
                                              {"cm", 1e-2},
                                              {"m", 1},
                                              {"km", 1e3},
                                              {"µin", 2.54e-8},
                                              {"mil", 2.54e-5},
                                              {"in", 0.0254},
                                              {"ft", 0.3048},
                                              {"mi", 1609.344},
                                              {"", 0},
                                              {"Å", 1e-10},
                                              {"nm", 1e-9},
                                              {"dm", 0.1},
                                              {"dam", 10},
                                              {"hm", 100},
                                              {"Mm", 1e6},
                                              {"Gm", 1e9},
                                              {"yd", 0.9144},
                                              {"pt", 0.0254 / 72},
                                              {"pica", 0.0254 / 6},
                                              {"nmi", 1852},
                                              {"au", 149597870700.0},
                                              {"ly", 9.4607304725808e15},
                                              {"pc", 3.0856776e16}}};

std::optional<LengthUnit> read_unit(RhinoBytes record) {
    const int version = record.integer();
    const int number = record.integer();
    if (version < 100 || version >= 200 || number == no_unit || number < 0) return std::nullopt;
    if (number != own_unit) {
        if (number >= static_cast<int>(units.size())) return std::nullopt;
        const KnownUnit& unit = units[at(number)];
        return LengthUnit{unit.name, unit.metres};
    }
    if (version < 102) return std::nullopt;
    record.skip(3 * sizeof(double) + 2 * sizeof(std::int32_t));  // tolerances, display of lengths
    const double metres = record.real();
    const std::string name = record.text();
    if (!std::isfinite(metres) || metres <= 0) return std::nullopt;
    return LengthUnit{name.empty() ? "unit of its own" : name, metres};
}

RhinoLayer read_layer(RhinoBytes record) {
    RhinoBytes data = read_rhino_class(record).data;
    RhinoLayer layer;
    const auto version = data.packed_version();
    layer.visible = data.integer() != 1;
    layer.index = data.integer();
    data.skip(3 * sizeof(std::int32_t) + 4 + 2 * sizeof(std::int16_t) + 2 * sizeof(double));  // materials, colour, line
    layer.name = data.text();
    if (version.minor >= 1) layer.visible = data.flag();
    if (version.minor >= 2) data.skip(sizeof(std::int32_t));  // line type
    if (version.minor >= 3) data.skip(4 + sizeof(double));    // plot colour and weight
    if (version.minor >= 4) data.skip(1);                     // locked
    if (version.minor >= 5) layer.id = data.id();
    if (version.minor >= 6) layer.parent = data.id();
    return layer;
}

/// The path of each layer: the names of its ancestors and its own. A layer in a cycle gets no further ancestors.
void find_paths(std::vector<RhinoLayer>& layers) {
    std::map<RhinoId, std::size_t> by_id;
    for (std::size_t i = 0; i < layers.size(); ++i)
        if (layers[i].id != RhinoId{}) by_id.emplace(layers[i].id, i);
    std::vector<char> own_visible;
    for (const RhinoLayer& layer : layers) own_visible.push_back(layer.visible);
    constexpr std::size_t deepest = 100;
    for (RhinoLayer& layer : layers) {
        layer.path = layer.name;
        std::set<std::size_t> seen = {static_cast<std::size_t>(&layer - layers.data())};
        RhinoId parent = layer.parent;
        for (auto above = by_id.find(parent);
             above != by_id.end() && seen.insert(above->second).second && seen.size() < deepest;
             above = by_id.find(parent)) {
            layer.path = layers[above->second].name + "::" + layer.path;
            layer.visible = layer.visible && own_visible[above->second];
            parent = layers[above->second].parent;
        }
    }
}

/// Reads the id, index and name of a component, each of which may be missing.
void read_component(RhinoBytes data, RhinoDefinition& definition) {
    if (data.flag()) data.skip(sizeof(std::int32_t));  // type of the component
    if (data.flag()) definition.id = data.id();
    if (data.flag()) data.skip(sizeof(RhinoId));  // its parent
    if (data.flag()) data.skip(sizeof(std::int32_t));
    if (data.flag()) definition.name = data.text();
}

std::vector<RhinoId> read_ids(RhinoBytes& data) {
    std::vector<RhinoId> ids(data.count(sizeof(RhinoId)));
    for (RhinoId& id : ids) id = data.id();
    return ids;
}

constexpr std::size_t box_bytes = 6 * sizeof(double);
constexpr std::uint32_t linked_definition = 3;

RhinoDefinition read_definition(RhinoBytes record) {
    RhinoBytes data = read_rhino_class(record).data;
    RhinoDefinition definition;
    RhinoBytes peek = data;
    constexpr std::uint32_t anonymous_chunk = 0x40008000, component_chunk = 0x40008002;
    if (data.version() >= 60 && peek.left() >= 4 && peek.natural() == anonymous_chunk) {
        data = data.anonymous();
        read_component(data.anonymous(component_chunk), definition);
        definition.linked = data.natural() == linked_definition;
        data.anonymous();  // the unit of the file it came from; the objects are in this file's unit
        for (int texts = 0; texts < 3; ++texts) data.text();
        data.skip(box_bytes);
        if (data.flag()) definition.objects = read_ids(data);
        return definition;
    }
    data.packed_version();
    definition.id = data.id();
    definition.objects = read_ids(data);
    definition.name = data.text();
    for (int texts = 0; texts < 3; ++texts) data.text();
    data.skip(box_bytes);
    definition.linked = data.natural() == linked_definition;
    return definition;
}

void read_group(RhinoBytes record, std::map<int, std::string>& groups) {
    RhinoBytes data = read_rhino_class(record).data;
    data.packed_version();
    const int index = data.integer();
    groups[index] = data.text();
}

void read_table(RhinoBytes table, std::uint32_t code, RhinoTables& tables) {
    while (!table.empty()) {
        const RhinoChunk record = table.chunk();
        if (record.code == end_of_table) return;
        if (code == properties_table && record.code == writer_record)
            tables.writer = static_cast<unsigned>(record.value & 0xFFFFFFFF);
        else if (code == settings_table && record.code == unit_record)
            tables.unit = read_unit(record.body);
        else if (code == layer_table && record.code == layer_record)
            tables.layers.push_back(read_layer(record.body));
        else if (code == group_table && record.code == group_record)
            read_group(record.body, tables.groups);
        else if (code == definition_table && record.code == definition_record)
            tables.definitions.push_back(read_definition(record.body));
        else if (code == object_table && record.code == object_record)
            tables.objects.push_back(record.body);
    }
}

}  // namespace

RhinoTables read_rhino_tables(const RhinoArchive& archive) {
    const std::set<std::uint32_t> known = {properties_table, settings_table,   layer_table,
                                           group_table,      definition_table, object_table};
    RhinoTables tables;
    RhinoBytes bytes(archive);
    for (std::uint32_t code = 0; code != end_of_file;) {
        const RhinoChunk table = bytes.chunk();
        code = table.code;
        if (known.contains(code)) read_table(table.body, code, tables);
    }
    find_paths(tables.layers);
    return tables;
}

RhinoClass read_rhino_class(RhinoBytes& bytes) {
    const RhinoChunk whole = bytes.chunk();
    if (whole.code != class_chunk) bytes.refuse("no object where one belongs");
    RhinoBytes inside = whole.body;
    RhinoChunk id = inside.chunk();
    if (id.code != class_id_chunk) inside.refuse("an object without its class");
    const RhinoChunk data = inside.chunk();
    if (data.code != class_data_chunk) inside.refuse("an object without its data");
    RhinoClass found{id.body.id(), data.body};
    read_rhino_user_data(inside, found.user_data);
    return found;
}

void read_rhino_user_data(RhinoBytes bytes, std::map<RhinoId, RhinoBytes>& user_data) {
    while (!bytes.empty()) {
        RhinoChunk item = bytes.chunk();
        if (item.code != user_data_chunk) return;
        const auto version = item.body.packed_version();
        RhinoId id{};
        if (version.major == 1) {  // ids of class and item, number of copies, transformation
            id = item.body.id();
            item.body.skip(sizeof(RhinoId) + sizeof(std::int32_t) + 16 * sizeof(double));
        } else if (version.major == 2) {
            RhinoChunk head = item.body.chunk();
            if (head.code != user_data_header) item.body.refuse("user data without its header");
            id = head.body.id();
        } else {
            continue;
        }
        user_data.emplace(id, item.body.chunk().body);
    }
}

}  // namespace ripstop
