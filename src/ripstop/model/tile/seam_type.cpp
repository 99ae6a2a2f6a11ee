#include "ripstop/model/tile/seam_type.h"

#include <array>

namespace ripstop {
namespace {

const std::array<SeamType, 8>& table() {
    static const std::array<SeamType, 8> types = {{
        {"flat-felled", 25 * millimetre, 2, false},
        {"french", 25 * millimetre, 2, false},
        {"taped", 25 * millimetre, 2, true},
        {"overlap", 25 * millimetre, 2, false},
        {"plain", 13 * millimetre, 1, false},
        {"hem", 25 * millimetre, 2, false},
        {"mouth-hem", 38 * millimetre, 2, true},
        {"raw", 0, 0, false},
    }};
    return types;
}

}  // namespace

std::span<const SeamType> seam_types() {
    return table();
}

const SeamType& default_hem() {
    return table()[5];
}

}  // namespace ripstop
