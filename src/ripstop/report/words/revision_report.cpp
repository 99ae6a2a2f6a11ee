#include "ripstop/report/words/revision_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "ripstop/base/text/units.h"
#include "ripstop/report/figures/figures.h"
#include "ripstop/report/figures/json_figures.h"
#include "ripstop/report/figures/text_table.h"

namespace ripstop {
namespace {

using Json = nlohmann::ordered_json;

const char* name_of(PieceChange::Kind kind) {
    switch (kind) {
        case PieceChange::Kind::added:
            return "added";
        case PieceChange::Kind::gone:
            return "gone";
        default:
            return "changed";
    }
}

const char* name_of(LineChange::Kind kind) {
    switch (kind) {
        case LineChange::Kind::added:
            return "added";
        case LineChange::Kind::gone:
            return "gone";
        default:
            return "moved";
    }
}

TextRow row_of(const PieceChange& change) {
    const bool is_there = change.kind == PieceChange::Kind::changed;
    const auto figure = [is_there](double value, int decimals, bool sign) {
        return is_there ? shown(value, decimals, sign) : std::string("-");
    };
    return {shortened(change.piece),
            name_of(change.kind),
            figure((change.area_after - change.area_before) * 1e4, 2, true),
            figure((change.perimeter_after - change.perimeter_before) / millimetre, 2, true),
            figure(change.distance / millimetre, 2, false),
            figure(change.distance_fitted / millimetre, 2, false),
            figure(change.sew_distance_fitted / millimetre, 2, false),
            figure(change.grain_turn / degree, 3, true),
            std::to_string(change.edges.size()),
            ""};
}

std::string mates_text(const std::vector<EdgeMate>& mates) {
    std::string text;
    for (const EdgeMate& mate : mates)
        text += fmt::format("{}{} ({:.2f} mm)", text.empty() ? "" : " + ", mate.piece, mate.length / millimetre);
    return text.empty() ? "nothing" : text;
}

bool are_other(const std::vector<EdgeMate>& a, const std::vector<EdgeMate>& b) {
    return !std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const EdgeMate& one, const EdgeMate& other) {
        return one.piece == other.piece && one.length == other.length;
    });
}

