#include "ripstop/pattern/drawing/drawing_layers.h"

#include <algorithm>
#include <map>

#include "ripstop/base/index.h"

namespace ripstop {
namespace {

std::string upper_case(std::string text) {
    for (char& c : text)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return text;
}

bool is_number(const std::string& layer) {
    return !layer.empty() && layer.find_first_not_of("0123456789") == std::string::npos;
}

}  // namespace

LayerConvention convention_of(const PatternDrawing& drawing) {
    bool has_cut = false, has_boundary = false;
    for (const DrawnPath& path : drawing.paths) {
        has_cut = has_cut || upper_case(path.layer) == "CUT";
        has_boundary = has_boundary || (path.layer == "1" && path.group >= 0);
    }
    if (has_cut) return LayerConvention::named;
    return has_boundary ? LayerConvention::numbered : LayerConvention::unknown;
}

std::string convention_text(LayerConvention convention) {
    switch (convention) {
        case LayerConvention::named:
            return "named layers (CUT, SEW, …)";
        case LayerConvention::numbered:
            return "numbered layers (AAMA, ASTM)";
        case LayerConvention::unknown:
            break;
    }
    return "none known: every closed line counts as a contour";
}

LayerUse use_of(LayerConvention convention, const std::string& layer) {
    static const std::map<std::string, LayerUse> named{
        {"CUT", LayerUse::cut},   {"SEW", LayerUse::sew},       {"GRAIN", LayerUse::grain},
        {"TEXT", LayerUse::text}, {"REF", LayerUse::reference}, {"REFERENCE", LayerUse::reference}};
    static const std::map<std::string, LayerUse> numbered{{"1", LayerUse::cut},   {"11", LayerUse::cut},
                                                          {"14", LayerUse::sew},  {"7", LayerUse::grain},
                                                          {"15", LayerUse::text}, {"5", LayerUse::data}};
    if (convention == LayerConvention::unknown)
        return upper_case(layer) == "REF" || upper_case(layer) == "REFERENCE" ? LayerUse::reference : LayerUse::other;
    const auto& table = convention == LayerConvention::named ? named : numbered;
    const auto found = table.find(convention == LayerConvention::named ? upper_case(layer) : layer);
    if (found != table.end()) return found->second;
    return convention == LayerConvention::numbered && is_number(layer) && layer.size() == 2 && layer[0] == '8'
               ? LayerUse::data  // layers 84 to 87 repeat contours more finely
               : LayerUse::other;
}

double line_length(const JoinedLine& line) {
    double length = 0;
    for (Eigen::Index i = 1; i < line.points.rows(); ++i)
        length += (line.points.row(i) - line.points.row(i - 1)).norm();
    if (line.is_closed && line.points.rows() > 1)
        length += (line.points.row(0) - line.points.row(line.points.rows() - 1)).norm();
    return length;
}

std::vector<LayerLines> join_layers(const std::vector<const DrawnPath*>& paths, double metres_per_unit,
                                    double tolerance) {
    std::vector<LayerLines> all;
    std::map<std::pair<int, std::string>, std::size_t> places;
    for (const DrawnPath* path : paths) {
        const auto [place, is_new] = places.try_emplace({path->group, path->layer}, all.size());
        if (is_new) all.push_back({path->layer, path->group, {}, {}});
        all[place->second].paths.push_back(path);
    }
    for (LayerLines& layer : all) {
        std::vector<Points2> open;
        std::vector<int> numbers;
        for (std::size_t i = 0; i < layer.paths.size(); ++i) {
            const Points2 points = layer.paths[i]->points * metres_per_unit;
            if (layer.paths[i]->is_closed) {
                layer.lines.push_back({points, {static_cast<int>(i)}, true});
            } else {
                open.push_back(points);
                numbers.push_back(static_cast<int>(i));
            }
        }
        for (JoinedLine& line : join_lines(open, tolerance)) {
            for (int& number : line.lines) number = numbers[at(number)];
            layer.lines.push_back(std::move(line));
        }
    }
    return all;
}

}  // namespace ripstop
