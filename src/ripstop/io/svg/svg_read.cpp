#include "ripstop/io/svg/svg_read.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

#include "ripstop/base/error.h"
#include "ripstop/base/text/units.h"
#include "ripstop/io/svg/svg_clip.h"
#include "ripstop/io/svg/svg_scale.h"
#include "ripstop/io/svg/svg_shape.h"
#include "ripstop/io/svg/svg_text.h"
#include "ripstop/io/svg/values/svg_path.h"
#include "ripstop/io/svg/values/svg_view.h"
#include "ripstop/io/text/text.h"

namespace ripstop {
namespace {

constexpr int deepest_element = 256;
constexpr double farthest_point = 1e9;
constexpr int most_used = 200'000;              // elements that `use` draws again
constexpr std::size_t most_points = 8'000'000;  // of sampled curves

/// The state that elements pass down to their children.
struct ElementPlace {
    Eigen::Affine2d motion = Eigen::Affine2d::Identity();
    int group = -1;
    std::string layer = {};
    int depth = 0;
    SvgBasis basis = {};
    bool is_visible = true, is_filled = true, is_stroked = false, is_dashed = false;
    SvgClips clips = {};
};

bool is_none(std::string_view value) {
    return value.empty() || value == "none" || value == "initial";
}

class SvgReader {
  public:
    SvgReader(std::string bytes, const std::string& name) : document_(std::move(bytes), name), styles_(document_) {}

    PatternDrawing read() {
        const pugi::xml_node root = document_.root();
        const SvgStyle style = styles_.of(root);
        scale_ = svg_scale(document_, style);
        drawing_.format = "SVG";
        drawing_.units = scale_.units;
        sampling_ = scale_.sampling();
        ElementPlace place;
        place.motion = scale_.motion;
        place.basis.viewport = scale_.viewport;
        inherit(style, place);
        place.basis.root_font_size = place.basis.font_size;
        for (const SvgStyleDoubt& doubt : styles_.doubts())
            drawing_.leave_unread({"style rule (" + readable_name(doubt.text.substr(0, 80)) + ")", "", 1, doubt.line,
                                   "is not understood, and may hide or move lines; write its styles on the elements",
                                   true});
        if (!is_none(style["transform"]))
            leave(root, place, "transform of the whole page", "is not supported; put it on a group", true);
        if (style["display"] != "none")
            for (const pugi::xml_node& child : root.children()) draw(child, place);
        return std::move(drawing_);
    }

  private:
    void leave(const pugi::xml_node& node, const ElementPlace& place, std::string_view kind, const std::string& reason,
               bool may_be_cut, bool is_carried = false) {
        const auto along = [&](const char* key, const char* other, SvgAxis axis) {
            const pugi::xml_attribute given = node.attribute(key);
            return svg_length((given ? given : node.attribute(other)).value(), axis, place.basis);
        };
        std::optional<Vec2> at;
        const auto x = along("x", "cx", SvgAxis::x), y = along("y", "cy", SvgAxis::y);
        if (x && y) at = place.motion * Vec2(*x, *y);
        if (at && !(at->cwiseAbs().maxCoeff() <= farthest_point)) at.reset();
        drawing_.leave_unread({readable_name(kind.substr(0, 60)), place.layer, 1, document_.line_of(node), reason,
                               may_be_cut, is_carried, at});
    }

    void inherit(const SvgStyle& style, ElementPlace& place) const {
        const auto is_given = [&style](const char* key) {
            static const std::set<std::string_view> as_around{"", "inherit", "unset", "revert", "revert-layer"};
            return !as_around.contains(style[key]);
        };
        if (is_given("visibility"))
            place.is_visible = style["visibility"] == "visible" || style["visibility"] == "initial";
        if (is_given("fill")) place.is_filled = style["fill"] != "none" && style["fill"] != "transparent";
        if (is_given("stroke")) place.is_stroked = !is_none(style["stroke"]) && style["stroke"] != "transparent";
        if (is_given("stroke-dasharray"))
            place.is_dashed = style["stroke-dasharray"].find_first_of("123456789") != std::string_view::npos;
        place.basis = svg_basis_within(place.basis, style);
    }

