#pragma once

#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>
#include <string_view>

#include "require.h"
#include "ripstop/base/error.h"
#include "ripstop/pattern/drawing/check_drawing.h"
#include "ripstop/report/words/drawing_report.h"

namespace ripstop::fuzzing {

inline bool is_place(const Vec2& at) {
    return at.allFinite() && at.cwiseAbs().maxCoeff() <= 1e9;
}

inline void require_sound(const PatternDrawing& drawing) {
    const int groups = static_cast<int>(drawing.groups.size());
    for (const DrawnPath& path : drawing.paths) {
        require(path.points.rows() > 0 && path.group >= -1 && path.group < groups);
        for (Eigen::Index i = 0; i < path.points.rows(); ++i) require(is_place(path.points.row(i)));
    }
    for (const DrawnPoint& point : drawing.points) require(is_place(point.at) && point.group < groups);
    for (const DrawnText& text : drawing.texts) require(is_place(text.at) && text.group < groups);
    for (const StatedUnit& stated : drawing.units) require(stated.unit.metres > 0);
}

/// Any bytes give a drawing with finite places or an InputError that names the file. Every drawing can be checked
/// and reported.
inline int check_pattern_reader(PatternDrawing (*read)(std::istream&, const std::string&), const std::uint8_t* data,
                                std::size_t size) {
    std::istringstream in(std::string(reinterpret_cast<const char*>(data), size));
    PatternDrawing drawing;
    try {
        drawing = read(in, "fuzz");
    } catch (const InputError& error) {
        require(std::string_view(error.what()).starts_with("fuzz:"));
        return 0;
    }
    require_sound(drawing);
    const DrawingCheck check = check_drawing(drawing, {{}, 1.5});
    require(!drawing_text(check, "fuzz").empty() && !drawing_json(check, "fuzz").empty());
    return 0;
}

}  // namespace ripstop::fuzzing
