#include "support/envelopes.h"

#include <cmath>
#include <numbers>
#include <random>

#include "ripstop/tile/make_tile.h"
#include "support/shapes.h"

namespace ripstop::testing {
namespace {

/// A place in [0, 1] moved by up to a third of itself; the ends stay.
double uneven(double t, double by) {
    return t + by * std::sin(std::numbers::pi * t) * t * (1 - t);
}

std::string numbered(std::string name, int first, int second) {
    name += std::to_string(first);
    name += '-';
    name += std::to_string(second);
    return name;
}

}  // namespace

std::vector<NamedMesh> meshed_apart(const EnvelopeDesign& design, unsigned seed, double finer) {
    const NaturalShape shape = design_shape(design);
    const double top = shape.meridian.descent_to(design.crown_radius).s;
    std::mt19937 random(seed);
    const auto pick = [&random](double low, double high) {
        return low + (high - low) * static_cast<double>(random() % 1000) / 1000;
    };
    std::vector<NamedMesh> tiles;
    for (int gore = 0; gore < design.gores; ++gore)
        for (int panel = 0; panel < design.panels; ++panel) {
            const double from = top * panel / design.panels;
            const double to = panel + 1 == design.panels ? top : top * (panel + 1) / design.panels;
            const int across = static_cast<int>(finer * pick(3, 9)), along = static_cast<int>(finer * pick(4, 12));
            const double bent_u = pick(-0.3, 0.3), bent_v = pick(-0.3, 0.3);
            tiles.push_back({numbered("T", gore, panel),
                             grid(across, along,
                                  [&](double u, double v) {
                                      const double s = from + (to - from) * uneven(v, bent_v);
                                      return design_point(design, shape.point_at(v == 1 ? to : s), gore,
                                                          2 * uneven(u, bent_u) - 1);
                                  }),
                             {}});
        }
    return tiles;
}

int seam_count(const EnvelopeDesign& design) {
    return design.gores * design.panels + design.gores * (design.panels - 1);
}

std::vector<NamedMesh> brick_wall(int rows, int bricks, double latitude) {
    std::vector<NamedMesh> tiles;
    const double wide = 2 * std::numbers::pi / bricks;
    for (int row = 0; row < rows; ++row)
        for (int brick = 0; brick < bricks; ++brick) {
            const double low = latitude * (2.0 * row / rows - 1), high = latitude * (2.0 * (row + 1) / rows - 1);
            const double start = wide * (brick + (row % 2) / 2.0);
            tiles.push_back({numbered("B", row, brick),
                             grid(7 + 3 * (row % 3), 6 + brick % 3,
                                  [&](double u, double v) {
                                      const double theta = low + (high - low) * v, phi = start + wide * u;
                                      return Vec3(std::cos(theta) * std::cos(phi), std::cos(theta) * std::sin(phi),
                                                  std::sin(theta));
                                  }),
                             {}});
        }
    return tiles;
}

std::vector<NamedMesh> square_tube() {
    const auto corner = [](int k, double z) { return Vec3(k % 4 == 0 || k % 4 == 3 ? 0 : 2, k % 4 > 1 ? 2 : 0, z); };
    std::vector<NamedMesh> tiles;
    for (int side = 0; side < 4; ++side)
        for (int row = 0; row < 3; ++row)
            tiles.push_back({numbered("T", side, row),
                             grid(3, 3,
                                  [&](double u, double v) {
                                      return Vec3((1 - u) * corner(side, row + v) + u * corner(side + 1, row + v));
                                  }),
                             {}});
    return tiles;
}

Envelope tiles_of(const std::vector<NamedMesh>& meshes) {
    Envelope envelope;
    for (const NamedMesh& mesh : meshes) envelope.tiles.push_back(make_tile(mesh.name, mesh.mesh));
    return envelope;
}

}  // namespace ripstop::testing
