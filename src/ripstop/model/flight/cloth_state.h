#pragma once

namespace ripstop {

/// How a triangle of cloth carries load.
enum class ClothState {
    taut,      ///< in tension in both directions
    wrinkled,  ///< in tension in one direction, folded across it
    slack,     ///< without tension
};

}  // namespace ripstop
