/// Prints what the library reads from SVG files, in millimetres with y down, for a comparison with a browser:
/// print_paths FILE... For a file that it refuses, it prints the reason.
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "ripstop/base/error.h"
#include "ripstop/base/text/units.h"
#include "ripstop/io/svg/svg_read.h"

namespace {

using Json = nlohmann::ordered_json;

Json read(const std::string& file) try {
    std::ifstream in(file, std::ios::binary);
    const ripstop::PatternDrawing drawing = ripstop::read_svg(in, file);
    const double mm = drawing.units.empty() ? 1 : drawing.units.front().unit.metres / ripstop::millimetre;
    Json paths = Json::array(), unread = Json::array(), texts = Json::array();
    for (const ripstop::DrawnPath& path : drawing.paths) {
        Json points = Json::array();
        for (Eigen::Index k = 0; k < path.points.rows(); ++k)
            points.push_back({path.points(k, 0) * mm, -path.points(k, 1) * mm});
        paths.push_back({{"entity", path.entity}, {"line", path.line}, {"closed", path.is_closed}, {"points", points}});
    }
    for (const ripstop::DrawnText& text : drawing.texts)
        texts.push_back({{"text", text.text},
                         {"at", {text.at.x() * mm, -text.at.y() * mm}},
                         {"height", text.height * mm},
                         {"turn", -text.turn}});
    for (const ripstop::UnreadEntity& entity : drawing.unread)
        unread.push_back({{"kind", entity.kind}, {"reason", entity.reason}, {"carried", entity.is_carried}});
    return {{"mm_per_unit", mm}, {"paths", paths}, {"texts", texts}, {"unread", unread}};
} catch (const ripstop::InputError& error) {
    return {{"error", error.what()}};
}

}  // namespace

int main(int count, char** arguments) {
    Json files = Json::array();
    for (int i = 1; i < count; ++i) files.push_back(read(arguments[i]));
    std::cout << files << '\n';
}
