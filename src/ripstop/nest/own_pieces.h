#pragma once

#include <map>
#include <utility>
#include <vector>

#include "ripstop/model/piece/marker.h"
#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// The pieces that each pattern cuts (`PatternPiece::pattern`). Each is laid in the place of one of its pattern's
/// copies, so that it carries its own name, neighbours and notches. They have the same outline, so nothing moves.
/// A mirror image of the pattern is drawn as it is. If the set lacks some pieces of a pattern, the pattern is left
/// out and its copies keep its drawing. O(#pieces x #outline²).
class OwnPieces {
  public:
    explicit OwnPieces(const PieceSet& set);

    /// How many of the pieces that a pattern cuts, as they are or mirrored, cover it only after half a turn.
    int half_turned(std::size_t pattern, bool mirrored) const;

    /// Lays the pieces along the roll in the order of the set. If pieces may not be turned (`may_turn`), the
    /// copies of the pattern that lie turned are those that `half_turned` counts, and their pieces end up
    /// unturned.
    void lay(bool may_turn, Marker& marker) const;

  private:
    struct Own {
        std::size_t piece;
        bool half_turned;
    };
    /// Removes the next piece for a copy from the list and returns it; the list is in reverse order.
    static Own take(std::vector<Own>& waiting, bool may_turn, double turn);
    Placement covering(const Placement& copy, const Own& own) const;

    const PieceSet& set_;
    /// by pattern and whether they are mirrored; in reverse order
    std::map<std::pair<std::size_t, bool>, std::vector<Own>> own_;
};

}  // namespace ripstop
