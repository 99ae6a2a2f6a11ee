#include "ripstop/report/words/check_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"
#include "ripstop/report/figures/figures.h"

namespace ripstop {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t shown_loops = 8;
constexpr int most_lines = 10;  // per code; if there are more, the first line says which they are

std::string plural(int count, const char* one, const char* many) {
    return fmt::format("{} {}", count, count == 1 ? one : many);
}

constexpr const char* not_sought = "not searched for";  // beside figures that depend on the seams

std::string count_text(const EnvelopeCheck& check, int count) {
    return check.seams_sought ? std::to_string(count) : not_sought;
}

std::string seams_text(const EnvelopeCheck& check) {
    if (!check.seams_sought)
        return fmt::format("{}: the tiles are too small for the tolerance of {:.3g} mm", not_sought,
                           check.seam_tolerance / millimetre);
    const std::string further = check.sewn_in == 0 ? ""
                                                   : fmt::format(", {} an additional sheet into another seam",
                                                                 plural(check.sewn_in, "of them sews", "of them sew"));
    return fmt::format("{}, {:.2f} m, edges up to {:.3f} mm apart (tolerance {:.3g} mm); {} within a tile, {}{}",
                       check.seams, check.seam_length, check.gap_max / millimetre, check.seam_tolerance / millimetre,
                       check.self_seams, plural(check.t_junctions, "T-junction", "T-junctions"), further);
}

std::string loops_text(const EnvelopeCheck& check) {
    if (!check.seams_sought) return not_sought;
    if (check.loops.empty()) return "none: the envelope is closed";
    std::string text;
    for (std::size_t i = 0; i < std::min(check.loops.size(), shown_loops); ++i) {
        const LooseLoop& loop = check.loops[i];
        text +=
            fmt::format("{}{:.2f} m round ({}, {}, {}) m, {}, {}{}", i ? "\n               " : "", loop.length,
                        format_fixed(loop.centre.x(), 2), format_fixed(loop.centre.y(), 2),
                        format_fixed(loop.centre.z(), 2), plural(static_cast<int>(loop.tiles.size()), "tile", "tiles"),
                        loop.corners == 0 ? "no corner" : plural(loop.corners, "corner", "corners"),
                        loop.closed ? "" : ", not closed");
    }
    if (check.loops.size() > shown_loops)
        text += fmt::format("\n               and {} more", check.loops.size() - shown_loops);
    return text;
}

/// One line per issue. If many have the same code, the first and their number; the JSON has all.
std::string issues_text(const EnvelopeCheck& check) {
    std::map<std::string, int> counts;
    for (const EnvelopeIssue& issue : check.issues) ++counts[issue.code];
    std::string text;
    for (const EnvelopeIssue& issue : check.issues) {
        int& count = counts[issue.code];
        if (count == 0) continue;
        text += fmt::format("WRONG          {}", issue.message);
        if (count > most_lines) {
            text += fmt::format("; and {} more like this", count - 1);
            count = 0;
        }
        text += "\n";
    }
    return text;
}

std::string sampling_text(const EnvelopeCheck& check) {
    if (!check.seams_sought) return not_sought;
    if (check.sampling.empty()) return "no seams";
    const SeamSampling& worst =
        *std::max_element(check.sampling.begin(), check.sampling.end(),
                          [](const SeamSampling& p, const SeamSampling& q) { return p.chord_error < q.chord_error; });
    std::vector<double> errors;
    for (const SeamSampling& seam : check.sampling) errors.push_back(seam.chord_error);
    std::nth_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2), errors.end());
    return fmt::format("median {:.3f} mm/m, largest {:.3f} mm/m ({}: an edge turns by {:.1f} degrees)",
                       errors[errors.size() / 2] / millimetre, worst.chord_error / millimetre, worst.id,
                       worst.turn / degree);
}

std::string fabrics_text(const EnvelopeCheck& check) {
    std::string text;
    for (const FabricUse& use : check.fabrics)
        text += fmt::format("{}{} {}", text.empty() ? "fabric         " : ", ", use.name, use.tiles);
    return text.empty() ? text : text + "\n";
}

std::string seam_types_text(const EnvelopeCheck& check) {
    std::string text;
    for (const SeamTypeUse& use : check.seam_types)
        text += fmt::format("{}{} {} ({:.4g} mm)", text.empty() ? "sewn           " : ", ", use.type.name,
                            use.seams + use.free_edges, use.type.allowance / millimetre);
    return text.empty() ? text : text + "\n";
}

Json seam_types_json(const EnvelopeCheck& check) {
    Json list = Json::array();
    for (const SeamTypeUse& use : check.seam_types)
        list.push_back({{"type", use.type.name},
                        {"allowance_mm", clean(use.type.allowance / millimetre)},
                        {"seams", use.seams},
                        {"free_edges", use.free_edges},
                        {"length_mm", clean(use.length / millimetre)}});
    return list;
}

