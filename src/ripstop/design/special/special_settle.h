#pragma once

#include <vector>

#include "ripstop/design/special/special_body.h"

namespace ripstop {

/// What a point has to lie on: the body's surface as these faces show it (none: whichever face is nearest), and curves.
struct Ties {
    std::vector<int> faces;
    std::vector<BodyCurve> curves;

    void add(int face);
    void add(const BodyCurve& curve);
};

/// Newton's method with the shortest steps J^+ r, each at most `reach` long, to the nearest point that is on everything
/// at once, to 1e-11 m. False where it gets to none within four `reach` of the start; `place` then stays as it was.
///
/// Where surfaces meet in a sharp crease their faces alone say where it is; in a fillet it is where their levels are
/// equal.
bool settle(const SpecialBody& body, const Ties& ties, double reach, Vec3& place);

}  // namespace ripstop
