#include "ripstop/design/natural/gores.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ripstop/base/index.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/range.h"
#include "ripstop/design/tools/panel_rows.h"

namespace ripstop {
namespace {

using std::numbers::pi;

constexpr double equilateral = 0.8660254037844386;  // height of an equilateral triangle over its side

void require_valid(const EnvelopeDesign& d) {
    require_range("number of gores", d.gores, 3, 1000, "");
    require_range("number of panels", d.panels, 1, 1000, "");
    require_range("panel height", d.panel_height, 0, 1000, "m");
    require_above("volume", d.volume, 0, "m3");
    require_range("diameter", d.diameter, 0, 1000, "m");
    require_range("mouth ratio", d.mouth_ratio, 0, 0.8, "");
    require_range("crown radius", d.crown_radius, 0, 1000, "m");
    require_angle("bulge half-angle", d.bulge, 60);
    require_above("edge length", d.edge_length, 0, "m");
    require_range("fabric mass", d.fabric_mass, 0, 10, "kg/m2");
}

/// The subdivision of a gore, the same for every gore: the number of edges at every row.
struct GoreGrid {
    const EnvelopeDesign& design;
    const NaturalShape& shape;

    /// Width of the cloth across the gore [m].
    double width(const MeridianPoint& at) const {
        const double a = pi / design.gores;
        return design.bulge > 0 ? 2 * at.r * std::sin(a) * design.bulge / std::sin(design.bulge) : 2 * at.r * a;
    }
    /// The number of edges across for which none turns by more than 20 degrees, so that no further corners appear.
    int least_across(const MeridianPoint& at) const {
        const double turn = std::max(2 * pi / design.gores * std::abs(std::sin(at.theta)), 2 * design.bulge);
        return std::max(1, static_cast<int>(std::ceil(turn / (20 * degree) - 1e-9)));
    }
    /// The local edge length: the design's, or less so that two edges fit across, but at least a third of the
    /// design's.
    double edge_length(const MeridianPoint& at) const {
        return std::clamp(width(at) / std::max(2, least_across(at)), design.edge_length / 3, design.edge_length);
    }
    RowWish wish(const MeridianPoint& at) const { return {width(at) / edge_length(at), least_across(at)}; }

