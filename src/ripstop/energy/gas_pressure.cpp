#include "ripstop/energy/gas_pressure.h"

namespace ripstop {
namespace {

double projected_area(const Vec3& a, const Vec3& b, const Vec3& c) {
    return 0.5 * ((b.x() - a.x()) * (c.y() - a.y()) - (c.x() - a.x()) * (b.y() - a.y()));
}

/// The mean of P over the triangle, for heights above the floor.
double mean_potential(const GasPressure& gas, const Vec3& z) {
    return gas.base * z.sum() / 3 + gas.rise * (z.squaredNorm() + z[0] * z[1] + z[1] * z[2] + z[2] * z[0]) / 12;
}

}  // namespace

double gas_energy(const GasPressure& gas, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 z = Vec3(a.z(), b.z(), c.z()).array() - gas.floor;
    return -projected_area(a, b, c) * mean_potential(gas, z);
}

SpaceElement gas_element(const GasPressure& gas, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 x(a.x(), b.x(), c.x()), y(a.y(), b.y(), c.y());
    const Vec3 z = Vec3(a.z(), b.z(), c.z()).array() - gas.floor;
    const double area = projected_area(a, b, c), q = mean_potential(gas, z);
    Vec3 area_x, area_y, q_z;
    for (int v = 0; v < 3; ++v) {
        const int next = (v + 1) % 3, last = (v + 2) % 3;
        area_x[v] = 0.5 * (y[next] - y[last]);
        area_y[v] = 0.5 * (x[last] - x[next]);
        q_z[v] = gas.base / 3 + gas.rise * (z[v] + z.sum()) / 12;
    }
    SpaceElement element;
    element.energy = -area * q;
    for (int v = 0; v < 3; ++v) element.gradient.segment<3>(3 * v) = -Vec3(area_x[v] * q, area_y[v] * q, area * q_z[v]);
    for (int v = 0; v < 3; ++v)
        for (int w = 0; w < 3; ++w) {
            // d2A / dx_v dy_w = 1/2 if w follows v, -1/2 if it precedes it
            const double turn = w == (v + 1) % 3 ? 0.5 : w == (v + 2) % 3 ? -0.5 : 0;
            auto block = element.hessian.block<3, 3>(3 * v, 3 * w);
            block(0, 1) = -turn * q;
            block(1, 0) = turn * q;
            block(0, 2) = -area_x[v] * q_z[w];
            block(1, 2) = -area_y[v] * q_z[w];
            block(2, 0) = -area_x[w] * q_z[v];
            block(2, 1) = -area_y[w] * q_z[v];
            block(2, 2) = -area * gas.rise * (v == w ? 2 : 1) / 12;
        }
    return element;
}

}  // namespace ripstop
