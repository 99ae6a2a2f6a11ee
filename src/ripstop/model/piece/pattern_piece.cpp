#include "ripstop/model/piece/pattern_piece.h"

#include <algorithm>

namespace ripstop {

Points2 PatternPiece::edge_line(std::size_t edge) const {
    const Eigen::Index count = sew_line.rows();
    const Eigen::Index first = edges[edge].first;
    const Eigen::Index next = edges[(edge + 1) % edges.size()].first;
    const Eigen::Index steps = next > first ? next - first : next - first + count;
    Points2 line(steps + 1, 2);
    for (Eigen::Index i = 0; i <= steps; ++i) line.row(i) = sew_line.row((first + i) % count);
    return line;
}

const Fabric& PieceSet::fabric(const std::string& name) const {
    const auto found =
        std::find_if(fabrics.begin(), fabrics.end(), [&name](const Fabric& fabric) { return fabric.name == name; });
    return found != fabrics.end() ? *found : fabrics.front();
}

}  // namespace ripstop
