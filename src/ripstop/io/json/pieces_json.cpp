#include "ripstop/io/json/pieces_json.h"

#include <cmath>
#include <set>
#include <sstream>

#include "ripstop/base/error.h"
#include "ripstop/io/json/fabric_json.h"
#include "ripstop/io/json/json_text.h"
#include "ripstop/io/json/plan_reader.h"
#include "ripstop/io/text/text.h"

namespace ripstop {
namespace {

using Json = nlohmann::ordered_json;
using nlohmann::json;

constexpr double largest = 1e3;  // [m]

Json points_json(const Points2& points) {
    Json list = Json::array();
    for (Eigen::Index i = 0; i < points.rows(); ++i) list.push_back({points(i, 0), points(i, 1)});
    return list;
}

Json edge_json(const PieceEdge& edge) {
    Json mates = Json::array();
    for (const Mate& mate : edge.mates)
        mates.push_back({{"seam", mate.seam}, {"piece", mate.piece}, {"length_m", mate.length}, {"type", mate.type}});
    return {{"first", edge.first},
            {"length_m", edge.length},
            {"allowance_m", edge.allowance},
            {"type", edge.seam_type},
            {"mates", mates}};
}

Json notch_json(const PieceNotch& notch) {
    return {{"edge", notch.edge},
            {"seam", notch.seam},
            {"along_m", notch.along},
            {"on_sew_m", {notch.on_sew.x(), notch.on_sew.y()}},
            {"outward", {notch.outward.x(), notch.outward.y()}},
            {"reach_m", notch.reach},
            {"depth_m", notch.depth},
            {"count", notch.count}};
}

Json met_json(const MetAllowances& met) {
    return {{"edge", met.edge}, {"mate_edge", met.mate_edge}, {"length_m", met.length},
            {"gap_m", met.gap}, {"left_m", met.left},         {"at_m", {met.at.x(), met.at.y()}}};
}

Json piece_json(const PatternPiece& piece) {
    Json edges = Json::array(), notches = Json::array(), lines = Json::array(), labels = Json::array(),
         met = Json::array();
    for (const MetAllowances& allowances : piece.met) met.push_back(met_json(allowances));
    for (const PieceEdge& edge : piece.edges) edges.push_back(edge_json(edge));
    for (const PieceNotch& notch : piece.notches) notches.push_back(notch_json(notch));
    for (const DrawnLine& line : piece.lines)
        lines.push_back({{"name", line.name}, {"points_m", points_json(line.points)}});
    for (const Label& label : piece.labels)
        labels.push_back({{"text", label.text},
                          {"middle_m", {label.middle.x(), label.middle.y()}},
                          {"height_m", label.height},
                          {"turn_rad", label.turn},
                          {"counts", label.counts}});
    return {{"name", piece.name},
            {"file", piece.file},
            {"gore", piece.gore},
            {"row", piece.row},
            {"fabric", piece.fabric},
            {"colour", piece.colour},
            {"revision", piece.revision},
            {"quantity", piece.quantity},
            {"quantity_mirrored", piece.quantity_mirrored},
            {"pattern", piece.pattern},
            {"mirrored", piece.mirrored},
            {"sew_line_m", points_json(piece.sew_line)},
            {"edges", edges},
            {"cut_line_m", points_json(piece.cut_line)},
            {"allowances_met", met},
            {"notches", notches},
            {"grain_line_m", points_json(piece.grain_line)},
            {"lines", lines},
            {"labels", labels}};
}

Vec2 plane_point_in(const PlanReader& from, const json& at, const char* key) {
    if (!at.is_array() || at.size() != 2 || !at[0].is_number() || !at[1].is_number() ||
        !(std::abs(at[0].get<double>()) <= largest) || !(std::abs(at[1].get<double>()) <= largest))
        from.refuse(std::string(key) + " has an entry that is not a point, expected [x, y] in metres");
    return {at[0].get<double>(), at[1].get<double>()};
}

Vec2 plane_point(const PlanReader& from, const char* key) {
    if (!from.has(key)) from.refuse(std::string(key) + " is missing, expected [x, y]");
    return plane_point_in(from, from.value().at(key), key);
}

Points2 points_at(const PlanReader& from, const char* key, Eigen::Index least) {
    const json& rows = from.list(key);
    Points2 result(static_cast<Eigen::Index>(rows.size()), 2);
    for (std::size_t i = 0; i < rows.size(); ++i)
        result.row(static_cast<Eigen::Index>(i)) = plane_point_in(from, rows[i], key);
    if (result.rows() != 0 && result.rows() < least) from.refuse(std::string(key) + " has too few points");
    return result;
}

PieceEdge read_edge(const PlanReader& from, int points) {
    PieceEdge edge;
    edge.first = from.whole("first", 0, std::max(0, points - 1));
    edge.length = from.number("length_m", largest);
    edge.allowance = from.number("allowance_m", largest);
    if (edge.allowance < 0) from.refuse("allowance_m is negative");
    edge.seam_type = from.text_or_none("type");
    edge.mates = from.each<Mate>("mates", [](const PlanReader& mate) {
        return Mate{mate.text_or_none("seam"), mate.text_or_none("piece"), mate.number("length_m", largest),
                    mate.text_or_none("type")};
    });
    return edge;
}

PieceNotch read_notch(const PlanReader& from, int edges) {
    PieceNotch notch;
    notch.edge = from.whole("edge", 0, std::max(0, edges - 1));
    notch.seam = from.text_or_none("seam");
    notch.along = from.number("along_m", largest);
    notch.on_sew = plane_point(from, "on_sew_m");
    notch.outward = plane_point(from, "outward");
    if (std::abs(notch.outward.norm() - 1) > 1e-6) from.refuse("outward is not a unit vector");
    notch.reach = from.number("reach_m", largest);
    notch.depth = from.number("depth_m", largest);
    notch.count = from.whole("count", 1, 2);
    return notch;
}

MetAllowances read_met(const PlanReader& from, int edges) {
    MetAllowances met;
    met.edge = from.whole("edge", 0, std::max(0, edges - 1));
    met.mate_edge = from.whole("mate_edge", 0, std::max(0, edges - 1));
    met.length = from.number("length_m", largest);
    met.gap = from.number("gap_m", largest);
    met.left = from.number("left_m", largest);
    met.at = plane_point(from, "at_m");
    return met;
}

PatternPiece read_piece(const PlanReader& from) {
    PatternPiece piece;
    piece.name = from.text_or_none("name");
    piece.file = from.text_or_none("file");
    if (piece.file.empty() || piece.file.find_first_of("/\\") != std::string::npos)
        from.refuse("file is not a valid file name");
    piece.gore = from.text_or_none("gore");
    piece.row = from.text_or_none("row");
    piece.fabric = from.text_or_none("fabric");
    piece.colour = from.text_or_none("colour");
    piece.revision = from.text_or_none("revision");
    piece.quantity = from.whole("quantity", 0, 1000000);
    piece.quantity_mirrored = from.whole("quantity_mirrored", 0, 1000000);
    piece.pattern = from.text_or_none("pattern");
    piece.mirrored = from.flag("mirrored");
    piece.sew_line = points_at(from, "sew_line_m", 3);
    if (piece.sew_line.rows() == 0) from.refuse("sew_line_m is empty");
    const int points = static_cast<int>(piece.sew_line.rows());
    piece.edges = from.each<PieceEdge>("edges", [points](const PlanReader& edge) { return read_edge(edge, points); });
    for (std::size_t e = 1; e < piece.edges.size(); ++e)
        if (piece.edges[e].first <= piece.edges[e - 1].first) from.refuse("its edges are out of order");
    piece.cut_line = points_at(from, "cut_line_m", 3);
    const int edges = static_cast<int>(piece.edges.size());
    piece.notches =
        from.each<PieceNotch>("notches", [edges](const PlanReader& notch) { return read_notch(notch, edges); });
    if (edges == 0 && !piece.notches.empty()) from.refuse("has notches and no edges");
    if (edges > 0 && from.has("allowances_met"))
        piece.met =
            from.each<MetAllowances>("allowances_met", [edges](const PlanReader& met) { return read_met(met, edges); });
    piece.grain_line = points_at(from, "grain_line_m", 2);
    if (piece.grain_line.rows() > 2) from.refuse("grain_line_m has more than its two ends");
    piece.lines = from.each<DrawnLine>("lines", [](const PlanReader& line) {
        DrawnLine drawn{line.text_or_none("name"), points_at(line, "points_m", 2)};
        if (drawn.points.rows() == 0) line.refuse("points_m is empty");
        return drawn;
    });
    piece.labels = from.each<Label>("labels", [](const PlanReader& label) {
        return Label{label.text_or_none("text"), plane_point(label, "middle_m"), label.number("height_m", largest),
                     label.number("turn_rad", largest), label.flag("counts")};
    });
    return piece;
}

/// Pieces refer to each other by name (mates, shared patterns, the roll), so names must be unique and known.
void check_names(const PieceSet& set, const PlanReader& from) {
    std::set<std::string> names, files, patterns, fabrics{""};
    for (const Fabric& fabric : set.fabrics) fabrics.insert(fabric.name);
    for (const PatternPiece& piece : set.pieces) {
        if (!files.insert(piece.file).second) from.refuse("two pieces have the file " + piece.file);
        if (!names.insert(piece.name).second) from.refuse("two pieces are called " + piece.name);
        if (!fabrics.contains(piece.fabric)) from.refuse(piece.name + ": no fabric is called " + piece.fabric);
        if (piece.pattern.empty()) patterns.insert(piece.name);
    }
    for (const PatternPiece& piece : set.pieces)
        if (!piece.pattern.empty() && !patterns.contains(piece.pattern))
            from.refuse(piece.name + ": no piece with a pattern of its own is called " + piece.pattern);
}

}  // namespace

std::string pieces_json(const PieceSet& set) {
    Json pieces = Json::array(), fabrics = Json::array(), types = Json::array();
    for (const PatternPiece& piece : set.pieces) pieces.push_back(piece_json(piece));
    for (const Fabric& fabric : set.fabrics) fabrics.push_back(Json::parse(write_fabric(fabric)));
    for (const SeamType& type : set.seam_types)
        types.push_back(
            {{"name", type.name}, {"allowance_m", type.allowance}, {"rows", type.rows}, {"tape", type.tape}});
    const Json json = {{"input", set.input},
                       {"revision", set.revision},
                       {"fabrics", fabrics},
                       {"seam_types", types},
                       {"pieces", pieces}};
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

PieceSet read_pieces(std::istream& in, const std::string& name) {
    const json object = read_json_object(in, name);
    const PlanReader from(object, name);
    PieceSet set;
    set.input = from.text_or_none("input");
    set.revision = from.text_or_none("revision");
    set.fabrics = from.each<Fabric>("fabrics", [](const PlanReader& fabric) {
        std::istringstream text(fabric.value().dump());
        return read_fabric(text, fabric.place());
    });
    if (set.fabrics.empty()) from.refuse("no fabric");
    set.seam_types = from.each<SeamType>("seam_types", [](const PlanReader& type) {
        return SeamType{type.text_or_none("name"), type.number("allowance_m", largest), type.whole("rows", 0, 100),
                        type.flag("tape")};
    });
    set.pieces = from.each<PatternPiece>("pieces", read_piece);
    check_names(set, from);
    return set;
}

}  // namespace ripstop
