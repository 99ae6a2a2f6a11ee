#include "ripstop/io/rhino/rhino_object.h"

#include <array>
#include <utility>

namespace ripstop {
namespace {

constexpr std::uint32_t type_chunk = 0x82000071, attributes_chunk = 0x02008072, user_text_chunk = 0x02000073,
                        end_chunk = 0x8200007F;
constexpr RhinoId user_text_class = rhino_id("CE28DE29-F4C5-4faa-A50A-C3A6849B6329");

constexpr int mode_mask = 15, hidden_mode = 1, definition_mode = 3;
constexpr int page_space = 2;

constexpr std::array<std::pair<std::uint32_t, const char*>, 20> type_names = {{{0x1, "Point"},
                                                                               {rhino_point_cloud, "PointCloud"},
                                                                               {rhino_curve, "Curve"},
                                                                               {rhino_surface, "Surface"},
                                                                               {rhino_brep, "Brep"},
                                                                               {0x20, "Mesh"},
                                                                               {0x100, "Light"},
                                                                               {0x200, "Annotation"},
                                                                               {0x800, "BlockDefinition"},
                                                                               {0x1000, "Block"},
                                                                               {0x2000, "TextDot"},
                                                                               {0x4000, "Grip"},
                                                                               {0x8000, "Detail"},
                                                                               {0x10000, "Hatch"},
                                                                               {0x20000, "MorphControl"},
                                                                               {rhino_subd, "SubD"},
                                                                               {0x8000000, "Cage"},
                                                                               {0x10000000, "Phantom"},
                                                                               {0x20000000, "ClippingPlane"},
                                                                               {rhino_extrusion, "Extrusion"}}};

void set_mode(RhinoObject& object, int mode) {
    object.hidden = object.hidden || (mode & mode_mask) == hidden_mode;
    object.in_definition = (mode & mode_mask) == definition_mode;
}

std::vector<int> read_groups(RhinoBytes& data) {
    std::vector<int> groups(data.count(sizeof(std::int32_t)));
    for (int& group : groups) group = data.integer();
    return groups;
}

/// Rhino 5 and later write numbered items and omit those with default values. The items after the object's space
/// grow with each Rhino version and are not needed here.
void read_items(RhinoBytes data, RhinoObject& object) {
    enum Item {
        name = 1,
        url,
        line_type,
        material,
        rendering,
        colour,
        plot_colour,
        plot_weight,
        decoration,
        wires,
        visible,
        mode,
        colour_source,
        plot_colour_source,
        plot_weight_source,
        material_source,
        line_type_source,
        groups,
        space
    };
    object.id = data.id();
    object.layer = data.integer();
    for (int item = data.byte(); item != 0; item = data.byte()) switch (item) {
            case name:
                object.name = data.text();
                break;
            case url:
                data.text();
                break;
            case line_type:
            case material:
            case colour:
            case plot_colour:
            case wires:
                data.skip(4);
                break;
            case rendering:
                data.chunk();
                break;
            case plot_weight:
                data.skip(sizeof(double));
                break;
            case decoration:
            case colour_source:
            case plot_colour_source:
            case plot_weight_source:
            case material_source:
            case line_type_source:
                data.skip(1);
                break;
            case visible:
                object.hidden = object.hidden || !data.flag();
                break;
            case mode:
                set_mode(object, data.byte());
                break;
            case groups:
                object.groups = read_groups(data);
                break;
            case space:
                object.on_page = data.byte() == page_space;
                return;
            default:
                return;
        }
}

/// Rhino 2 to 4 write everything in a fixed order.
void read_in_order(RhinoBytes data, int minor, RhinoObject& object) {
    object.id = data.id();
    object.layer = data.integer();
    data.skip(4 + 4 + 2 * sizeof(std::int16_t) + 2 * sizeof(double) + 4);  // material, colour, line, wires
    set_mode(object, data.byte());
    data.skip(3);  // sources of colour, line type and material
    object.name = data.text();
    data.text();  // URL
    if (minor >= 1) object.groups = read_groups(data);
    if (minor >= 2) object.hidden = object.hidden || !data.flag();
    if (minor >= 3) data.skip(data.count(2 * sizeof(RhinoId)) * 2 * sizeof(RhinoId));  // display materials
    if (minor >= 4) data.skip(4 + 1 + 4 + 1 + sizeof(double));                         // arrows, plot colour and weight
    if (minor >= 5) data.skip(4);                                                      // line type
    if (minor >= 6) object.on_page = data.byte() == 1;
}

void read_attributes(RhinoBytes data, RhinoObject& object) {
    const auto version = data.packed_version();
    if (version.major == 2)
        read_items(data, object);
    else if (version.major == 1)
        read_in_order(data, version.minor, object);
}

void read_text(const std::map<RhinoId, RhinoBytes>& user_data, Attributes& text) {
    const auto found = user_data.find(user_text_class);
    if (found == user_data.end()) return;
    RhinoBytes body = found->second;
    RhinoBytes list = body.anonymous();
    const int count = list.integer();
    for (int i = 0; i < count; ++i) {
        RhinoBytes pair = list.anonymous();
        const std::string key = pair.text();
        text.emplace(key, pair.text());
    }
}

}  // namespace

RhinoObject read_rhino_object(RhinoBytes record) {
    RhinoChunk chunk = record.chunk();
    if (chunk.code != type_chunk) record.refuse("an object without its kind");
    const auto type = static_cast<std::uint32_t>(chunk.value & 0xFFFFFFFF);
    RhinoObject object{type, read_rhino_class(record)};
    std::map<RhinoId, RhinoBytes> beside;
    while (!record.empty() && chunk.code != end_chunk) {
        chunk = record.chunk();
        if (chunk.code == attributes_chunk) read_attributes(chunk.body, object);
        if (chunk.code == user_text_chunk) read_rhino_user_data(chunk.body, beside);
    }
    read_text(beside, object.text);
    read_text(object.geometry.user_data, object.text);
    return object;
}

std::string rhino_type_name(std::uint32_t type) {
    for (const auto& [bit, name] : type_names)
        if (bit == type) return name;
    return "Object";
}

}  // namespace ripstop
