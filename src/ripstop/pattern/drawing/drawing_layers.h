#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ripstop/geometry/join_lines.h"
#include "ripstop/model/piece/drawing_check.h"
#include "ripstop/model/piece/pattern_drawing.h"

namespace ripstop {

/// What the layers of a drawing mean.
enum class LayerConvention { named, numbered, unknown };
LayerConvention convention_of(const PatternDrawing& drawing);
std::string convention_text(LayerConvention convention);

/// What the lines of a layer are for.
enum class LayerUse { cut, sew, grain, text, reference, data, other };
LayerUse use_of(LayerConvention convention, const std::string& layer);

/// The lines of one layer and one group, joined, in metres.
struct LayerLines {
    std::string layer;
    int group = -1;
    std::vector<const DrawnPath*> paths;  ///< what `JoinedLine::lines` counts
    std::vector<JoinedLine> lines;
};

/// The lines by layer and group, in the order of the drawing.
std::vector<LayerLines> join_layers(const std::vector<const DrawnPath*>& paths, double metres_per_unit,
                                    double tolerance);

/// Length of an open or a closed line.
double line_length(const JoinedLine& line);

}  // namespace ripstop
