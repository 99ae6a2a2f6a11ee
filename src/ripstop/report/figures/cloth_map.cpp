#include "ripstop/report/figures/cloth_map.h"

#include <array>
#include <cmath>

#include "ripstop/base/text/number_text.h"
#include "ripstop/geometry/triangle.h"
#include "ripstop/report/figures/colour_scale.h"

namespace ripstop {

double mean_edge_error(const FlatTile& tile, int triangle) {
    const TriangleMesh& mesh = tile.tile.mesh;
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
        const int a = mesh.triangles(triangle, k), b = mesh.triangles(triangle, (k + 1) % 3);
        const Points2& flat = tile.flattening.positions;
        sum +=
            std::abs((flat.row(b) - flat.row(a)).norm() / (mesh.positions.row(b) - mesh.positions.row(a)).norm() - 1);
    }
    return sum / 3;
}

std::string cloth_map(const FlatTile& tile, const PageView& view, double limit) {
    std::array<std::string, colour_classes> paths;
    std::string flipped;
    // Many triangles are small ones, so a tenth of a unit suffices.
    const int decimals = tile.tile.mesh.triangle_count() > 5000 ? 1 : 2;
    const auto at = [&](const Vec2& p) {
        const Vec2 q = view.at(p);
        return format_fixed(q.x(), decimals) + " " + format_fixed(q.y(), decimals);
    };
    for (int t = 0; t < tile.tile.mesh.triangle_count(); ++t) {
        std::array<Vec2, 3> corner;
        for (int k = 0; k < 3; ++k)
            corner[static_cast<std::size_t>(k)] = tile.flattening.positions.row(tile.tile.mesh.triangles(t, k));
        const bool up = signed_area(corner[0], corner[1], corner[2]) > 0;
        std::string& path =
            up ? paths[static_cast<std::size_t>(colour_class(mean_edge_error(tile, t), limit))] : flipped;
        path += "M" + at(corner[0]) + "L" + at(corner[1]) + " " + at(corner[2]) + "z";
    }
    // A hairline in its own colour closes the gaps that renderers leave between neighbours.
    std::string result = "<g stroke-width=\"0.5\" stroke-linejoin=\"round\">\n";
    for (int c = 0; c < colour_classes; ++c) {
        const std::string& path = paths[static_cast<std::size_t>(c)];
        if (path.empty()) continue;
        const std::string colour = class_colour(c);
        result += "<path fill=\"" + colour + "\" stroke=\"" + colour + "\" d=\"" + path + "\"/>\n";
    }
    if (!flipped.empty())
        result += "<path fill=\"#000000\" stroke=\"#000000\" stroke-width=\"1.5\" d=\"" + flipped + "\"/>\n";
    return result + "</g>\n";
}

}  // namespace ripstop