    void draw(const pugi::xml_node& node, ElementPlace place, bool is_used = false) {
        if (node.type() != pugi::node_element || is_foreign_to_svg(node)) return;
        static const std::set<std::string_view> undrawn{
            "defs",      "symbol",   "clipPath",  "mask",          "marker", "pattern",        "style",
            "namedview", "metadata", "title",     "desc",          "script", "linearGradient", "radialGradient",
            "filter",    "font",     "font-face", "color-profile", "view"};
        const std::string_view kind = svg_local_name(node);
        if ((undrawn.contains(kind) && !(is_used && kind == "symbol")) || !is_offered_by_svg(node)) return;
        const SvgStyle style = styles_.of(node);
        if (style["display"] == "none") return;
        for (const char* key : {"display", "visibility", "transform", "d"})
            if (style[key].find("var(") != std::string_view::npos)
                return leave(node, place, kind,
                             "has " + std::string(key) + "=" + shown(style[key]) + ", which is not supported", true);
        if (++place.depth > deepest_element)
            document_.refuse(node, "elements more than 256 deep, expected fewer; ungroup them");
        if (!using_.empty() && ++used_ > most_used)
            document_.refuse(node, "its uses draw more than 200000 elements; unlink the clones");
        if (kind == "a" && svg_local_name(node.parent()) == "a")
            return leave(node, place, kind, "is inside another a, so browsers do not draw it; ungroup it", true);
        inherit(style, place);
        if (scale_.is_pixel && drawing_.units.empty()) state_pixels(node);
        if (style["display"] == "contents") {
            if (kind == "g" || kind == "a") return draw_group(node, kind, place);
            if (kind == "svg" || kind == "symbol" || kind == "use" || kind == "switch")
                leave(node, place, kind, "has display: contents, which is not supported here; ungroup it", true);
            return;
        }
        if (!move(node, kind, style, place)) return;
        look_at_effects(node, kind, style, place);
        if (kind == "g" || kind == "a" || kind == "switch")
            draw_group(node, kind, place);
        else if (kind == "svg" || kind == "symbol")
            draw_viewport(node, kind, style, place);
        else if (kind == "use")
            draw_use(node, style, place);
        else
            draw_leaf(node, kind, style, place);
    }

    /// Applies `transform` about its origin. Returns false for an element that is moved in another way; it is left
    /// out.
    bool move(const pugi::xml_node& node, std::string_view kind, const SvgStyle& style, ElementPlace& place) {
        for (const char* other : {"translate", "rotate", "scale", "zoom", "offset-path"})
            if (!is_none(style[other])) {
                leave(node, place, kind, std::string("is moved by the style ") + other + ", which is not supported",
                      true);
                return false;
            }
        if (is_none(style["transform"])) return true;
        const Eigen::Affine2d motion = svg_transform(style["transform"], place.basis, document_.place_of(node));
        const std::optional<Vec2> origin = origin_of(node, style, place);
        if (!origin) {
            leave(node, place, kind, "has a transform origin that is not supported; apply its transform", true);
            return false;
        }
        place.motion = place.motion * Eigen::Translation2d(*origin) * motion * Eigen::Translation2d(-*origin);
        return true;
    }

    /// The transform origin, in the viewport, or in the box of a shape if `transform-box` says so.
    std::optional<Vec2> origin_of(const pugi::xml_node& node, const SvgStyle& style, const ElementPlace& place) const {
        const std::string_view text = style["transform-origin"], box = style["transform-box"];
        if (box.empty() || box == "view-box") return svg_transform_origin(text, place.basis);
        if (box != "fill-box" && box != "content-box") return std::nullopt;
        const auto shape = svg_shape(node, style, place.basis, document_.place_of(node));
        Eigen::AlignedBox2d extent;
        if (shape)
            for (const SvgRun& run : shape->runs)
                for (const Vec2& point : sampled(run, Eigen::Affine2d::Identity(), {1e9, 1e-5})) extent.extend(point);
        if (extent.isEmpty()) return std::nullopt;
        SvgBasis within = place.basis;
        within.viewport = extent.sizes();
        std::optional<Vec2> origin = svg_transform_origin(text, within);
        if (origin) *origin += extent.min();
        return origin;
    }

    /// Handles the effects on an element besides its line, and its clips.
    void look_at_effects(const pugi::xml_node& node, std::string_view kind, const SvgStyle& style,
                         ElementPlace& place) {
        if (!is_none(style["filter"])) leave(node, place, kind, "is read without its filter", false, true);
        if (!is_none(style["mask"])) leave(node, place, kind, "is read without its mask", false, true);
        for (const char* marker : {"marker", "marker-start", "marker-mid", "marker-end"})
            if (!is_none(style[marker])) {
                leave(node, place, kind, "is read without its markers", false, true);
                break;
            }
        for (const pugi::xml_node& child : node.children()) {
            const std::string_view name = svg_local_name(child);
            if (name.starts_with("animate") || name == "set")
                leave(node, place, kind, "is read as it is without its animation", false, true);
        }
        const std::string_view clip = style["clip-path"];
        if (is_none(clip)) return;
        const pugi::xml_node target = document_.target_of(clip);
        if (!target && clip.starts_with("url(")) return;  // such a clip has no effect
        place.clips.push_back(std::make_shared<const SvgClip>(
            target ? SvgClip::path(document_, styles_, target, place.motion, place.basis) : SvgClip::unknown()));
    }

