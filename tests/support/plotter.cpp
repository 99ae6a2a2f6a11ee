#include "support/plotter.h"

#include <cmath>
#include <cstdlib>
#include <sstream>

namespace ripstop::testing {
namespace {

std::vector<long> numbers(const std::string& text) {
    std::vector<long> values;
    std::istringstream in(text);
    for (std::string word; std::getline(in, word, ',');) values.push_back(std::stol(word));
    return values;
}

}  // namespace

double Plot::length(int pen) const {
    double sum = 0;
    const auto found = strokes.find(pen);
    if (found == strokes.end()) return 0;
    for (const Points2& stroke : found->second)
        for (Eigen::Index i = 0; i + 1 < stroke.rows(); ++i) sum += (stroke.row(i + 1) - stroke.row(i)).norm();
    return sum * 0.025e-3;
}

Plot plot_of(const std::string& hpgl, double frame) {
    Plot plot;
    int pen = 0;
    Vec2 at(0, 0);
    bool is_down = false;
    std::vector<Vec2> stroke;
    const auto lift = [&] {
        if (stroke.size() > 1) {
            Points2 rows(static_cast<Eigen::Index>(stroke.size()), 2);
            for (std::size_t i = 0; i < stroke.size(); ++i)
                rows.row(static_cast<Eigen::Index>(i)) = stroke[i].transpose();
            plot.strokes[pen].push_back(rows);
        }
        stroke.clear();
        is_down = false;
    };
    std::istringstream in(hpgl);
    for (std::string command; std::getline(in, command, ';');) {
        const std::size_t start = command.find_first_not_of("\n");
        if (start == std::string::npos) continue;
        const std::string name = command.substr(start, 2);
        const std::vector<long> values = numbers(command.substr(start + 2));
        plot.is_ended = name == "SP" && values == std::vector<long>{0} && !is_down;
        if (name == "IN") continue;
        if (name == "PS") {
            plot.size = {static_cast<double>(values.at(0)), static_cast<double>(values.at(1))};
        } else if (name == "SP") {
            if (is_down) plot.fault = "pen changed while down";
            pen = static_cast<int>(values.at(0));
            plot.pens.push_back(pen);
        } else if (name == "FR") {
            if (is_down) plot.fault = "paper moved with the pen down";
            ++plot.frames;
        } else if (name == "PU" || name == "PD") {
            if (name == "PU") lift();
            plot.longest = std::max(plot.longest, values.size() / 2);
            for (std::size_t i = 0; i + 1 < values.size(); i += 2) {
                if (name == "PD" && stroke.empty()) stroke.push_back(at);
                for (const long value : {values[i], values[i + 1]})
                    plot.largest = std::max(plot.largest, std::labs(value));
                at = {static_cast<double>(values[i]) + frame * (plot.frames - 1), static_cast<double>(values[i + 1])};
                if (name == "PD") stroke.push_back(at);
            }
            is_down = name == "PD";
        } else {
            plot.fault = "command " + name;
        }
    }
    return plot;
}

}  // namespace ripstop::testing
