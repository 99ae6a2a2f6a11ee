#include "ripstop/io/dxf/dxf_read.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "ripstop/base/error.h"
#include "ripstop/base/text/stated_unit.h"
#include "ripstop/io/dxf/dxf_shapes.h"
#include "ripstop/io/dxf/dxf_tags.h"
#include "ripstop/io/text/text.h"

namespace ripstop {
namespace {

constexpr std::size_t deepest_insert = 16;
constexpr double farthest = 1e9;
constexpr int mesh_flags = 16 | 64;  // flags of a POLYLINE

struct Block {
    std::string name;
    DxfTagSpan tags;  // its entities
    Vec3 base = Vec3::Zero();
    std::string layer;
    long line = 0;
    bool is_space = false, is_used = false;
};

/// The placement of an entity by the INSERTs around it, and its group. Entities of a block on layer 0 take the
/// layer of their INSERT.
struct InsertPlace {
    Eigen::Affine3d motion = Eigen::Affine3d::Identity();
    int group = -1;
    std::size_t depth = 0;
    std::string layer = "0";
};

/// In the file's units, whatever they are: 0.05 mm in a drawing in inches.
constexpr double chord_error = 0.002;

class DxfReader {
  public:
    DxfReader(const std::string& text, const std::string& name) : name_(name), tags_(read_dxf_tags(text, name)) {
        most_ = std::min<std::size_t>(20'000'000, 100'000 + 1'000 * tags_.size());
    }

    PatternDrawing read() {
        drawing_.format = "DXF";
        std::size_t at = 0;
        for (; at < tags_.size() && tags_[at].code == 999; ++at)
            if (drawing_.comment.empty()) drawing_.comment = readable_name(tags_[at].value);
        while (at < tags_.size()) at = read_section(at);
        if (!has_entities_)
            refuse(tags_.back().line, "no section ENTITIES, so nothing is drawn; export the drawing again");
        draw(entities_, {});
        for (const auto& [key, block] : blocks_)
            if (!block.is_used && !block.is_space) drawing_.groups.push_back({block.name, block.layer, 0, block.line});
        for (const DrawnText& text : drawing_.texts)
            if (const auto unit = unit_of_text(text.text))
                drawing_.units.push_back({"the text \"" + text.text + "\"", *unit});
        return std::move(drawing_);
    }

  private:
    [[noreturn]] void refuse(long line, const std::string& what) const {
        throw InputError(name_ + ":" + std::to_string(line) + ": " + what);
    }

    /// Reads one section, from SECTION to ENDSEC. Returns the index after it.
    std::size_t read_section(std::size_t at) {
        if (tags_[at].code == 0 && tags_[at].value == "EOF") return tags_.size();
        if (tags_[at].code == 999) return at + 1;
        const bool begins = tags_[at].code == 0 && tags_[at].value == "SECTION";
        if (!begins || tags_[at + 1].code != 2)
            refuse(tags_[at].line, shown(tags_[at].value) + " between two sections, expected SECTION; export it again");
        std::size_t end = at + 2;
        while (!(tags_[end].code == 0 && (tags_[end].value == "ENDSEC" || tags_[end].value == "EOF"))) ++end;
        if (tags_[end].value == "EOF") refuse(tags_[end].line, "a section without ENDSEC; export the drawing again");
        const std::string_view section = tags_[at + 1].value;
        const DxfTagSpan inside = DxfTagSpan(tags_).subspan(at + 2, end - at - 2);
        if (section == "HEADER") read_header(inside);
        if (section == "TABLES") read_tables(inside);
        if (section == "BLOCKS") read_blocks(inside);
        if (section == "ENTITIES") {
            entities_ = inside;
            has_entities_ = true;
        }
        return end + 1;
    }

