#include "ripstop/model/tile/cad_model.h"

#include <cmath>

namespace ripstop {

double single_rounding(double largest) {
    constexpr int digits = 24;  // bits of a float's mantissa
    return largest > 0 ? std::ldexp(1.0, std::ilogb(largest) - digits) : 0;
}

CadModel in_metres(CadModel model, double metres_per_unit) {
    for (NamedMesh& surface : model.surfaces) {
        surface.mesh.positions *= metres_per_unit;
        if (surface.drawn) *surface.drawn *= metres_per_unit;
    }
    for (NamedCurve& curve : model.curves) curve.points *= metres_per_unit;
    model.rounding *= metres_per_unit;
    return model;
}

}  // namespace ripstop
