#include "ripstop/io/svg_read.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <pugixml.hpp>
#include <set>
#include <string_view>

#include "ripstop/base/error.h"
#include "ripstop/base/stated_unit.h"
#include "ripstop/base/units.h"
#include "ripstop/io/svg_path.h"
#include "ripstop/io/text.h"

namespace ripstop {
namespace {

constexpr int deepest = 256;
constexpr double farthest = 1e9;

/// What elements within each other hand down.
struct Place {
    Eigen::Affine2d motion = Eigen::Affine2d::Identity();
    int group = -1;
    std::string layer;
    int depth = 0;
};

class Reader {
  public:
    Reader(const std::string& bytes, const std::string& name) : name_(name) {
        const pugi::xml_parse_result result = document_.load_buffer(bytes.data(), bytes.size());
        if (!result)
            throw InputError(name + ": byte " + std::to_string(result.offset) + ": " + result.description() +
                             ", expected XML; export the drawing again");
    }

    PatternDrawing read() {
        const pugi::xml_node root = document_.document_element();
        if (local_name(root) != "svg")
            refuse(root, "the root is " + shown(root.name()) + ", expected svg; export the drawing as SVG");
        drawing_.format = "SVG";
        read_unit(root);
        Place place;
        place.motion.linear()(1, 1) = -1;  // y up
        place.layer = "";
        for (const pugi::xml_node& child : root.children()) draw(child, place);
        return std::move(drawing_);
    }

  private:
    static std::string_view local_name(const pugi::xml_node& node) {
        const std::string_view name = node.name();
        const std::size_t colon = name.find(':');
        return colon == std::string_view::npos ? name : name.substr(colon + 1);
    }

    std::string place_of(const pugi::xml_node& node) const {
        return name_ + ": byte " + std::to_string(node.offset_debug());
    }

    [[noreturn]] void refuse(const pugi::xml_node& node, const std::string& what) const {
        throw InputError(place_of(node) + ": " + what);
    }

    double number(const pugi::xml_node& node, const char* key) const {
        const auto length = stated_length(node.attribute(key).value());
        if (!length) {
            if (node.attribute(key)) refuse(node, std::string(key) + " is no number; export the drawing again");
            return 0;
        }
        if (std::abs(length->number) > farthest) refuse(node, std::string(key) + " is beyond 1e9; scale the drawing");
        return length->number;
    }

    /// One user unit, from `width="210mm"` and `viewBox="0 0 210 297"`, or from the height.
    void read_unit(const pugi::xml_node& root) {
        const std::vector<double> box = svg_numbers(root.attribute("viewBox").value(), place_of(root));
        for (const auto& [key, index] : {std::pair("width", 2U), std::pair("height", 3U)}) {
            const auto length = stated_length(root.attribute(key).value());
            if (!length || !length->unit || !(length->number > 0)) continue;
            if (box.size() == 4 && !(box[index] > 0)) continue;
            const double metres = length->number * length->unit->metres / (box.size() == 4 ? box[index] : 96.0);
            // Without a viewBox a user unit is 1/96 inch, whatever the width.
            const double unit = box.size() == 4 ? metres : metres_per_unit("in") / 96;
            if (!(unit > 1e-9 && unit < 10))
                refuse(root, std::string(key) + " makes a user unit of " + std::to_string(unit) +
                                 " m, expected less than 10 m and some length; export the drawing again");
            drawing_.units.push_back({key + std::string(box.size() == 4 ? " and viewBox" : ""), unit_of(unit)});
            return;
        }
    }

    static LengthUnit unit_of(double metres) {
        for (const char* known : {"mm", "cm", "m", "in", "ft"})
            if (std::abs(metres / metres_per_unit(known) - 1) < 1e-6) return {known, metres_per_unit(known)};
        return {std::to_string(metres / millimetre) + " mm", metres};
    }

