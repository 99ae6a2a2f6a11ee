#pragma once

#include <map>
#include <string>
#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop::testing {

/// The drawing of a plotter for an HPGL file: an interpreter of IN, PS, SP, PU, PD and FR that refuses everything
/// else.
struct Plot {
    std::map<int, std::vector<Points2>>
        strokes;            ///< by pen, in plotter units (0.025 mm); the pen stays down along each
    std::vector<int> pens;  ///< in the order of use
    int frames = 1;
    long largest = 0;          ///< largest absolute coordinate
    std::size_t longest = 0;   ///< largest number of points of a command
    Vec2 size = Vec2::Zero();  ///< from PS
    bool is_ended = false;     ///< the pen is up and put away at the end
    std::string fault;         ///< the first thing it could not read

    double length(int pen) const;  ///< of everything that a pen draws [m]
};

/// `frame`: how far FR advances, in plotter units; it places strokes on the whole sheet.
Plot plot_of(const std::string& hpgl, double frame = 0);

}  // namespace ripstop::testing
