#include "ripstop/model/cad_model.h"

namespace ripstop {

CadModel in_metres(CadModel model, double metres_per_unit) {
    for (NamedMesh& surface : model.surfaces) {
        surface.mesh.positions *= metres_per_unit;
        if (surface.drawn) *surface.drawn *= metres_per_unit;
    }
    for (NamedCurve& curve : model.curves) curve.points *= metres_per_unit;
    return model;
}

}  // namespace ripstop