    void draw(const pugi::xml_node& node, Place place) {
        if (node.type() != pugi::node_element) return;
        static const std::set<std::string_view> undrawn{"defs",  "symbol",    "clipPath", "mask",  "marker", "pattern",
                                                        "style", "namedview", "metadata", "title", "desc",   "script"};
        const std::string_view kind = local_name(node);
        if (undrawn.contains(kind)) return;
        if (++place.depth > deepest) refuse(node, "elements more than 256 deep, expected fewer; ungroup them");
        place.motion = place.motion * motion_of(node);
        if (kind == "g" || kind == "a" || kind == "svg" || kind == "switch") {
            enter(node, place);
            for (const pugi::xml_node& child : node.children()) draw(child, place);
            return;
        }
        if (const std::string own = node.attribute("class").value(); !own.empty()) place.layer = readable_name(own);
        if (kind == "path")
            draw_path(node, place);
        else if (kind == "text")
            draw_text(node, place);
        else if (!draw_shape(node, kind, place))
            drawing_.leave_unread(readable_name(kind.substr(0, 40)), place.layer, node.offset_debug());
    }

    void enter(const pugi::xml_node& node, Place& place) {
        const std::string label = readable_name(node.attribute("inkscape:label").value());
        const pugi::xml_attribute name = node.attribute("data-name");  // of a piece, which may be a layer to Inkscape
        if (std::string_view(node.attribute("inkscape:groupmode").value()) == "layer" && !name) {
            if (!label.empty()) place.layer = label;
            return;
        }
        std::string id = readable_name(name.value());
        if (id.empty()) id = readable_name(node.attribute("id").value());
        if (id.empty()) return;
        place.group = static_cast<int>(drawing_.groups.size());
        drawing_.groups.push_back({id, place.layer, 1, node.offset_debug()});
    }

    /// translate, scale, rotate, skewX, skewY and matrix, one after the other.
    Eigen::Affine2d motion_of(const pugi::xml_node& node) const {
        Eigen::Affine2d motion = Eigen::Affine2d::Identity();
        std::string_view rest = node.attribute("transform").value();
        for (std::size_t open; (open = rest.find('(')) != std::string_view::npos;) {
            const std::size_t close = rest.find(')', open);
            if (close == std::string_view::npos) refuse(node, "a transform without end; export the drawing again");
            std::string_view kind = rest.substr(0, open);
            while (!kind.empty() && std::string_view(" \t\r\n,").find(kind.front()) != std::string_view::npos)
                kind.remove_prefix(1);
            const std::vector<double> n = svg_numbers(rest.substr(open + 1, close - open - 1), place_of(node));
            motion = motion * one_motion(node, trimmed(kind), n);
            rest.remove_prefix(close + 1);
        }
        return motion;
    }

    Eigen::Affine2d one_motion(const pugi::xml_node& node, std::string_view kind, const std::vector<double>& n) const {
        const auto at = [&n](std::size_t i, double otherwise) { return i < n.size() ? n[i] : otherwise; };
        Eigen::Affine2d motion = Eigen::Affine2d::Identity();
        if (n.empty()) refuse(node, "a transform without numbers; export the drawing again");
        if (kind == "translate")
            motion.translation() = Vec2(n[0], at(1, 0));
        else if (kind == "scale")
            motion.linear() = Vec2(n[0], at(1, n[0])).asDiagonal();
        else if (kind == "skewX")
            motion.linear()(0, 1) = std::tan(n[0] * degree);
        else if (kind == "skewY")
            motion.linear()(1, 0) = std::tan(n[0] * degree);
        else if (kind == "rotate") {
            const Vec2 centre(at(1, 0), at(2, 0));
            motion = Eigen::Translation2d(centre) * Eigen::Rotation2Dd(n[0] * degree) * Eigen::Translation2d(-centre);
        } else if (kind == "matrix" && n.size() == 6) {
            motion.linear() << n[0], n[2], n[1], n[3];
            motion.translation() = Vec2(n[4], n[5]);
        } else {
            refuse(node, "the transform " + shown(kind) + ", expected one of SVG; export the drawing again");
        }
        return motion;
    }

