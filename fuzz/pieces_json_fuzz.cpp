#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <sstream>

#include "require.h"
#include "ripstop/base/error.h"
#include "ripstop/io/json/pieces_json.h"
#include "ripstop/io/svg/svg.h"

using namespace ripstop;
using fuzzing::require;

/// Any bytes give pieces that can be written in full and read back unchanged, or an InputError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::istringstream in(std::string(reinterpret_cast<const char*>(data), size));
    PieceSet set;
    try {
        set = read_pieces(in, "fuzz.json");
    } catch (const InputError&) {
        return 0;
    }
    for (const PatternPiece& piece : set.pieces) {
        require(piece.sew_line.allFinite() && piece.cut_line.allFinite() && piece.quantity >= 0);
        for (std::size_t e = 0; e < piece.edges.size(); ++e) require(piece.edge_line(e).rows() >= 2);
        for (const PieceNotch& notch : piece.notches)
            require(notch.slits().size() == (notch.depth > 0 ? std::size_t(notch.count) : 0));
        require(!set.fabric(piece.fabric).name.empty());
    }
    const std::string text = pieces_json(set);
    std::istringstream again(text);
    require(pieces_json(read_pieces(again, "again.json")) == text);
    std::ostringstream svg;
    write_svg(svg, set.pieces);
    require(svg.str().size() > 100);
    return 0;
}