    void read_header(DxfTagSpan tags) {
        for (std::size_t i = 0; i + 1 < tags.size(); ++i) {
            if (tags[i].code != 9) continue;
            const std::string_view value = tags[i + 1].value;
            if (tags[i].value == "$ACADVER") drawing_.format = "DXF " + readable_name(value.substr(0, 12));
            // $MEASUREMENT is ignored: it chooses between metric and imperial hatches and does not state a unit.
            const auto unit = tags[i].value == "$INSUNITS" ? unit_of_insunits(value) : std::nullopt;
            if (unit) drawing_.units.push_back({std::string(tags[i].value), *unit});
        }
    }

    void read_tables(DxfTagSpan tags) {
        for (std::size_t i = 0; i < tags.size(); ++i) {
            if (tags[i].code != 0 || tags[i].value != "LAYER") continue;
            const DxfEntity layer = first_entity(tags.subspan(i), name_);
            if (layer.text(2).empty()) continue;
            drawing_.declared_layers.push_back(readable_name(layer.text(2)));
            spellings_.try_emplace(dxf_key(layer.text(2)), drawing_.declared_layers.back());
            constexpr int frozen = 1;
            // A layer that is off has a negative colour.
            if (layer.number(62, 7) < 0) off_layers_.insert(dxf_key(layer.text(2)));
            if ((layer.flags() & frozen) != 0) frozen_layers_.insert(dxf_key(layer.text(2)));
        }
    }

    void read_blocks(DxfTagSpan tags) {
        for (std::size_t i = 0; i < tags.size();) {
            if (tags[i].code != 0) refuse(tags[i].line, "a group outside of any block; export the drawing again");
            const DxfEntity head = first_entity(tags.subspan(i), name_);
            i += head.tags().size();
            if (head.type() != "BLOCK") continue;
            const std::size_t begin = i;
            while (i < tags.size() && !(tags[i].code == 0 && tags[i].value == "ENDBLK")) ++i;
            if (i == tags.size()) refuse(head.line(), "a BLOCK without ENDBLK; export the drawing again");
            Block block{readable_name(head.text(2)), tags.subspan(begin, i - begin), head.place(10),
                        layer_named(head.layer()), head.line()};
            block.is_space = block.name.starts_with("*") || block.name.starts_with("$");
            blocks_.insert_or_assign(dxf_key(head.text(2)), std::move(block));
        }
    }

    void draw(DxfTagSpan tags, const InsertPlace& place) {
        for (std::size_t i = 0; i < tags.size();) {
            if (tags[i].code != 0) refuse(tags[i].line, "a group outside of any entity; export the drawing again");
            const DxfEntity entity = first_entity(tags.subspan(i), name_);
            i += entity.tags().size();
            count(1, entity);
            if (entity.number(67) == 1) continue;  // paper space
            if (entity.type() == "POLYLINE") {
                const DxfShape shape = dxf_polyline(entity, tags, i, name_, chord_error / scale_of(place));
                if (is_hidden(entity, place)) continue;
                if ((entity.flags() & mesh_flags) != 0)
                    leave_unread("POLYLINE mesh", entity, place);
                else
                    add_path(entity, shape, place);
            } else if (!is_hidden(entity, place)) {
                draw_entity(entity, place);
            }
        }
    }

    void draw_entity(const DxfEntity& entity, const InsertPlace& place) {
        static const std::set<std::string_view> paths{"LINE", "LWPOLYLINE", "ARC", "CIRCLE", "ELLIPSE"};
        static const std::set<std::string_view> silent{"VIEWPORT", "SEQEND", "ATTDEF"};
        if (paths.contains(entity.type()))
            add_path(entity, dxf_shape(entity, chord_error / scale_of(place)), place);
        else if (entity.type() == "SPLINE" || entity.type() == "HELIX")
            add_spline(entity, place);
        else if (entity.type() == "POINT")
            add_point(entity, place);
        else if (entity.type() == "TEXT" || entity.type() == "MTEXT" || entity.type() == "ATTRIB")
            add_text(entity, place);
        else if (entity.type() == "INSERT")
            insert(entity, place);
        else if (!silent.contains(entity.type()))
            leave_unread(readable_name(entity.type().substr(0, 40)), entity, place);
    }

