#include "ripstop/report/words/drawing_report.h"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>

#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"
#include "ripstop/report/figures/figures.h"

namespace ripstop {
namespace {

using Json = nlohmann::ordered_json;

constexpr int most_findings = 10;  // per code
constexpr std::size_t most_layers = 24;

std::string layers_text(const DrawingCheck& check) {
    std::string text;
    for (std::size_t i = 0; i < std::min(check.layers.size(), most_layers); ++i)
        text += (text.empty() ? "" : ", ") + (check.layers[i].name.empty() ? "(none)" : check.layers[i].name);
    return check.layers.size() > most_layers ? fmt::format("{} and {} more", text, check.layers.size() - most_layers)
           : text.empty()                    ? "none"
                                             : text;
}

std::string contours_text(const DrawingCheck& check) {
    int cut = 0;
    Vec2 largest = Vec2::Zero();
    double area = 0;
    for (const DrawingContour& contour : check.contours) {
        if (!contour.is_cut) continue;
        ++cut;
        area += contour.area;
        largest = largest.cwiseMax(contour.upper - contour.lower);
    }
    return fmt::format("{} closed to cut, {} m2, at most {} x {} mm; {} to sew; {} open", cut, format_fixed(area, 3),
                       format_fixed(largest.x() / millimetre, 1), format_fixed(largest.y() / millimetre, 1),
                       static_cast<int>(check.contours.size()) - cut, check.open_lines);
}

std::string issues_text(const DrawingCheck& check, bool wrong) {
    std::map<std::string, int> counts, shown;
    for (const DrawingIssue& issue : check.issues) ++counts[issue.code];
    std::string text;
    for (const DrawingIssue& issue : check.issues) {
        if (issue.is_wrong != wrong || ++shown[issue.code] > most_findings) continue;
        text += fmt::format("{:<14} {}", wrong ? "WRONG" : "note", issue.message);
        const int left = counts[issue.code] - most_findings;
        if (shown[issue.code] == most_findings && left > 0) text += fmt::format("; and {} more like this", left);
        text += "\n";
    }
    return text;
}

Json in_mm(const Vec2& p) {
    return Json::array({clean(p.x() / millimetre), clean(p.y() / millimetre)});
}

}  // namespace

std::string drawing_text(const DrawingCheck& check, const std::string& file) {
    std::string text = fmt::format("{:<14} {}\n", file, check.format);
    const auto line = [&text](const char* key, const std::string& value) {
        text += fmt::format("{:<14} {}\n", key, value);
    };
    line("unit", check.unit ? fmt::format("{}, by {}", check.unit->name, check.unit_from) : "not stated");
    if (check.square) line("square", fmt::format("{} mm as drawn", format_fixed(*check.square / millimetre, 3)));
    line("convention", check.convention);
    line("layers", layers_text(check));
    if (check.blocks > 0) line("blocks", std::to_string(check.blocks));
    line("contours", contours_text(check));
    text += issues_text(check, true) + issues_text(check, false);
    line("verdict", check.sound() ? "sound" : "not sound");
    return text;
}

std::string drawing_json(const DrawingCheck& check, const std::string& file) {
    Json layers = Json::array(), contours = Json::array(), issues = Json::array();
    for (const DrawingLayer& layer : check.layers)
        layers.push_back(
            {{"name", layer.name}, {"lines", layer.lines}, {"points", layer.points}, {"texts", layer.texts}});
    for (const DrawingContour& contour : check.contours)
        contours.push_back({{"piece", contour.piece},
                            {"layer", contour.layer},
                            {"use", contour.is_cut ? "cut" : "sew"},
                            {"lower_mm", in_mm(contour.lower)},
                            {"upper_mm", in_mm(contour.upper)},
                            {"area_m2", clean(contour.area)},
                            {"perimeter_mm", clean(contour.perimeter / millimetre)},
                            {"parts", contour.parts}});
    for (const DrawingIssue& issue : check.issues)
        issues.push_back({{"code", issue.code},
                          {"wrong", issue.is_wrong},
                          {"message", issue.message},
                          {"at_mm", issue.at ? in_mm(*issue.at) : Json()}});
    const Json json = {{"file", file},
                       {"format", check.format},
                       {"sound", check.sound()},
                       {"unit", check.unit ? Json(check.unit->name) : Json()},
                       {"unit_from", check.unit ? Json(check.unit_from) : Json()},
                       {"square_mm", check.square ? Json(clean(*check.square / millimetre)) : Json()},
                       {"convention", check.convention},
                       {"blocks", check.blocks},
                       {"open_lines", check.open_lines},
                       {"layers", layers},
                       {"contours", contours},
                       {"issues", issues}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace ripstop
