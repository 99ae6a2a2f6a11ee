#include "ripstop/report/revision_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "ripstop/base/units.h"
#include "ripstop/report/figures.h"
#include "ripstop/report/text_table.h"

namespace ripstop {
namespace {

using Json = nlohmann::ordered_json;

double in_millimetres(double length) {
    return clean(length / millimetre);
}

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
            figure(change.grain_turn / degree, 3, true),
            std::to_string(change.edges.size()),
            ""};
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
    return text;
}

Json edge_json(const EdgeChange& edge) {
    return {{"edge", edge.edge + 1},
            {"length_before_mm", in_millimetres(edge.length_before)},
            {"length_after_mm", in_millimetres(edge.length_after)},
            {"allowance_before_mm", in_millimetres(edge.allowance_before)},
            {"allowance_after_mm", in_millimetres(edge.allowance_after)},
            {"type_before", edge.type_before},
            {"type_after", edge.type_after},
            {"notches_before", edge.notches_before},
            {"notches_after", edge.notches_after},
            {"notch_moved_mm", in_millimetres(edge.notch_moved)}};
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
    json["grain_turn_deg"] = clean(change.grain_turn / degree);
    json["edges"] = Json::array();
    for (const EdgeChange& edge : change.edges) json["edges"].push_back(edge_json(edge));
    json["fields"] = Json::array();
    for (const FieldChange& field : change.fields)
        json["fields"].push_back({{"field", field.field}, {"before", field.before}, {"after", field.after}});
    return json;
}

}  // namespace

std::string revision_text(const std::vector<PieceChange>& changes) {
    if (changes.empty()) return "No piece changed.\n";
    std::vector<TextRow> rows = {
        {"piece", "", "area cm2", "sew line mm", "outline mm", "fitted mm", "grain deg", "edges", ""}};
    for (const PieceChange& change : changes) rows.push_back(row_of(change));
    std::string text = aligned_table(rows, 2);
    for (const PieceChange& change : changes) {
        if (change.kind == PieceChange::Kind::changed && change.edges_before != change.edges_after)
            text += fmt::format("{}: {} to {} edges\n", change.piece, change.edges_before, change.edges_after);
        for (const EdgeChange& edge : change.edges)
            text += fmt::format("{} edge {}: {}\n", change.piece, edge.edge + 1, edge_text(edge));
        for (const FieldChange& field : change.fields)
            text += fmt::format("{}: {} \"{}\" to \"{}\"\n", change.piece, field.field, field.before, field.after);
    }
    return text;
}

std::string revision_json(const std::vector<PieceChange>& changes, const std::string& before,
                          const std::string& after) {
    Json list = Json::array();
    for (const PieceChange& change : changes) list.push_back(change_json(change));
    const Json json = {
        {"schema", "1.0"}, {"before", before}, {"after", after}, {"same", changes.empty()}, {"pieces", list}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace ripstop
