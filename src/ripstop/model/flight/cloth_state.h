#pragma once

namespace ripstop {

/// How a triangle of cloth carries load.
enum class ClothState {
    taut,      ///< pulled both ways
    wrinkled,  ///< pulled one way, folded across it
    slack,     ///< not pulled at all
};

}  // namespace ripstop
