#pragma once

#include <map>
#include <string>
#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop::testing {

/// What a plotter would draw from an HPGL file: an interpreter of IN, PS, SP, PU, PD and FR that refuses all else.
struct Plot {
    std::map<int, std::vector<Points2>>
        strokes;            ///< by pen, in plotter units (0.025 mm), each with the pen down throughout
    std::vector<int> pens;  ///< in the order they were taken
    int frames = 1;
    long largest = 0;          ///< coordinate, by size
    std::size_t longest = 0;   ///< points of a command
    Vec2 size = Vec2::Zero();  ///< of PS
    bool is_ended = false;     ///< pen up and put away
    std::string fault;         ///< what it could not read

    double length(int pen) const;  ///< of all a pen draws [m]
};

/// `frame`: how far FR advances, in plotter units; strokes are placed on the whole sheet with it.
Plot plot_of(const std::string& hpgl, double frame = 0);

}  // namespace ripstop::testing