    static double scale_of(const InsertPlace& place) {
        return std::max(1e-9, place.motion.linear().colwise().norm().maxCoeff());
    }

    /// A layer's name as the file first spells it.
    std::string layer_named(const std::string& layer) {
        return spellings_.try_emplace(dxf_key(layer), layer).first->second;
    }

    std::string layer_of(const DxfEntity& entity, const InsertPlace& place) {
        const std::string layer = layer_named(entity.layer());
        return layer == "0" && place.depth > 0 ? place.layer : layer;
    }

    void leave_unread(const std::string& kind, const DxfEntity& entity, const InsertPlace& place) {
        drawing_.leave_unread(kind, layer_of(entity, place), entity.line());
    }

    /// True if a CAD does not show the entity. Hidden entities are not cut; they are reported.
    bool is_hidden(const DxfEntity& entity, const InsertPlace& place) {
        const std::string layer = dxf_key(layer_of(entity, place));
        // A block inserted on a layer that is off still shows its entities on other layers.
        const bool is_off =
            frozen_layers_.contains(layer) || (off_layers_.contains(layer) && entity.type() != "INSERT");
        if (entity.number(60) != 1 && !is_off) return false;
        const std::string type = readable_name(entity.type().substr(0, 40));
        leave_unread(is_off ? type + " on a hidden layer" : "invisible " + type, entity, place);
        return true;
    }

    void add_spline(const DxfEntity& entity, const InsertPlace& place) {
        const DxfShape shape = dxf_spline(entity, chord_error / scale_of(place));
        if (shape.points.empty()) return leave_unread("SPLINE without control points", entity, place);
        add_path(entity, shape, place);
    }

    void count(std::size_t points, const DxfEntity& entity) {
        drawn_ += points;
        if (drawn_ > most_)
            refuse(entity.line(), "the nested blocks draw more than " + std::to_string(most_) +
                                      " points; explode them or export less");
    }

    Vec3 moved(const DxfEntity& entity, const InsertPlace& place, const Vec3& p) const {
        const Vec3 at = place.motion * p;
        if (!(at.cwiseAbs().maxCoeff() <= farthest))
            refuse(entity.line(), "a point further than 1e9 from the origin; scale or move the drawing");
        return at;
    }

    static InsertPlace plane_of(const DxfEntity& entity, InsertPlace place) {
        place.motion.linear() *= dxf_plane(entity);
        return place;
    }

    void add_path(const DxfEntity& entity, const DxfShape& shape, const InsertPlace& at) {
        if (shape.points.empty()) return;
        count(shape.points.size(), entity);
        const InsertPlace place = plane_of(entity, at);
        DrawnPath path{layer_of(entity, at),
                       place.group,
                       Points2(static_cast<Eigen::Index>(shape.points.size()), 2),
                       shape.is_closed,
                       std::string(entity.type()),
                       entity.line(),
                       farthest,
                       -farthest};
        for (std::size_t i = 0; i < shape.points.size(); ++i) {
            const Vec3 point = moved(entity, place, shape.points[i]);
            path.points.row(static_cast<Eigen::Index>(i)) = point.head<2>();
            path.low = std::min(path.low, point.z());
            path.high = std::max(path.high, point.z());
        }
        drawing_.paths.push_back(std::move(path));
    }

    void add_point(const DxfEntity& entity, const InsertPlace& place) {
        drawing_.points.push_back({layer_of(entity, place), place.group,
                                   moved(entity, place, {entity.number(10), entity.number(20), 0}).head<2>(),
                                   entity.number(30), entity.number(39), entity.number(50)});
    }

