#pragma once

#include <vector>

#include "ripstop/model/piece/drawing_check.h"
#include "ripstop/pattern/drawing/drawing_layers.h"

namespace ripstop {

/// What the parts of a check share: what is looked at, in which unit, and where findings go.
struct DrawingSurvey {
    const PatternDrawing& drawing;
    LayerConvention convention;
    double metres_per_unit;
    DrawingCheck& check;
};

/// Names lines without length and lines drawn twice in `survey.check`, and gives all the others.
std::vector<const DrawnPath*> sound_lines(DrawingSurvey& survey);

/// A contour with its points, and where it belongs.
struct FoundContour {
    DrawingContour facts;
    int group = -1;
    LayerUse use = LayerUse::other;
    Points2 points;
};

/// The contours of the drawing. Names those that are open, by how much and where, those that cross themselves and those
/// that do not lie in a plane. Where no layers are known, an open line that goes round cloth outside of every contour
/// is an outline left open; other open lines are counted and noted.
std::vector<FoundContour> find_contours(DrawingSurvey& survey, const std::vector<LayerLines>& layers);

/// `(12.3, 4) mm`.
std::string place_text(const Vec2& metres);

/// Of the piece: the text `Piece Name:` of its block, the largest text inside, the group's name, or where it is.
std::string piece_name(const DrawingSurvey& survey, int group, const Points2& contour);

}  // namespace ripstop
