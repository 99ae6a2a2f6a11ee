#include "ripstop/io/mesh/ply.h"

#include <array>
#include <cmath>
#include <istream>
#include <limits>
#include <unordered_map>

#include "ripstop/base/text/number_text.h"
#include "ripstop/io/mesh/mesh_records.h"
#include "ripstop/io/mesh/ply_header.h"
#include "ripstop/io/mesh/ply_source.h"
#include "ripstop/io/text/text.h"

namespace ripstop {
namespace {

/// The meaning of a property, which is also the index of its value in a row; `corners` is the list.
enum Role { x, y, z, u, v, tile, warp_x, warp_y, warp_z, role_count, corners, skipped };

struct Spelling {
    std::string_view name;
    Role role;
};

constexpr std::array<Spelling, 9> of_vertices = {
    {{"x", x}, {"y", y}, {"z", z}, {"u", u}, {"v", v}, {"s", u}, {"t", v}, {"texture_u", u}, {"texture_v", v}}};
constexpr std::array<Spelling, 6> of_faces = {{{"warp_x", warp_x},
                                               {"warp_y", warp_y},
                                               {"warp_z", warp_z},
                                               {"grain_x", warp_x},
                                               {"grain_y", warp_y},
                                               {"grain_z", warp_z}}};
constexpr std::array<std::string_view, 5> tile_names = {"tile", "tile_id", "label", "group", "object"};
constexpr double end_of_strip = -1;

/// The row of an element: values by role, and the list of corners.
struct Row {
    std::array<double, role_count> values{};
    std::vector<double> list = {};
    long place = 0;
};

/// The roles of an element's properties. The first property with a role keeps it; later ones are skipped.
class ReadingPlan {
  public:
    explicit ReadingPlan(const PlyElement& element) : roles_(element.properties.size(), skipped) {
        const auto& properties = element.properties;
        if (element.name == "vertex") {
            give(properties, of_vertices);
        } else if (element.name == "face") {
            give(properties, of_faces);
            for (const std::string_view name : tile_names) give(properties, std::array{Spelling{name, tile}});
        }
        if (element.name == "face" || element.name == "tristrips")
            for (std::size_t p = 0; p < properties.size(); ++p)
                if (properties[p].count && !has(corners) &&
                    (properties[p].name == "vertex_indices" || properties[p].name == "vertex_index")) {
                    roles_[p] = corners;
                    has_[corners] = true;
                }
    }

    bool has(Role role) const { return has_[role]; }
    Role role(std::size_t property) const { return roles_[property]; }

  private:
    template <std::size_t count>
    void give(const std::vector<PlyProperty>& properties, const std::array<Spelling, count>& spellings) {
        for (const Spelling& spelling : spellings)
            for (std::size_t p = 0; p < properties.size(); ++p)
                if (!properties[p].count && properties[p].name == spelling.name && !has_[spelling.role]) {
                    roles_[p] = spelling.role;
                    has_[spelling.role] = true;
                }
    }

    std::vector<Role> roles_;
    std::array<bool, skipped> has_{};
};

template <class Source>
class PlyReader {
  public:
    PlyReader(const PlyHeader& header, Source& source, MeshRecords& file)
        : header_(header), source_(source), file_(file) {}

    void read() {
        for (const PlyElement& element : header_.elements) {
            const ReadingPlan plan(element);
            const bool vertices = element.name == "vertex", faces = element.name == "face";
            const bool strips = element.name == "tristrips" && plan.has(corners);
            if (vertices && !(plan.has(x) && plan.has(y) && plan.has(z)))
                file_.refuse(source_.place(),
                             "the vertices have no x, y and z, expected all three; export the file again");
            if (faces && !plan.has(corners) && element.count > 0)
                file_.refuse(source_.place(),
                             "the faces have no list vertex_indices, expected one; export the surfaces as meshes");
            if (element.properties.empty()) continue;  // such an element has no bytes in the body, whatever its count
            if (vertices) file_.vertices.reserve(source_.most(element));
            if (faces) file_.faces.reserve(source_.most(element));
            for (std::uint64_t i = 0; i < element.count; ++i) {
                read_row(element, plan);
                if (vertices) add_vertex(plan);
                if (faces) add_face(plan);
                if (strips) add_strips();
            }
        }
        source_.finish();
        if (!has_tiles_) file_.apart = true;
    }

  private:
    void read_row(const PlyElement& element, const ReadingPlan& plan) {
        source_.begin_row(element);
        row_.place = source_.place();
        for (std::size_t p = 0; p < element.properties.size(); ++p) {
            const PlyProperty& property = element.properties[p];
            const Role role = plan.role(p);
            if (property.count) {
                const std::size_t count = source_.length(property);
                if (role == corners) {
                    row_.list.resize(count);
                    for (double& value : row_.list) value = source_.value(property.type);
                } else {
                    source_.skip(property.type, count);
                }
            } else if (role == skipped) {
                source_.skip(property.type, 1);
            } else {
                row_.values[role] = source_.value(property.type);
            }
        }
        source_.end_row();
    }