    Vec2 moved(const pugi::xml_node& node, const Place& place, const Vec2& p) const {
        const Vec2 at = place.motion * p;
        if (!(at.cwiseAbs().maxCoeff() <= farthest)) refuse(node, "a point beyond 1e9; scale the drawing");
        return at;
    }

    void add(const pugi::xml_node& node, const Place& place, const std::vector<Vec2>& points, bool is_closed) {
        if (points.empty()) return;
        DrawnPath path{place.layer,
                       place.group,
                       Points2(static_cast<Eigen::Index>(points.size()), 2),
                       is_closed,
                       std::string(local_name(node)),
                       static_cast<long>(node.offset_debug())};
        for (std::size_t i = 0; i < points.size(); ++i)
            path.points.row(static_cast<Eigen::Index>(i)) = moved(node, place, points[i]);
        const Eigen::Index last = path.points.rows() - 1;
        if (is_closed && last > 0 && path.points.row(last) == path.points.row(0))
            path.points.conservativeResize(last, 2);
        drawing_.paths.push_back(std::move(path));
    }

    void draw_path(const pugi::xml_node& node, const Place& place) {
        const SvgPath path = svg_path(node.attribute("d").value(), place_of(node));
        if (path.has_arcs) return drawing_.leave_unread("path", place.layer, node.offset_debug());
        for (const SvgRun& run : path.runs) add(node, place, run.points, run.is_closed);
    }

    bool draw_shape(const pugi::xml_node& node, std::string_view kind, const Place& place) {
        if (kind == "line") {
            add(node, place,
                {Vec2(number(node, "x1"), number(node, "y1")), Vec2(number(node, "x2"), number(node, "y2"))}, false);
        } else if (kind == "polyline" || kind == "polygon") {
            const std::vector<double> n = svg_numbers(node.attribute("points").value(), place_of(node));
            std::vector<Vec2> points;
            for (std::size_t i = 0; i + 1 < n.size(); i += 2) points.emplace_back(n[i], n[i + 1]);
            add(node, place, points, kind == "polygon");
        } else if (kind == "rect") {
            const Vec2 a(number(node, "x"), number(node, "y"));
            const double w = number(node, "width"), h = number(node, "height");
            add(node, place, {a, a + Vec2(w, 0), a + Vec2(w, h), a + Vec2(0, h)}, true);
        } else if (kind == "circle" || kind == "ellipse") {
            const Vec2 centre(number(node, "cx"), number(node, "cy"));
            const Vec2 radii = kind == "circle" ? Vec2(number(node, "r"), number(node, "r"))
                                                : Vec2(number(node, "rx"), number(node, "ry"));
            std::vector<Vec2> points;
            for (int i = 0; i < 360; ++i)
                points.push_back(centre + radii.cwiseProduct(Vec2(std::cos(i * degree), std::sin(i * degree))));
            add(node, place, points, true);
        } else {
            return false;
        }
        return true;
    }

    void draw_text(const pugi::xml_node& node, const Place& place) {
        std::string text = node.text().get();
        for (const pugi::xml_node& part : node.children())
            if (local_name(part) == "tspan") text += part.text().get();
        const Vec2 at(number(node, "x"), number(node, "y"));
        const Vec2 along = place.motion.linear().col(0);
        drawing_.texts.push_back({place.layer, place.group, readable_name(trimmed(text)), moved(node, place, at),
                                  number(node, "font-size"), std::atan2(along.y(), along.x()) / degree});
    }

    const std::string& name_;
    pugi::xml_document document_;
    PatternDrawing drawing_;
};

}  // namespace

PatternDrawing read_svg(std::istream& in, const std::string& name) {
    const std::string bytes = read_bytes(in, name);
    return Reader(bytes, name).read();
}

}  // namespace ripstop
