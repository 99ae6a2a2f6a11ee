#include "ripstop/pattern/piece/count_patterns.h"

#include <map>

namespace ripstop {

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

}  // namespace ripstop
