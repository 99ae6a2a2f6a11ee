#include "ripstop/model/special/special_shape.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "ripstop/base/error.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"

namespace ripstop {
namespace {

std::string in_millimetres(double length) {
    return format_shortest(std::round(length / millimetre * 1e6) / 1e6) + " mm";
}

void require_length(double length, bool may_be_zero, const char* what, const std::string& place) {
    if ((length > 0 || (may_be_zero && length == 0)) && length < 1000) return;
    throw InputError(place + ": the " + what + " is " + in_millimetres(length) + ", expected a length " +
                     (may_be_zero ? "from 0" : "above 0") + " to below 1 km");
}

void require_count(int count, const char* what, const std::string& place) {
    if (count < 1 || count > 1000)
        throw InputError(place + ": " + what + " is " + std::to_string(count) + ", expected 1 to 1000");
}

void require_name(const std::string& name, const std::string& place) {
    const auto allowed = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
    };
    if (name.empty() || name.size() > 40 || !std::all_of(name.begin(), name.end(), allowed))
        throw InputError(place +
                         ": its name is not valid, expected 1 to 40 letters A to Z, digits, - and _, because tiles "
                         "are named after it");
}

void require_sizes(const SpecialPrimitive& p, const std::string& place) {
    switch (p.kind) {
        case PrimitiveKind::ellipsoid:
            for (const double radius : p.radii) require_length(radius, false, "radius", place);
            break;
        case PrimitiveKind::torus:
            require_length(p.radius, false, "radius", place);
            require_length(p.tube_radius, false, "tube radius", place);
            if (!(p.tube_radius < p.radius))
                throw InputError(place + ": the tube radius is " + in_millimetres(p.tube_radius) + " and the radius " +
                                 in_millimetres(p.radius) +
                                 ", expected a tube thinner than that, or the torus has no hole");
            break;
        case PrimitiveKind::capsule:
            require_length(p.radius, false, "radius", place);
            require_length(p.length, false, "length", place);
            break;
        case PrimitiveKind::cone:
            require_length(p.radius, false, "radius", place);
            require_length(p.length, false, "length", place);
            require_length(p.top_radius, true, "top radius", place);
            break;
    }
    for (const double at : p.centre)
        if (!(std::abs(at) < 1000))
            throw InputError(place + ": the centre lies at " + in_millimetres(at) + ", expected within 1 km of 0");
}

}  // namespace

double SpecialPrimitive::smallest_radius() const {
    switch (kind) {
        case PrimitiveKind::ellipsoid:
            return radii.minCoeff();
        case PrimitiveKind::torus:
            return std::min(tube_radius, radius - tube_radius);
        case PrimitiveKind::capsule:
            return radius;
        case PrimitiveKind::cone:
            return std::min({radius, length, top_radius > 0 ? top_radius : radius});
    }
    return 0;
}

void require_valid(const SpecialShape& shape, const std::string& place) {
    const std::size_t count = shape.primitives.size();
    if (count < 1 || count > 200)
        throw InputError(place + ": there are " + std::to_string(count) + " primitives, expected 1 to 200");
    require_length(shape.edge_length, false, "edge length", place);
    require_length(shape.joint_radius, true, "joint radius", place);
    if (shape.mouth && !(std::abs(*shape.mouth) < 1000))
        throw InputError(place + ": the mouth lies at " + in_millimetres(*shape.mouth) + ", expected within 1 km of 0");
    std::set<std::string> names;
    for (std::size_t i = 0; i < count; ++i) {
        const SpecialPrimitive& p = shape.primitives[i];
        require_name(p.name, place + ": primitive " + std::to_string(i + 1));
        const std::string here = place + ": primitive " + std::to_string(i + 1) + " (" + p.name + ")";
        if (!names.insert(p.name).second) throw InputError(here + ": an earlier one has its name; give each its own");
        if (!(p.axis.norm() > 0) || !p.axis.allFinite())
            throw InputError(here + ": the axis has no direction, expected a vector other than [0, 0, 0]");
        require_sizes(p, here);
        require_count(p.sectors, "sectors", here);
        require_count(p.rings, "rings", here);
        if (!(shape.edge_length <= p.smallest_radius() / 2 * (1 + 1e-12)))
            throw InputError(here + ": the edge length of " + in_millimetres(shape.edge_length) +
                             " is too coarse for it, expected at most " + in_millimetres(p.smallest_radius() / 2) +
                             ", half of its smallest radius; give shorter edges or a larger primitive");
    }
    if (shape.joint_radius > 0 && shape.joint_radius < shape.edge_length)
        throw InputError(place + ": the joint radius of " + in_millimetres(shape.joint_radius) +
                         " is below the edge length of " + in_millimetres(shape.edge_length) +
                         ", which cannot follow it; give 0 (a sharp crease), a wider joint or shorter edges");
}

}  // namespace ripstop
