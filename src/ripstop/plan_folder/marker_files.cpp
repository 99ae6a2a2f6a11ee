#include "ripstop/plan_folder/marker_files.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "ripstop/base/text/units.h"
#include "ripstop/io/piece_format.h"
#include "ripstop/io/print/marker_pdf.h"
#include "ripstop/io/text/output_file.h"
#include "ripstop/nest/laid_piece.h"
#include "ripstop/report/figures/figures.h"
#include "ripstop/report/figures/json_figures.h"
#include "ripstop/report/figures/text_table.h"
#include "ripstop/report/tables/order.h"

namespace ripstop {
namespace {

using Json = nlohmann::ordered_json;

Points2 rectangle(double start, double length, double height) {
    Points2 corners(5, 2);
    corners << start, 0, start + length, 0, start + length, height, start, height, start, 0;
    return corners;
}

Json placement_json(const PieceSet& set, const Placement& placement) {
    return {{"piece", set.pieces[placement.piece].name},
            {"copy", placement.copy},
            {"mirrored", placement.mirrored},
            {"face_down", placement.face_down},
            {"turn_deg", clean(placement.turn / degree)},
            {"x_mm", in_millimetres(placement.shift.x())},
            {"y_mm", in_millimetres(placement.shift.y())}};
}

Json json_of(const PieceSet& set, const Marker& marker, const std::string& stem,
             const std::vector<std::string>& formats) {
    Json files = Json::array(), parts = Json::array(), placements = Json::array();
    for (const std::string& format : formats) files.push_back(stem + "." + piece_format_named(format).extension);
    for (const RollPart& part : marker.parts)
        parts.push_back({{"start_mm", in_millimetres(part.start)},
                         {"length_mm", in_millimetres(part.length)},
                         {"used_mm", in_millimetres(part.used)}});
    for (const Placement& placement : marker.placements) placements.push_back(placement_json(set, placement));
    return {{"fabric", marker.fabric},
            {"colour", marker.colour},
            {"files", files},
            {"roll_width_mm", in_millimetres(marker.roll_width)},
            {"length_mm", in_millimetres(marker.length)},
            {"net_m2", clean(marker.net_area)},
            {"gross_m2", clean(marker.gross_area())},
            {"utilisation_pct", clean(marker.utilisation() / percent)},
            {"roll_parts", parts},
            {"placements", placements}};
}

std::string title_of(const PieceSet& set, const Marker& marker) {
    return fmt::format("{}, revision {}: {}{}{}, roll {:.0f} mm, {:.2f} m, {:.1f} %", set.input, set.revision,
                       marker.fabric, marker.colour.empty() ? "" : " ", marker.colour, marker.roll_width / millimetre,
                       marker.length, marker.utilisation() / percent);
}

}  // namespace

std::vector<std::string> marker_stems(const Markers& markers) {
    if (markers.markers.size() == 1) return {"marker"};
    std::vector<std::string> names;
    for (const Marker& marker : markers.markers)
        names.push_back("marker-" + marker.fabric + (marker.colour.empty() ? "" : "-" + marker.colour));
    return file_stems(names);
}

std::vector<PatternPiece> drawn_marker(const PieceSet& set, const Marker& marker) {
    PatternPiece roll{"roll", Points2(0, 2)};
    for (const RollPart& part : marker.parts)
        roll.lines.push_back({"roll", rectangle(part.start, part.length, marker.roll_width)});
    std::vector<PatternPiece> pieces{roll};
    for (const Placement& placement : marker.placements)
        pieces.push_back(laid_piece(set.pieces[placement.piece], placement));
    return pieces;
}

void write_marker_files(const std::filesystem::path& folder, const PieceSet& set, const Markers& markers,
                        const std::vector<std::string>& formats) {
    const std::vector<std::string> stems = marker_stems(markers);
    for (std::size_t i = 0; i < stems.size(); ++i) {
        const std::vector<PatternPiece> pieces = drawn_marker(set, markers.markers[i]);
        for (const std::string& name : formats) {
            const PieceFormat& format = piece_format_named(name);
            PieceFileOptions options;
            options.style = set.input;
            options.revision = set.revision;
            write_file(folder / (stems[i] + "." + format.extension), [&](std::ostream& out) {
                if (name == "pdf")  // one page per piece, as this format writes pieces, would be no marker
                    write_marker_pdf(out, markers.markers[i], {pieces.begin() + 1, pieces.end()},
                                     title_of(set, markers.markers[i]));
                else
                    format.write(out, pieces, {}, options);
            });
        }
    }
    write_file(folder / "marker.json", marker_json(set, markers, formats));
    write_file(folder / "bom.csv", bom_csv(set, &markers));
}

std::string marker_json(const PieceSet& set, const Markers& markers, const std::vector<std::string>& formats) {
    Json list = Json::array(), refused = Json::array();
    const std::vector<std::string> stems = marker_stems(markers);
    for (std::size_t i = 0; i < stems.size(); ++i) list.push_back(json_of(set, markers.markers[i], stems[i], formats));
    for (const Refusal& refusal : markers.refusals)
        refused.push_back({{"piece", refusal.piece}, {"quantity", refusal.quantity}, {"reason", refusal.reason}});
    const Json json = {
        {"schema", "1.0"}, {"input", set.input}, {"revision", set.revision}, {"markers", list}, {"refused", refused}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string marker_table(const Markers& markers) {
    std::vector<TextRow> rows = {
        {"fabric", "colour", "roll mm", "pieces", "running m", "cloth m2", "pieces m2", "used %", "parts", ""}};
    for (const Marker& marker : markers.markers)
        rows.push_back({shortened(marker.fabric), marker.colour.empty() ? "-" : shortened(marker.colour),
                        fmt::format("{:.0f}", marker.roll_width / millimetre), std::to_string(marker.placements.size()),
                        fmt::format("{:.2f}", marker.length), fmt::format("{:.2f}", marker.gross_area()),
                        fmt::format("{:.2f}", marker.net_area), fmt::format("{:.1f}", marker.utilisation() / percent),
                        std::to_string(marker.parts.size()), ""});
    std::string text = markers.markers.empty() ? "" : aligned_table(rows, 2);
    std::size_t laid = 0, refused = 0;
    for (const Marker& marker : markers.markers) laid += marker.placements.size();
    for (const Refusal& refusal : markers.refusals) {
        text += fmt::format("not laid: {} x {} {}\n", refusal.quantity, refusal.piece, refusal.reason);
        refused += static_cast<std::size_t>(refusal.quantity);
    }
    if (refused > 0) text += fmt::format("not laid in total: {} of {} pieces\n", refused, laid + refused);
    return text;
}

}  // namespace ripstop