Json point(const Vec3& p) {
    return Json::array({clean(p.x()), clean(p.y()), clean(p.z())});
}
Json point_mm(const Vec3& p) {
    return point(p / millimetre);
}

}  // namespace

std::string check_text(const EnvelopeCheck& check, const std::string& file, const std::string& unit) {
    std::string text = fmt::format(
        "{}, in {}\n"
        "size           {:.4g} x {:.4g} x {:.4g} m, {:.4g} m2 of cloth\n"
        "tiles          {}, {} triangles, {} chains, {} corners{}\n"
        "warp           {}\n"
        "seams          {}\n",
        file, unit, check.size.x(), check.size.y(), check.size.z(), check.area, check.tiles, check.triangles,
        check.chains, check.corners, check.seams_sought ? ", in " + plural(check.parts, "part", "parts") : "",
        fmt::format("{}", fmt::join(check.grain_sources, ", ")), seams_text(check));
    text += seam_types_text(check) + fabrics_text(check) + fmt::format("open edges     {}\n", loops_text(check));
    text +=
        fmt::format("loose ends     {}\nodd corners    {}\nchord error    {}\n", count_text(check, check.loose_ends),
                    count_text(check, check.odd_corners), sampling_text(check));
    for (const std::string& note : check.notes) text += fmt::format("note           {}\n", note);
    text += issues_text(check);
    text += check.sound() ? "Sound: nothing is wrong with this envelope.\n"
                          : fmt::format("{} wrong with this envelope.\n",
                                        check.issues.size() == 1 ? "One thing is"
                                                                 : fmt::format("{} things are", check.issues.size()));
    return text;
}

std::string check_json(const EnvelopeCheck& check, const std::string& file, const std::string& unit) {
    Json json;
    json["input"] = {{"file", file}, {"unit", unit}};
    json["sound"] = check.sound();
    json["size_m"] = point(check.size);
    json["area_m2"] = clean(check.area);
    json["tiles"] = check.tiles;
    json["triangles"] = check.triangles;
    json["chains"] = check.chains;
    json["corners"] = check.corners;
    json["odd_corners"] = check.odd_corners;
    json["parts"] = check.parts;
    json["grain"] = check.grain_sources;
    json["seam_tolerance_mm"] = clean(check.seam_tolerance / millimetre);
    json["seam_length_mm"] = clean(check.seam_length / millimetre);
    json["seam_gap_max_mm"] = clean(check.gap_max / millimetre);
    json["seam_types"] = seam_types_json(check);
    json["fabrics"] = Json::array();
    for (const FabricUse& use : check.fabrics) json["fabrics"].push_back({{"name", use.name}, {"tiles", use.tiles}});
    json["self_seams"] = check.self_seams;
    json["t_junctions"] = check.t_junctions;
    json["further_sheets"] = check.sewn_in;
    json["loose_ends"] = check.loose_ends;
    json["seams"] = Json::array();
    for (const SeamSampling& seam : check.sampling)
        json["seams"].push_back({{"id", seam.id},
                                 {"length_mm", clean(seam.length / millimetre)},
                                 {"turn_deg", clean(seam.turn / degree)},
                                 {"chord_error_mm_per_m", clean(seam.chord_error / millimetre)}});
    json["zigzags"] = Json::array();
    for (const Zigzag& zigzag : check.zigzags)
        json["zigzags"].push_back({{"tile", zigzag.tile_name},
                                   {"mate", zigzag.mate.empty() ? Json() : Json(zigzag.mate)},
                                   {"seams", zigzag.seams},
                                   {"teeth_mm", clean(zigzag.teeth / millimetre)},
                                   {"length_mm", clean(zigzag.length / millimetre)},
                                   {"fair_length_mm", clean(zigzag.fair_length / millimetre)}});
    json["loops"] = Json::array();
    for (const LooseLoop& loop : check.loops)
        json["loops"].push_back({{"tiles", loop.tiles.size()},
                                 {"length_mm", clean(loop.length / millimetre)},
                                 {"corners", loop.corners},
                                 {"closed", loop.closed},
                                 {"outline", loop.outline},
                                 {"centre_mm", point_mm(loop.centre)}});
    json["issues"] = Json::array();
    for (const EnvelopeIssue& issue : check.issues) {
        Json entry = {
            {"code", issue.code}, {"message", issue.message}, {"tiles", issue.tiles}, {"at_mm", point_mm(issue.at)}};
        if (issue.code == "shifted" || issue.code == "gap")
            entry["distance_mm"] = clean(issue.value / millimetre);
        else if (issue.code == "uncertain")
            entry["open_mm"] = clean(issue.value / millimetre);
        else if (issue.code == "scaled")
            entry["ratio"] = clean(issue.value);
        json["issues"].push_back(std::move(entry));
    }
    json["notes"] = check.notes;
    if (!check.seams_sought)
        for (const char* key : {"odd_corners", "parts", "seam_length_mm", "seam_gap_max_mm", "seam_types", "self_seams",
                                "further_sheets", "t_junctions", "loose_ends", "seams", "loops"})
            json[key] = nullptr;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace ripstop
