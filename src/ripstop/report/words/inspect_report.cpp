#include "ripstop/report/words/inspect_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "ripstop/report/figures/figures.h"
#include "ripstop/report/figures/text_table.h"

namespace ripstop {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_rows = 20;

std::string layer_of(const Attributes& attributes) {
    const auto layer = attributes.find("layer");
    return layer == attributes.end() ? "-" : layer->second;
}

/// The designer's attributes besides the layer: `fabric=nylon, group=crown`.
std::string said(const Attributes& attributes) {
    std::string text;
    for (const auto& [key, value] : attributes)
        if (key != "layer") text += (text.empty() ? "" : ", ") + key + "=" + value;
    return shortened(text);
}

TextRow row(const std::string& name, const Attributes& attributes, std::vector<std::string> counts,
            const Points3& points) {
    TextRow cells = {shortened(name), shortened(layer_of(attributes))};
    std::move(counts.begin(), counts.end(), std::back_inserter(cells));
    for (int k = 0; k < 3; ++k)
        cells.push_back(fmt::format("{:.6g}", points.col(k).maxCoeff() - points.col(k).minCoeff()));
    cells.push_back(said(attributes));
    return cells;
}

std::string table(const char* title, std::vector<TextRow> rows, std::size_t count) {
    std::string text = "\n" + aligned_table(rows, 2);
    if (count + 1 > rows.size()) text += fmt::format("and {} more {}\n", count + 1 - rows.size(), title);
    return text;
}

std::string surfaces_text(const std::vector<NamedMesh>& surfaces) {
    if (surfaces.empty()) return "";
    std::vector<TextRow> rows = {{"surface", "layer", "vertices", "triangles", "x", "y", "z", ""}};
    for (std::size_t i = 0; i < std::min(surfaces.size(), most_rows); ++i) {
        const NamedMesh& s = surfaces[i];
        rows.push_back(row(s.name, s.attributes,
                           {std::to_string(s.mesh.vertex_count()), std::to_string(s.mesh.triangle_count())},
                           s.mesh.positions));
    }
    return table("surfaces", std::move(rows), surfaces.size());
}

std::string curves_text(const std::vector<NamedCurve>& curves) {
    if (curves.empty()) return "";
    std::vector<TextRow> rows = {{"curve", "layer", "points", "x", "y", "z", ""}};
    for (std::size_t i = 0; i < std::min(curves.size(), most_rows); ++i)
        rows.push_back(
            row(curves[i].name, curves[i].attributes, {std::to_string(curves[i].points.rows())}, curves[i].points));
    return table("curves", std::move(rows), curves.size());
}

Json point(const auto& row) {
    return Json::array({row[0], row[1], row[2]});
}

Json described(const std::string& name, const Attributes& attributes) {
    Json json = {{"name", name}, {"attributes", Json::object()}};
    for (const auto& [key, value] : attributes) json["attributes"][key] = value;
    return json;
}

void add_box(Json& json, const Points3& points) {
    json["box_min_file_unit"] = point(points.colwise().minCoeff().eval());
    json["box_max_file_unit"] = point(points.colwise().maxCoeff().eval());
}

}  // namespace

std::string inspect_text(const CadModel& model, const std::string& file) {
    std::string layers;
    for (std::size_t i = 0; i < std::min(model.layers.size(), most_rows); ++i)
        layers += (i ? ", " : "") + model.layers[i];
    if (model.layers.size() > most_rows) layers += fmt::format(" and {} more", model.layers.size() - most_rows);
    std::string text = fmt::format(
        "{}\n"
        "unit           {}\n"
        "layers         {}\n"
        "surfaces       {}\n"
        "curves         {}\n"
        "not read       {}\n",
        file, model.unit ? fmt::format("{} ({} m)", model.unit->name, model.unit->metres) : "none; give --unit",
        layers.empty() ? "none" : layers, model.surfaces.size(), model.curves.size(), model.unread.size());
    text += surfaces_text(model.surfaces);
    text += curves_text(model.curves);
    const auto list = [&text](const char* title, std::size_t count, const auto& line) {
        if (count > 0) text += "\n";
        for (std::size_t i = 0; i < std::min(count, most_rows); ++i) text += fmt::format("{:<14} {}\n", title, line(i));
        if (count > most_rows) text += fmt::format("{:<14} and {} more\n", title, count - most_rows);
    };
    list("not read", model.unread.size(), [&model](std::size_t i) {
        const UnreadObject& object = model.unread[i];
        const std::string on = object.attributes.count("layer") > 0 ? " on " + object.attributes.at("layer") : "";
        return fmt::format("{} {}{}: {}", object.type, object.name, on, object.reason);
    });
    list("remark", model.remarks.size(), [&model](std::size_t i) { return model.remarks[i]; });
    return text;
}

std::string inspect_json(const CadModel& model, const std::string& file) {
    Json json;
    json["input"] = {{"file", file}};
    json["input"]["unit"] = model.unit ? Json(model.unit->name) : Json(nullptr);
    json["input"]["unit_mm"] = model.unit ? Json(clean(model.unit->metres * 1000)) : Json(nullptr);
    json["layers"] = model.layers;
    for (const char* list : {"surfaces", "curves", "unread"}) json[list] = Json::array();
    for (const NamedMesh& surface : model.surfaces) {
        Json entry = described(surface.name, surface.attributes);
        entry["vertices"] = surface.mesh.vertex_count();
        entry["triangles"] = surface.mesh.triangle_count();
        add_box(entry, surface.mesh.positions);
        json["surfaces"].push_back(std::move(entry));
    }
    for (const NamedCurve& curve : model.curves) {
        Json entry = described(curve.name, curve.attributes);
        entry["points"] = curve.points.rows();
        entry["start_file_unit"] = point(curve.points.row(0));
        entry["end_file_unit"] = point(curve.points.row(curve.points.rows() - 1));
        add_box(entry, curve.points);
        json["curves"].push_back(std::move(entry));
    }
    for (const UnreadObject& object : model.unread) {
        Json entry = described(object.name, object.attributes);
        entry["type"] = object.type;
        entry["reason"] = object.reason;
        json["unread"].push_back(std::move(entry));
    }
    json["remarks"] = model.remarks;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace ripstop