    int seam_columns(const MeridianPoint& at) const {
        if (at.r <= 1e-9 * shape.max_radius) return 0;
        return std::max(least_across(at), static_cast<int>(std::lround(wish(at).across)));
    }
};

/// Arc lengths of a panel's rows, both seams included, spaced by the local edge length; their number satisfies
/// `parity_fits`.
std::vector<double> row_places(const GoreGrid& grid, double from, double to) {
    constexpr int samples = 64;
    std::vector<double> rows_below{0};  // number of rows below each sample
    const double step = (to - from) / samples;
    for (int i = 0; i < samples; ++i) {
        const double height = equilateral * grid.edge_length(grid.shape.point_at(from + (i + 0.5) * step));
        rows_below.push_back(rows_below.back() + step / height);
    }
    const int first = grid.seam_columns(grid.shape.point_at(from));
    const int last = grid.seam_columns(grid.shape.point_at(to));
    int strips = std::max(2, static_cast<int>(std::lround(rows_below.back())));
    if (!parity_fits(first, last, strips)) strips += strips > 2 && rows_below.back() < strips ? -1 : 1;
    std::vector<double> places{from};
    std::size_t below = 0;
    for (int k = 1; k < strips; ++k) {
        const double wanted = rows_below.back() * k / strips;
        while (rows_below[below + 1] < wanted) ++below;
        const double part = (wanted - rows_below[below]) / (rows_below[below + 1] - rows_below[below]);
        places.push_back(from + step * (static_cast<double>(below) + part));
    }
    places.push_back(to);
    return places;
}

/// The data that all panels of one row share.
struct PanelGrid {
    std::vector<MeridianPoint> rows;
    RowColumns columns;
    Triangles triangles;
};

PanelGrid panel_grid(const GoreGrid& grid, double from, double to) {
    PanelGrid panel;
    std::vector<RowWish> wishes;
    for (const double s : row_places(grid, from, to)) {
        panel.rows.push_back(grid.shape.point_at(s));
        wishes.push_back(grid.wish(panel.rows.back()));
    }
    for (MeridianPoint* seam : {&panel.rows.front(), &panel.rows.back()})
        if (grid.seam_columns(*seam) == 0) seam->r = 0;
    panel.columns = stagger(wishes, grid.seam_columns(panel.rows.front()), grid.seam_columns(panel.rows.back()));
    panel.triangles = triangulate_rows(panel.columns);
    return panel;
}

TriangleMesh panel_mesh(const EnvelopeDesign& design, const PanelGrid& panel, int gore) {
    TriangleMesh mesh;
    mesh.triangles = panel.triangles;
    mesh.positions.resize(panel.triangles.maxCoeff() + 1, 3);
    Eigen::Index v = 0;
    for (std::size_t k = 0; k < panel.rows.size(); ++k) {
        const int n = panel.columns[k];
        for (int i = 0; i <= n; ++i)
            mesh.positions.row(v++) = design_point(design, panel.rows[k], gore, n == 0 ? 0 : double(2 * i - n) / n);
    }
    return mesh;
}

double top_of_cloth(const EnvelopeDesign& design, const NaturalShape& shape) {
    if (design.crown_radius == 0) return shape.length;
    if (!(design.crown_radius < 0.9 * shape.max_radius))
        throw InputError("the crown radius is " + format_shortest(design.crown_radius) +
                         " m, but the envelope's largest radius is " + format_fixed(shape.max_radius, 2) +
                         " m; the opening must be narrower than nine tenths of it");
    return shape.meridian.descent_to(design.crown_radius).s;
}

int panel_count(const EnvelopeDesign& design, double top) {
    if (design.panel_height == 0) return design.panels;
    const double count = std::ceil(top / design.panel_height - 1e-9);
    require_range("number of panels (from the panel height)", count, 1, 1000, "");
    return static_cast<int>(count);
}

}  // namespace

NaturalShape design_shape(const EnvelopeDesign& design) {
    require_valid(design);
    NaturalShapeOptions options;
    options.volume = design.volume;
    if (design.diameter > 0) options.diameter = design.diameter;
    options.mouth_ratio = design.mouth_ratio;
    options.buoyancy = buoyancy(design.air);
    options.weight = design.fabric_mass * gravity;
    options.tapes = design.gores;
    options.bulge = design.bulge;
    NaturalShape shape = natural_shape(options);
    if (shape.summary.usable()) return shape;
    std::string bulge = design.bulge > 0 ? " and lobes of " + format_shortest(design.bulge / degree) + " degrees" : "";
    const std::string size = design.diameter > 0 ? format_shortest(design.diameter) + " m across, "
                                                 : format_shortest(design.volume) + " m3, ";
    throw InputError("no natural shape exists for " + size + std::to_string(design.gores) + " gores, mouth ratio " +
                     format_shortest(design.mouth_ratio) + ", cloth of " + format_shortest(design.fabric_mass) +
                     " kg/m2" + bulge +
                     "; give more volume, hotter air, or more gores with lobes of at least 20 degrees");
}

Vec3 design_point(const EnvelopeDesign& design, const MeridianPoint& at, int gore, double u) {
    const double a = pi / design.gores;
    if (std::abs(u) == 1) {
        const int seam = (u > 0 ? gore + 1 : gore) % design.gores;
        return {at.r * std::cos(2 * a * seam), at.r * std::sin(2 * a * seam), at.z};
    }
    const double middle = a * (2 * gore + 1);
    if (design.bulge == 0) return {at.r * std::cos(middle + a * u), at.r * std::sin(middle + a * u), at.z};
    const double B = design.bulge;
    const double rho = at.r * std::sin(a) / std::sin(B);
    const double out = rho * (std::cos(u * B) - std::cos(B));
    const double radial = at.r * std::cos(a) + out * std::cos(at.theta);
    const double across = rho * std::sin(u * B);
    return {radial * std::cos(middle) - across * std::sin(middle),
            radial * std::sin(middle) + across * std::cos(middle), at.z - out * std::sin(at.theta)};
}

std::vector<NamedMesh> design_natural(const EnvelopeDesign& design) {
    const NaturalShape shape = design_shape(design);
    const double top = top_of_cloth(design, shape);
    const int panels = panel_count(design, top);
    const double triangles = shape.area / (0.5 * equilateral * design.edge_length * design.edge_length);
    if (!(triangles < 20e6))
        throw InputError("the edge length is " + format_shortest(design.edge_length) + " m, which gives about " +
                         format_fixed(triangles / 1e6, 0) + " million triangles, the limit is 20; give longer edges");
    const GoreGrid grid{design, shape};
    std::vector<PanelGrid> grids;
    for (int j = 0; j < panels; ++j)
        grids.push_back(panel_grid(grid, top * j / panels, j + 1 == panels ? top : top * (j + 1) / panels));
    std::vector<NamedMesh> tiles;
    for (int gore = 0; gore < design.gores; ++gore)
        for (int j = 0; j < panels; ++j)
            tiles.push_back({"G" + padded(at(gore + 1), at(design.gores)) + "P" + padded(at(j + 1), at(panels)),
                             panel_mesh(design, grids[at(j)], gore),
                             {}});
    return tiles;
}

double edge_length_for(const EnvelopeDesign& design, int triangles_per_tile) {
    require_range("number of triangles a tile", triangles_per_tile, 8, 1000000, "");
    const NaturalShape shape = design_shape(design);
    const double top = top_of_cloth(design, shape);
    const double area = shape.point_at(top).area / (design.gores * panel_count(design, top));
    return std::sqrt(area / triangles_per_tile / (0.5 * equilateral));
}

}  // namespace ripstop