    double coordinate(Role role) const { return file_.coordinate(row_.values[role], row_.place); }

    void add_vertex(const ReadingPlan& plan) {
        file_.vertices.emplace_back(coordinate(x), coordinate(y), coordinate(z));
        if (plan.has(u) && plan.has(v)) file_.textures.emplace_back(coordinate(u), coordinate(v));
    }

    void add_corner(double index) {
        if (!(index >= 0 && index <= std::numeric_limits<int>::max()) || index != std::floor(index)) {
            const bool whole = std::abs(index) < 1e15 && index == std::floor(index);
            if (whole) file_.refuse_index(row_.place, static_cast<long>(index), file_.vertices.size());
            file_.refuse(row_.place,
                         "a corner of a face is not a whole number, expected the index of a vertex; export the file "
                         "again");
        }
        const int vertex = static_cast<int>(index);
        file_.corners.push_back({vertex, file_.textures.empty() ? -1 : vertex});
    }

    void add_face(const ReadingPlan& plan) {
        file_.faces.push_back(
            {file_.corners.size(), static_cast<int>(row_.list.size()), surface(plan), -1, row_.place});
        for (const double index : row_.list) add_corner(index);
        if (plan.has(warp_x) && plan.has(warp_y) && plan.has(warp_z)) {
            file_.warps.resize(file_.faces.size() - 1, Vec3::Zero());
            file_.warps.emplace_back(coordinate(warp_x), coordinate(warp_y), coordinate(warp_z));
        }
    }

    void add_strips() {
        bool odd = false;
        std::size_t length = 0;
        for (std::size_t i = 0; i < row_.list.size(); ++i) {
            if (row_.list[i] == end_of_strip) {
                length = 0;
                continue;
            }
            if (length == 0) odd = false;
            if (++length < 3) continue;
            const double a = row_.list[i - 2], b = row_.list[i - 1], c = row_.list[i];
            if (a != b && b != c && c != a) {
                file_.faces.push_back({file_.corners.size(), 3, nameless_surface(), -1, row_.place});
                for (const double index : {odd ? b : a, odd ? a : b, c}) add_corner(index);
                if (!file_.warps.empty()) file_.warps.resize(file_.faces.size(), Vec3::Zero());
            }
            odd = !odd;
        }
    }

    int surface_called(const std::string& name) {
        const auto [entry, is_new] = surfaces_.try_emplace(name, static_cast<int>(file_.surfaces.size()));
        if (is_new) file_.surfaces.push_back(name);
        return entry->second;
    }

    int nameless_surface() {
        if (nameless_ < 0) nameless_ = surface_called(file_.stem);
        return nameless_;
    }

    int surface(const ReadingPlan& plan) {
        if (!plan.has(tile)) return nameless_surface();
        const double number = row_.values[tile];
        if (!(std::abs(number) < 1e15) || number != std::floor(number))
            file_.refuse(row_.place, "the tile number of a face is not a whole number; export the file again");
        has_tiles_ = true;
        const auto id = static_cast<std::int64_t>(number);
        if (const auto known = of_tile_.find(id); known != of_tile_.end()) return known->second;
        const auto name = header_.names.find(id);
        return of_tile_[id] =
                   surface_called(name != header_.names.end() ? name->second : file_.stem + "_" + std::to_string(id));
    }

    const PlyHeader& header_;
    Source& source_;
    MeshRecords& file_;
    Row row_;
    bool has_tiles_ = false;
    int nameless_ = -1;
    std::unordered_map<std::int64_t, int> of_tile_;
    std::unordered_map<std::string, int> surfaces_;
};

template <class Source>
void read_body(const PlyHeader& header, Source source, MeshRecords& file) {
    PlyReader<Source>(header, source, file).read();
}

}  // namespace

CadModel read_ply(std::istream& in, const std::string& name) {
    std::string bytes = read_bytes(in, name);
    PlyHeader header = read_ply_header(bytes, name);
    MeshRecords file{.name = name, .stem = stem_of(name, ".ply"), .binary = header.form != PlyForm::ascii};
    if (header.form == PlyForm::ascii) {
        bytes = text_of(std::move(bytes), name);
        read_body(header, PlyText(bytes, header, file), file);
    } else if (header.form == PlyForm::little_endian) {
        read_body(header, PlyBytes<std::endian::little>(bytes, header, file), file);
    } else {
        read_body(header, PlyBytes<std::endian::big>(bytes, header, file), file);
    }
    for (const PlyElement& element : header.elements)
        for (const PlyProperty& property : element.properties)
            if (element.name == "vertex" && property.name == "x" && file.binary)
                file.single_precision = property.type == PlyType::float32;
    CadModel model;
    model.unit = header.unit;
    model.remarks = std::move(header.remarks);
    make_surfaces(std::move(file), model);
    return model;
}

}  // namespace ripstop
