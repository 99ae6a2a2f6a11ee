#pragma once

#include "ripstop/model/tile/fabric.h"

/// Cloth for the tables and the derivative tests: E = 1 kN/m.
namespace ripstop::testing {

/// Equal in both directions, with this Poisson's ratio and G / E.
inline Fabric cloth(double nu, double shear_ratio) {
    Fabric fabric;
    fabric.poisson = nu;
    fabric.shear_stiffness = shear_ratio * 1000;
    return fabric;
}

/// Softer along the weft and weak in shear [N/m], so that all constants differ.
inline Fabric uneven_cloth(double shear_stiffness) {
    Fabric fabric;
    fabric.weft_stiffness = 700;
    fabric.poisson = 0.2;
    fabric.shear_stiffness = shear_stiffness;
    return fabric;
}

}  // namespace ripstop::testing
