#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ripstop/geometry/join_lines.h"
#include "ripstop/model/piece/drawing_check.h"
#include "ripstop/model/piece/pattern_drawing.h"

namespace ripstop {

/// The convention for the names of a drawing's layers.
enum class LayerConvention { named, numbered, unknown };
LayerConvention convention_of(const PatternDrawing& drawing);
std::string convention_text(LayerConvention convention);

/// The purpose of a layer's lines.
enum class LayerUse { cut, sew, grain, text, reference, data, other };
LayerUse use_of(LayerConvention convention, const std::string& layer);

/// The joined lines of one layer and one group, in metres.
struct LayerLines {
    std::string layer;
    int group = -1;
    std::vector<const DrawnPath*> paths;  ///< `JoinedLine::lines` indexes them
    std::vector<JoinedLine> lines;
};

/// Joins the lines of each layer and group, in the order of the drawing.
std::vector<LayerLines> join_layers(const std::vector<const DrawnPath*>& paths, double metres_per_unit,
                                    double tolerance);

/// The length of an open or closed line.
double line_length(const JoinedLine& line);

}  // namespace ripstop
