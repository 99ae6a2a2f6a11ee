#pragma once

#include <map>
#include <utility>
#include <vector>

#include "ripstop/model/piece/marker.h"
#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// The pieces that patterns cut (`PatternPiece::pattern`), to be laid in the place of their patterns' copies: each then
/// carries its own name, neighbours and notches. They have the same outline, so nothing moves; a piece that is the
/// pattern's mirror image is drawn as it is. A pattern whose pieces the set has not all is left out: its copies keep
/// its drawing. O(#pieces x #outline^2).
class OwnPieces {
  public:
    explicit OwnPieces(const PieceSet& set);

    /// How many of a pattern's pieces, or of those it cuts turned over, cover it only after half a turn.
    int half_turned(std::size_t pattern, bool mirrored) const;

    /// Lays them in the order of the set along the roll. Where no piece `may_turn`, the pattern's copies that lie
    /// turned by half are those `half_turned` counts, and their pieces come to lie unturned.
    void lay(bool may_turn, Marker& marker) const;

  private:
    struct Own {
        std::size_t piece;
        bool half_turned;
    };
    /// The next that a copy stands for; it is taken from the list, the last of which comes first.
    static Own take(std::vector<Own>& waiting, bool may_turn, double turn);
    Placement covering(const Placement& copy, const Own& own) const;

    const PieceSet& set_;
    /// By pattern, and are they mirrored; the last first.
    std::map<std::pair<std::size_t, bool>, std::vector<Own>> own_;
};

}  // namespace ripstop
