#pragma once

#include <vector>

#include "ripstop/design/special/special_body.h"

namespace ripstop {

/// The constraints of a point: the surface of the body as given by these faces (none: by the nearest face), and
/// curves.
struct Ties {
    std::vector<int> faces;
    std::vector<BodyCurve> curves;

    void add(int face);
    void add(const BodyCurve& curve);
};

/// Newton's method with minimum-norm steps J^+ r, each at most `reach` long, to the nearest point that satisfies all
/// constraints to 1e-11 m. Returns false if there is none within four `reach` of the start; `place` is then
/// unchanged.
///
/// If surfaces meet in a sharp crease, their faces alone determine it; in a fillet it is where their levels are
/// equal.
bool settle(const SpecialBody& body, const Ties& ties, double reach, Vec3& place);

}  // namespace ripstop