std::string edge_text(const EdgeChange& edge) {
    std::string text;
    const auto add = [&text](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
    if (edge.length_before != edge.length_after)
        add(fmt::format("{:.2f} to {:.2f} mm ({:+.2f})", edge.length_before / millimetre,
                        edge.length_after / millimetre, (edge.length_after - edge.length_before) / millimetre));
    if (edge.type_before != edge.type_after) add(edge.type_before + " to " + edge.type_after);
    if (edge.allowance_before != edge.allowance_after)
        add(fmt::format("allowance {:.2f} to {:.2f} mm", edge.allowance_before / millimetre,
                        edge.allowance_after / millimetre));
    if (edge.notches_before != edge.notches_after)
        add(fmt::format("{} to {} notches", edge.notches_before, edge.notches_after));
    if (edge.notch_moved > 0) add(fmt::format("notches moved by up to {:.2f} mm", edge.notch_moved / millimetre));
    if (edge.notch_depth_before != edge.notch_depth_after)
        add(fmt::format("notches {:.2f} to {:.2f} mm deep", edge.notch_depth_before / millimetre,
                        edge.notch_depth_after / millimetre));
    if (edge.doubles_before != edge.doubles_after)
        add(fmt::format("{} to {} double notches", edge.doubles_before, edge.doubles_after));
    if (are_other(edge.mates_before, edge.mates_after))
        add("sewn to " + mates_text(edge.mates_before) + ", now to " + mates_text(edge.mates_after));
    return text;
}

Json mates_json(const std::vector<EdgeMate>& mates) {
    Json list = Json::array();
    for (const EdgeMate& mate : mates)
        list.push_back({{"piece", mate.piece}, {"length_mm", in_millimetres(mate.length)}});
    return list;
}

Json fields_json(const std::vector<FieldChange>& fields) {
    Json list = Json::array();
    for (const FieldChange& field : fields)
        list.push_back({{"field", field.field}, {"before", field.before}, {"after", field.after}});
    return list;
}

Json edge_json(const EdgeChange& edge) {
    return {{"edge", edge.edge + 1},
            {"edge_after", edge.edge_after + 1},
            {"length_before_mm", in_millimetres(edge.length_before)},
            {"length_after_mm", in_millimetres(edge.length_after)},
            {"allowance_before_mm", in_millimetres(edge.allowance_before)},
            {"allowance_after_mm", in_millimetres(edge.allowance_after)},
            {"type_before", edge.type_before},
            {"type_after", edge.type_after},
            {"notches_before", edge.notches_before},
            {"notches_after", edge.notches_after},
            {"notch_moved_mm", in_millimetres(edge.notch_moved)},
            {"notch_depth_before_mm", in_millimetres(edge.notch_depth_before)},
            {"notch_depth_after_mm", in_millimetres(edge.notch_depth_after)},
            {"double_notches_before", edge.doubles_before},
            {"double_notches_after", edge.doubles_after},
            {"mates_before", mates_json(edge.mates_before)},
            {"mates_after", mates_json(edge.mates_after)}};
}

Json change_json(const PieceChange& change) {
    Json json = {{"piece", change.piece}, {"change", name_of(change.kind)}};
    if (change.kind != PieceChange::Kind::added) {
        json["area_before_m2"] = clean(change.area_before);
        json["perimeter_before_mm"] = in_millimetres(change.perimeter_before);
        json["edges_before"] = change.edges_before;
    }
    if (change.kind != PieceChange::Kind::gone) {
        json["area_after_m2"] = clean(change.area_after);
        json["perimeter_after_mm"] = in_millimetres(change.perimeter_after);
        json["edges_after"] = change.edges_after;
    }
    if (change.kind != PieceChange::Kind::changed) return json;
    json["distance_mm"] = in_millimetres(change.distance);
    json["distance_fitted_mm"] = in_millimetres(change.distance_fitted);
    json["sew_distance_fitted_mm"] = in_millimetres(change.sew_distance_fitted);
    json["grain_turn_deg"] = clean(change.grain_turn / degree);
    json["edges"] = Json::array();
    for (const EdgeChange& edge : change.edges) json["edges"].push_back(edge_json(edge));
    json["fields"] = fields_json(change.fields);
    json["lines"] = Json::array();
    for (const LineChange& line : change.lines)
        json["lines"].push_back(
            {{"line", line.line}, {"change", name_of(line.kind)}, {"distance_mm", in_millimetres(line.distance)}});
    return json;
}

std::string table_of(const std::vector<PieceChange>& changes) {
    std::vector<TextRow> rows = {
        {"piece", "", "area cm2", "sew length mm", "outline mm", "fitted mm", "sew line mm", "grain deg", "edges", ""}};
    for (const PieceChange& change : changes) rows.push_back(row_of(change));
    return aligned_table(rows, 2);
}

std::string numbers_text(const EdgeChange& edge) {
    const std::string number = std::to_string(edge.edge + 1);
    return edge.edge == edge.edge_after ? number : fmt::format("{} (now {})", number, edge.edge_after + 1);
}

std::string line_text(const LineChange& line) {
    if (line.kind != LineChange::Kind::moved) return name_of(line.kind);
    return fmt::format("moved by up to {:.2f} mm", line.distance / millimetre);
}

}  // namespace

std::string revision_text(const std::vector<PieceChange>& changes, const std::vector<SeamTypeChange>& seam_types) {
    std::string text = changes.empty() ? "No piece changed.\n" : table_of(changes);
    for (const SeamTypeChange& type : seam_types)
        for (const FieldChange& field : type.fields)
            text += fmt::format("seam type {}: {} {} to {}\n", type.seam_type, field.field, field.before, field.after);
    for (const PieceChange& change : changes) {
        if (change.kind == PieceChange::Kind::changed && change.edges_before != change.edges_after)
            text += fmt::format("{}: {} to {} edges\n", change.piece, change.edges_before, change.edges_after);
        for (const EdgeChange& edge : change.edges)
            text += fmt::format("{} edge {}: {}\n", change.piece, numbers_text(edge), edge_text(edge));
        for (const LineChange& line : change.lines)
            text += fmt::format("{}: line \"{}\" {}\n", change.piece, line.line, line_text(line));
        for (const FieldChange& field : change.fields)
            text += fmt::format("{}: {} \"{}\" to \"{}\"\n", change.piece, field.field, field.before, field.after);
    }
    return text;
}

std::string revision_json(const std::vector<PieceChange>& changes, const std::vector<SeamTypeChange>& seam_types,
                          const std::string& before, const std::string& after) {
    Json list = Json::array(), types = Json::array();
    for (const SeamTypeChange& type : seam_types)
        types.push_back({{"seam_type", type.seam_type}, {"fields", fields_json(type.fields)}});
    for (const PieceChange& change : changes) list.push_back(change_json(change));
    const Json json = {{"schema", "1.0"},     {"before", before},
                       {"after", after},      {"same", changes.empty() && seam_types.empty()},
                       {"seam_types", types}, {"pieces", list}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace ripstop
