#include "ripstop/report/words/inflated_text.h"

#include <cmath>

#include "ripstop/base/text/units.h"
#include "ripstop/report/figures/figures.h"
#include "ripstop/report/figures/text_table.h"
#include "ripstop/report/words/inflated_says.h"

namespace ripstop {
namespace {

std::string mm(double length, bool with_sign = false) {
    return shown(length / millimetre, 1, with_sign);
}

/// A table with a blank line before it.
std::string block(const std::vector<TextRow>& rows, std::size_t words = 1) {
    return "\n" + aligned_table(rows, words);
}

std::string sizes(const Inflated& inflated) {
    const auto row = [](const char* what, double drawn, double there, double unit, int decimals) {
        return TextRow{what, shown(drawn / unit, decimals), shown(there / unit, decimals),
                       shown((there - drawn) / unit, decimals, true),
                       drawn > 0 ? shown((there / drawn - 1) / percent, 2, true) + " %" : ""};
    };
    return block({{"", "drawn", "inflated", "more by", ""},
                  row("height mm", inflated.drawn_height, inflated.height, millimetre, 1),
                  row("diameter mm", inflated.drawn_diameter, inflated.diameter, millimetre, 1),
                  row("volume m3", inflated.drawn_volume, inflated.volume, 1, 2)});
}

std::string loads(const Inflated& inflated) {
    std::vector<TextRow> rows{
        {"off the drawn shape", mm(inflated.off.rms) + " mm rms, " + mm(inflated.off.max, true) + " mm at most"},
        {"moved from its place", mm(inflated.off.moved_rms) + " mm rms, " + mm(inflated.off.moved_max) + " mm at most"},
        {"lift",
         shown(inflated.lift, 0) + " N besides its own " + shown(inflated.cloth_mass + inflated.tape_mass, 1) + " kg"},
        {"pressure at the top", shown(inflated.crown_pressure, 1) + " Pa"},
        {"tension of the cloth",
         shown(inflated.tension_max, 1) + " N/m at most" +
             (inflated.tension_tile.empty() ? "" : " (" + shortened(inflated.tension_tile) + ")")},
        {"wrinkled, slack",
         shown(inflated.wrinkled / percent, 1) + " %, " + shown(inflated.slack / percent, 1) + " %"}};
    if (inflated.load_tape_max > 0) rows.push_back({"load tapes", shown(inflated.load_tape_max, 0) + " N at most"});
    if (inflated.causes)
        rows.push_back({"causes", "shape " + mm(inflated.causes->shape) + " mm, stretch " +
                                      mm(inflated.causes->stretch) + " mm, patterns " + mm(inflated.causes->patterns) +
                                      " mm (rms)"});
    return block(rows);
}

std::string safety(const std::vector<SafetyFactor>& factors) {
    if (factors.empty()) return {};
    std::vector<TextRow> rows{{"strength", "load", "breaks at", "usable", "factor", "required", ""}};
    for (const SafetyFactor& each : factors) {
        const std::string unit = each.part == "cloth" ? " N/m" : " N";
        rows.push_back({each.part, shown(each.load, 1) + unit, shown(each.strength, 0) + unit,
                        shown(each.knock_down / percent, 0) + " %", shown(each.factor, 2), shown(each.required, 2),
                        (each.ok() ? "ok, " : "too weak, ") + each.where});
    }
    return block(rows);
}

std::vector<std::string> off_cells(const Deviation& off, double height, double volume) {
    return {mm(off.rms), mm(off.max, true), mm(off.moved_rms), mm(off.moved_max), mm(height), shown(volume, 2)};
}

TextRow off_row(const std::string& what, const Deviation& off, double height, double volume, const std::string& note) {
    TextRow row{what};
    for (const std::string& cell : off_cells(off, height, volume)) row.push_back(cell);
    row.push_back(note);
    return row;
}

TextRow off_headings(const char* what) {
    return {what, "off rms mm", "most", "moved rms mm", "most", "height mm", "volume m3", ""};
}

std::string rounds(const std::vector<CompensationRound>& all) {
    if (all.empty()) return {};
    std::vector<TextRow> rows{off_headings("round")};
    for (std::size_t i = 0; i < all.size(); ++i)
        rows.push_back(off_row(std::to_string(i + 1) + " " + all[i].step, all[i].off, all[i].height, all[i].volume,
                               all[i].is_best ? "taken" : ""));
    return block(rows);
}

std::string sensitivity(const std::vector<Sensitivity>& all) {
    if (all.empty()) return {};
    std::vector<TextRow> rows{off_headings("if it had")};
    for (const Sensitivity& each : all) rows.push_back(off_row(each.what, each.off, each.height, each.volume, ""));
    return block(rows);
}

}  // namespace

std::string inflated_text(const CutPlan& plan) {
    const Inflated& inflated = *plan.inflated;
    std::string text;
    for (const std::string& sentence : inflated_says(plan)) text += sentence + "\n";
    if (!inflated.summary.usable()) return text;
    return text + sizes(inflated) + loads(inflated) + safety(inflated.safety) + rounds(plan.rounds) +
           sensitivity(inflated.sensitivity);
}

}  // namespace ripstop