    void draw_group(const pugi::xml_node& node, std::string_view kind, ElementPlace& place) {
        enter(node, place);
        for (const pugi::xml_node& child : node.children()) {
            draw(child, place);
            const bool is_choice =
                child.type() == pugi::node_element && !is_foreign_to_svg(child) && is_offered_by_svg(child);
            if (kind == "switch" && is_choice) return;
        }
    }

    void enter(const pugi::xml_node& node, ElementPlace& place) {
        const std::string label = readable_name(node.attribute("inkscape:label").value());
        const pugi::xml_attribute name = node.attribute("data-name");  // of a piece, which is a layer in Inkscape
        if (std::string_view(node.attribute("inkscape:groupmode").value()) == "layer" && !name) {
            if (!label.empty()) place.layer = label;
            return;
        }
        std::string id = readable_name(name.value());
        if (id.empty()) id = readable_name(node.attribute("id").value());
        if (id.empty()) return;
        place.group = static_cast<int>(drawing_.groups.size());
        drawing_.groups.push_back({id, place.layer, 1, document_.line_of(node)});
    }

    /// Draws a nested svg, or a symbol that is used: it has its own place, size and scale.
    void draw_viewport(const pugi::xml_node& node, std::string_view kind, const SvgStyle& style, ElementPlace& place) {
        std::vector<std::string> unclear;
        const Vec2 around = place.basis.viewport.value_or(Vec2(0, 0));
        const auto length = [&](const char* key, SvgAxis axis, double otherwise) {
            return svg_length_of(node, style, key, axis, place.basis, unclear, otherwise);
        };
        const Vec2 corner(length("x", SvgAxis::x, 0), length("y", SvgAxis::y, 0));
        const bool is_svg = kind == "svg";  // a symbol's own size is ignored
        Vec2 size(is_svg ? length("width", SvgAxis::x, around.x()) : around.x(),
                  is_svg ? length("height", SvgAxis::y, around.y()) : around.y());
        if (using_size_.x() >= 0) size.x() = using_size_.x();
        if (using_size_.y() >= 0) size.y() = using_size_.y();
        using_size_.setConstant(-1);
        const std::optional<SvgViewBox> box = svg_view_box(node.attribute("viewBox").value());
        if (!unclear.empty() || (box && !size.allFinite()))
            return leave(node, place, kind, "has a position or size that cannot be computed; ungroup it", true);
        if (size.minCoeff() <= 0 || (box && box->size.minCoeff() <= 0)) return;  // nothing of it is visible
        place.motion = place.motion * Eigen::Translation2d(corner);
        const std::string_view overflow = style["overflow"];
        if (size.allFinite() && overflow != "visible" && overflow != "auto")
            place.clips.push_back(std::make_shared<const SvgClip>(SvgClip::viewport(size, place.motion)));
        if (box)
            place.motion = place.motion * svg_view(*box, size, SvgFit(node.attribute("preserveAspectRatio").value()));
        place.basis.viewport = box ? box->size : size;
        enter(node, place);
        for (const pugi::xml_node& child : node.children()) draw(child, place);
    }

    void draw_use(const pugi::xml_node& node, const SvgStyle& style, ElementPlace& place) {
        if (!place.is_visible && svg_href(node).empty()) return;
        const pugi::xml_node target = document_.target_of(node);
        if (!target)
            return leave(node, place, "use",
                         "refers to " + shown(svg_href(node)) + ", which is not in the file; put it in", true);
        if (std::find(using_.begin(), using_.end(), target) != using_.end() || is_around(target, node))
            return leave(node, place, "use", "refers to an element that contains it; delete it", true);
        std::vector<std::string> unclear;
        const auto length = [&](const char* key, SvgAxis axis, double otherwise) {
            return svg_length_of(node, style, key, axis, place.basis, unclear, otherwise);
        };
        const Vec2 by(length("x", SvgAxis::x, 0), length("y", SvgAxis::y, 0));
        const std::string_view kind = svg_local_name(target);
        using_size_.setConstant(-1);
        if (kind == "svg" || kind == "symbol")
            using_size_ = Vec2(length("width", SvgAxis::x, -1), length("height", SvgAxis::y, -1));
        if (!unclear.empty())
            return leave(node, place, "use", "has " + unclear.front() + ", which cannot be computed; unlink it", true);
        if (const std::string own = node.attribute("class").value(); !own.empty()) place.layer = readable_name(own);
        if (node.attribute("id")) enter(node, place);
        place.motion = place.motion * Eigen::Translation2d(by);
        using_.push_back(target);
        draw(target, place, true);
        using_.pop_back();
        using_size_.setConstant(-1);
    }