    void add_text(const DxfEntity& entity, const InsertPlace& at) {
        const InsertPlace place = plane_of(entity, at);
        const bool is_paragraph = entity.type() == "MTEXT";
        const double kind = entity.number(72);  // 3 and 5 fit a text between two points and use the first
        const bool is_aligned = !is_paragraph && kind != 3 && kind != 5 && (kind != 0 || entity.number(73) != 0);
        std::string text;
        for (const DxfTag& tag : entity.tags().subspan(1)) {
            if (tag.code == 1 || (tag.code == 3 && is_paragraph)) text += tag.value;
            if (tag.code == 101) break;
        }
        const Vec3 given = is_paragraph ? entity.place(11) : Vec3(0, 0, 0);
        const double turn = given.norm() > 0 ? std::atan2(given.y(), given.x()) / degree : entity.number(50);
        DrawnText drawn{layer_of(entity, at), place.group,
                        readable_name(text),  moved(entity, place, entity.place(is_aligned ? 11 : 10)).head<2>(),
                        entity.number(40),    turn};
        if (const Eigen::Matrix3d motion = place.motion.linear(); !motion.isIdentity(0)) {
            const Eigen::Matrix3d turned = motion * Eigen::AngleAxisd(turn * degree, Vec3::UnitZ());
            drawn.turn = std::atan2(turned(1, 0), turned(0, 0)) / degree;
            drawn.height *= turned.col(1).head<2>().norm();
        }
        drawing_.texts.push_back(std::move(drawn));
    }

    void insert(const DxfEntity& entity, const InsertPlace& at) {
        const auto found = blocks_.find(dxf_key(entity.text(2)));
        if (found == blocks_.end())
            refuse(entity.line(), "INSERT of " + shown(entity.text(2)) +
                                      ", expected a block of the file; export the drawing with its blocks");
        if (at.depth == deepest_insert)
            refuse(entity.line(), "blocks are nested more than " + std::to_string(deepest_insert) +
                                      " deep, or a block contains itself; explode them");
        Block& block = found->second;
        block.is_used = true;
        InsertPlace place = plane_of(entity, at);
        ++place.depth;
        place.layer = layer_of(entity, at);
        // Without a distance, all columns would coincide.
        const int columns = entity.number(44) == 0 ? 1 : std::max(1, entity.flags(70));
        const int rows = entity.number(45) == 0 ? 1 : std::max(1, entity.flags(71));
        for (int row = 0; row < rows; ++row)
            for (int column = 0; column < columns; ++column) {
                count(1, entity);
                if (at.group < 0) {
                    place.group = static_cast<int>(drawing_.groups.size());
                    drawing_.groups.push_back({block.name, place.layer, 1, entity.line()});
                }
                const Vec3 cell(column * entity.number(44), row * entity.number(45), 0);
                const Vec3 scale(entity.number(41, 1), entity.number(42, 1), entity.number(43, 1));
                InsertPlace inside = place;
                inside.motion = place.motion * Eigen::Translation3d(entity.place(10)) *
                                Eigen::AngleAxisd(entity.number(50) * degree, Vec3::UnitZ()) *
                                Eigen::Translation3d(cell) * Eigen::Scaling(scale) * Eigen::Translation3d(-block.base);
                draw(block.tags, inside);
            }
    }

    const std::string& name_;
    std::vector<DxfTag> tags_;
    DxfTagSpan entities_;
    bool has_entities_ = false;
    std::map<std::string, Block> blocks_;  // by `dxf_key`; so are the next two
    std::map<std::string, std::string> spellings_;
    std::set<std::string> off_layers_, frozen_layers_;
    PatternDrawing drawing_;
    std::size_t drawn_ = 0, most_ = 0;
};

}  // namespace

PatternDrawing read_dxf(std::istream& in, const std::string& name) {
    std::string bytes = read_bytes(in, name);
    require_ascii_dxf(bytes, name);
    const std::string text = dxf_text(std::move(bytes), name);
    return DxfReader(text, name).read();
}

}  // namespace ripstop
