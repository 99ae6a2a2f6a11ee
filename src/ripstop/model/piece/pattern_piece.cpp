#include "ripstop/model/piece/pattern_piece.h"

#include <map>

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

std::string cut_count(const PatternPiece& piece) {
    if (piece.quantity <= 1 && piece.quantity_mirrored == 0) return "";
    const std::string same = "cut " + std::to_string(piece.quantity);
    return piece.quantity_mirrored == 0 ? same : same + " + " + std::to_string(piece.quantity_mirrored) + " mirrored";
}

void count_patterns(std::vector<PatternPiece>& pieces) {
    struct Pattern {
        PatternPiece* piece;
        bool was_mirrored;
    };
    std::map<std::string, Pattern> patterns;  // by the name of the piece that serves as the pattern
    for (PatternPiece& piece : pieces) {
        const auto [found, is_first] =
            patterns.try_emplace(piece.pattern.empty() ? piece.name : piece.pattern, Pattern{&piece, piece.mirrored});
        PatternPiece& pattern = *found->second.piece;
        piece.mirrored = piece.mirrored != found->second.was_mirrored;
        piece.pattern = is_first ? "" : pattern.name;
        piece.quantity = piece.quantity_mirrored = 0;
        ++(piece.mirrored ? pattern.quantity_mirrored : pattern.quantity);
    }
    for (PatternPiece& piece : pieces) {
        const std::string count = cut_count(piece);
        if (count.empty()) std::erase_if(piece.labels, [](const Label& label) { return label.counts; });
        for (Label& label : piece.labels)
            if (label.counts) label.text = count;
    }
}

const Fabric& PieceSet::fabric(const std::string& name) const {
    const auto found =
        std::find_if(fabrics.begin(), fabrics.end(), [&name](const Fabric& fabric) { return fabric.name == name; });
    return found != fabrics.end() ? *found : fabrics.front();
}

}  // namespace ripstop
