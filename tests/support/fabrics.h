#pragma once

#include "ripstop/model/tile/fabric.h"

/// Cloth of the tables and of the derivative tests: E = 1 kN/m.
namespace ripstop::testing {

/// The same both ways, with this contraction and G / E.
inline Fabric cloth(double nu, double shear_ratio) {
    Fabric fabric;
    fabric.poisson = nu;
    fabric.shear_stiffness = shear_ratio * 1000;
    return fabric;
}

/// Softer along the weft and weak in shear [N/m], so that no two constants are alike.
inline Fabric uneven_cloth(double shear_stiffness) {
    Fabric fabric;
    fabric.weft_stiffness = 700;
    fabric.poisson = 0.2;
    fabric.shear_stiffness = shear_stiffness;
    return fabric;
}

}  // namespace ripstop::testing