    static bool is_around(const pugi::xml_node& target, pugi::xml_node node) {
        while (node && node != target) node = node.parent();
        return static_cast<bool>(node);
    }

    void draw_leaf(const pugi::xml_node& node, std::string_view kind, const SvgStyle& style, ElementPlace& place) {
        if (const std::string own = node.attribute("class").value(); !own.empty()) place.layer = readable_name(own);
        if (kind == "text") return draw_text(node, place);
        if (!place.is_visible) return;
        const auto shape = svg_shape(node, style, place.basis, document_.place_of(node));
        if (!shape) return leave(node, place, kind, "", false);
        if (!shape->unclear.empty())
            return leave(node, place, kind,
                         "has " + shape->unclear.front() + ", which cannot be computed; give it in mm", true);
        for (const SvgRun& run : shape->runs) add(node, place, run);
        if (shape->runs.empty()) return;
        if (place.is_dashed && place.is_stroked)
            leave(node, place, kind, "with dashes is read as a whole line", false, true);
        if (!place.is_stroked && (!place.is_filled || kind == "line"))
            leave(node, place, kind, "is read although it is invisible: it has no stroke and no fill", false, true);
    }

    /// Without a viewBox, a length in mm states how large a user unit is.
    void state_pixels(const pugi::xml_node& node) {
        for (const char* key : {"width", "height", "x", "y", "r", "rx", "ry", "cx", "cy", "x1", "y1", "x2", "y2"})
            if (is_absolute_svg_length(node.attribute(key).value())) {
                drawing_.units.push_back(
                    {std::string(key) + " of its " + std::string(svg_local_name(node)),
                     {std::to_string(1 / svg_units_per_mm) + " mm", millimetre / svg_units_per_mm}});
                return;
            }
    }

    Vec2 checked(const pugi::xml_node& node, const Vec2& at) const {
        if (!(at.cwiseAbs().maxCoeff() <= farthest_point))
            document_.refuse(node, "a point beyond 1e9; scale the drawing");
        return at;
    }

    void add(const pugi::xml_node& node, const ElementPlace& place, const SvgRun& run) {
        const std::vector<Vec2> points = sampled(run, place.motion, sampling_);
        if (points.size() > run.segments.size() + 1 && (points_ += points.size()) > most_points)
            document_.refuse(node, "its curves have more than 8 million points; split the drawing");
        DrawnPath path{place.layer,
                       place.group,
                       Points2(static_cast<Eigen::Index>(points.size()), 2),
                       run.is_closed,
                       std::string(svg_local_name(node)),
                       document_.line_of(node)};
        for (std::size_t i = 0; i < points.size(); ++i)
            path.points.row(static_cast<Eigen::Index>(i)) = checked(node, points[i]);
        for (const auto& clip : place.clips) {
            const SvgSeen seen = clip->seen(path.points);
            if (seen == SvgSeen::part)
                leave(node, place, path.entity,
                      "is cut off by a clip, and what remains cannot be computed; draw it as a line", true);
            if (seen != SvgSeen::all) return;
        }
        const Eigen::Index last = path.points.rows() - 1;
        if (path.is_closed && last > 0 && path.points.row(last) == path.points.row(0))
            path.points.conservativeResize(last, 2);
        drawing_.paths.push_back(std::move(path));
    }

    void draw_text(const pugi::xml_node& node, const ElementPlace& place) {
        const SvgText text = svg_text(node, styles_, place.basis, place.is_visible);
        if (text.has_text_path) leave(node, place, "textPath", "", false);
        const Vec2 along = place.motion.linear().col(0), up = place.motion.linear().col(1);
        for (const SvgTextLine& line : text.lines) {
            const double height = line.height * up.norm();
            drawing_.texts.push_back({place.layer, place.group, line.text, checked(node, place.motion * line.at),
                                      std::isfinite(height) ? height : 0, std::atan2(along.y(), along.x()) / degree});
        }
    }

    const SvgDocument document_;
    const SvgStyles styles_;
    SvgScale scale_;
    SvgSampling sampling_;
    std::vector<pugi::xml_node> using_;  // the elements that the enclosing uses refer to
    Vec2 using_size_ = Vec2(-1, -1);     // size that a `use` gives the next svg or symbol; below 0: its own size
    int used_ = 0;
    std::size_t points_ = 0;
    PatternDrawing drawing_;
};

}  // namespace

PatternDrawing read_svg(std::istream& in, const std::string& name) {
    return SvgReader(read_bytes(in, name), name).read();
}

}  // namespace ripstop
