#include "ripstop/geometry/polygon.h"
#include "ripstop/pattern/drawing/drawing_lines.h"

namespace ripstop {
namespace {

/// The text after `PIECE NAME:`, in any case.
std::string named_by(const std::string& text) {
    constexpr std::string_view key = "PIECE NAME:";
    if (text.size() <= key.size()) return "";
    for (std::size_t i = 0; i < key.size(); ++i) {
        const char c = text[i] >= 'a' && text[i] <= 'z' ? static_cast<char>(text[i] - 'a' + 'A') : text[i];
        if (c != key[i]) return "";
    }
    const std::size_t start = text.find_first_not_of(' ', key.size());
    return start == std::string::npos ? "" : text.substr(start);
}

}  // namespace

std::string piece_name(const DrawingSurvey& survey, int group, const Points2& contour) {
    if (group >= 0) {
        for (const DrawnText& text : survey.drawing.texts)
            if (text.group == group)
                if (const std::string name = named_by(text.text); !name.empty()) return name;
        const std::string& name = survey.drawing.groups[static_cast<std::size_t>(group)].name;
        if (!name.empty()) return name;
    }
    const DrawnText* largest = nullptr;
    const Vec2 lower = contour.colwise().minCoeff(), upper = contour.colwise().maxCoeff();
    for (const DrawnText& text : survey.drawing.texts) {
        const Vec2 at = text.at * survey.metres_per_unit;
        const bool is_near = (at.array() >= lower.array()).all() && (at.array() <= upper.array()).all();
        if (is_near && !text.text.empty() && (!largest || text.height > largest->height) && contains(contour, at))
            largest = &text;
    }
    return largest ? largest->text : "the contour at " + place_text(lower);
}

}  // namespace ripstop
