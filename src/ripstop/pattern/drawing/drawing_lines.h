#pragma once

#include <vector>

#include "ripstop/model/piece/drawing_check.h"
#include "ripstop/pattern/drawing/drawing_layers.h"

namespace ripstop {

/// State that the parts of a check share: the drawing, its unit, and the findings.
struct DrawingSurvey {
    const PatternDrawing& drawing;
    LayerConvention convention;
    double metres_per_unit;
    DrawingCheck& check;
};

/// Reports lines without length and duplicate lines in `survey.check`; returns all others.
std::vector<const DrawnPath*> sound_lines(DrawingSurvey& survey);

/// A contour with its points, layer and group.
struct FoundContour {
    DrawingContour facts;
    int group = -1;
    LayerUse use = LayerUse::other;
    Points2 points;
};

/// Finds the contours of the drawing. Reports contours that are open (by how much and where), that cross
/// themselves, and that are not planar. If no layers are known, an open line around cloth outside of every contour
/// is an open outline; other open lines are counted and noted.
std::vector<FoundContour> find_contours(DrawingSurvey& survey, const std::vector<LayerLines>& layers);

/// `(12.3, 4) mm`.
std::string place_text(const Vec2& metres);

/// A piece's name: the text `Piece Name:` of its block, else the largest text inside, the group's name, or its
/// place.
std::string piece_name(const DrawingSurvey& survey, int group, const Points2& contour);

}  // namespace ripstop
