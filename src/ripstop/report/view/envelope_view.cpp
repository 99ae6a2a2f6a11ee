#include "ripstop/report/view/envelope_view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ripstop/mesh/boundary.h"
#include "ripstop/report/figures/seam_drift.h"
#include "ripstop/report/view/page_colours.h"
#include "ripstop/report/view/raster.h"
#include "ripstop/tile/targets.h"

namespace ripstop {
namespace {

constexpr std::uint32_t outline_colour = 0x6f7a85, failing_colour = 0xa50f2d, proposed_colour = 0x111111;

struct Line {
    std::vector<Vec3> points;
    std::uint32_t colour = outline_colour;
    double width = 1;
    double nearer = 0;  ///< depth offset towards the viewer, relative to the shape's radius
    bool is_dashed = false;
};

std::vector<Vec3> outline_of(const Tile& tile, const Points3& positions) {
    std::vector<Vec3> points;
    for (const int vertex : closed(tile.boundary)) points.emplace_back(positions.row(vertex));
    return points;
}

std::vector<Vec3> seam_line(const CutPlan& plan, const EnvelopeShape& shape, const SeamSide& side) {
    const auto tile = static_cast<std::size_t>(side.tile);
    const std::vector<int> loop = closed(plan.tiles[tile].tile.boundary);
    const Eigen::VectorXd drawn = drawn_lengths(plan.tiles[tile].tile);
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < side.parts.size(); ++i) {
        const auto edge = static_cast<std::size_t>(side.parts[i].edge);
        const auto [from, to] = share_of_edge(side, i, drawn[side.parts[i].edge]);
        const Vec3 a = shape.positions[tile].row(loop[edge]), b = shape.positions[tile].row(loop[edge + 1]);
        if (i == 0) points.push_back(a + from * (b - a));
        points.push_back(a + to * (b - a));
    }
    return points;
}

/// Later lines are drawn over earlier ones.
std::vector<Line> lines_of(const CutPlan& plan, const EnvelopeShape& shape, double width) {
    std::vector<Line> lines, failing, proposed;
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        const FlatTile& tile = plan.tiles[i];
        const std::vector<Vec3> outline = outline_of(tile.tile, shape.positions[i]);
        lines.push_back({outline, outline_colour, width, 0.006});
        if (tile.verdict.manufacturable()) continue;
        failing.push_back({outline, failing_colour, 2.5 * width, 0.01});
        if (!tile.proposal) continue;
        Line line{{}, proposed_colour, 3 * width, 0.012, true};
        for (const Vec3& point : tile.proposal->line) line.points.push_back(shape.turned(point));
        proposed.push_back({line.points, 0xffffff, 5.5 * width, 0.011});
        proposed.push_back(line);
    }
    for (std::size_t i = 0; i < plan.walks.size(); ++i)
        if (!plan.walks[i].ok)
            failing.push_back({seam_line(plan, shape, plan.seams[i].a), failing_colour, 2.5 * width, 0.01});
    lines.insert(lines.end(), failing.begin(), failing.end());
    lines.insert(lines.end(), proposed.begin(), proposed.end());
    return lines;
}

/// Splits a line into dashes by its length in space.
std::vector<std::array<Vec3, 2>> dashes(const std::vector<Vec3>& points, double dash, double gap) {
    std::vector<std::array<Vec3, 2>> strokes;
    double walked = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const Vec3 step = points[i + 1] - points[i];
        const double length = step.norm();
        for (double at = 0; at < length;) {
            const double phase = std::fmod(walked + at, dash + gap);
            const double end = std::min(length, at + std::max((phase < dash ? dash : dash + gap) - phase, 1e-3 * gap));
            if (phase < dash) strokes.push_back({points[i] + at / length * step, points[i] + end / length * step});
            at = end;
        }
        walked += length;
    }
    return strokes;
}

class Painter {
  public:
    explicit Painter(EnvelopeView& view, double radius) : view_(view), radius_(radius) {
        const auto count = static_cast<std::size_t>(view.side) * static_cast<std::size_t>(view.side);
        view.cloth.assign(count, -1);
        view.band.assign(count, -1);
        view.lines.assign(count, EnvelopeView::no_line);
        depths_.assign(count, -std::numeric_limits<double>::infinity());
    }

    void triangle(const std::array<Vec3, 3>& corners, int number) {
        fill(corners, 0, [&](std::size_t place, double depth) {
            if (depth <= depths_[place]) return;
            depths_[place] = depth;
            view_.cloth[place] = number;
        });
    }

    /// Draws the band where no cloth is in front of it.
    void band(const std::array<Vec3, 4>& corners, int edge) {
        for (const auto& half : {std::array{corners[0], corners[1], corners[2]}, {corners[0], corners[2], corners[3]}})
            fill(half, 0.004 * radius_, [&](std::size_t place, double depth) {
                if (depth > depths_[place]) view_.band[place] = edge;
            });
    }

    void line(const Line& line) {
        std::vector<std::array<Vec3, 2>> strokes;
        if (line.is_dashed)
            strokes = dashes(line.points, radius_ / 60, radius_ / 110);
        else
            for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
                strokes.push_back({line.points[i], line.points[i + 1]});
        for (const auto& [from, to] : strokes) stroke(view_.at(from), view_.at(to), line);
    }

  private:
    template <class Paint>
    void fill(const std::array<Vec3, 3>& corners, double nearer, const Paint& paint) {
        std::array<Vec3, 3> seen;
        for (std::size_t k = 0; k < 3; ++k) seen[k] = view_.at(corners[k]) + Vec3(0, 0, nearer);
        each_pixel(view_.side, view_.side, seen,
                   [&](int place, double depth) { paint(static_cast<std::size_t>(place), depth); });
    }

    /// A straight band on the page; its ends extend below the neighbouring bands of the same line.
    void stroke(Vec3 from, Vec3 to, const Line& line) {
        const Vec3 step = to - from;
        const double length = std::hypot(step.x(), step.y());
        if (!(length > 0)) return;
        const Vec3 reach = line.is_dashed ? Vec3::Zero() : Vec3(0.35 * line.width / length * step);
        from -= Vec3(reach.x(), reach.y(), 0);
        to += Vec3(reach.x(), reach.y(), 0);
        const Vec3 half = line.width / 2 / length * Vec3(-step.y(), step.x(), 0);
        const Vec3 nearer(0, 0, line.nearer * radius_);
        const std::array<Vec3, 4> corner{from + half + nearer, to + half + nearer, to - half + nearer,
                                         from - half + nearer};
        for (const auto& part : {std::array{corner[0], corner[1], corner[2]}, {corner[0], corner[2], corner[3]}})
            each_pixel(view_.side, view_.side, part, [&](int place, double depth) {
                if (depth > depths_[static_cast<std::size_t>(place)])
                    view_.lines[static_cast<std::size_t>(place)] = line.colour;
            });
    }

    EnvelopeView& view_;
    double radius_;
    std::vector<double> depths_;  ///< depths of the cloth
};

/// For each boundary edge, the direction into the cloth, in the plane of its triangle.
std::vector<Vec3> inward_of(const Tile& tile, const Points3& positions) {
    std::vector<int> place(static_cast<std::size_t>(tile.mesh.vertex_count()), -1);
    for (std::size_t i = 0; i < tile.boundary.size(); ++i)
        place[static_cast<std::size_t>(tile.boundary[i])] = static_cast<int>(i);
    std::vector<Vec3> inward(tile.boundary.size(), Vec3::Zero());
    for (int t = 0; t < tile.mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k) {
            const int a = tile.mesh.triangles(t, k), b = tile.mesh.triangles(t, (k + 1) % 3);
            const int at = place[static_cast<std::size_t>(a)];
            if (at < 0) continue;
            const auto i = static_cast<std::size_t>(at);
            if (tile.boundary[(i + 1) % tile.boundary.size()] != b) continue;
            const Vec3 along = (positions.row(b) - positions.row(a)).normalized();
            const Vec3 across = positions.row(tile.mesh.triangles(t, (k + 2) % 3)) - positions.row(a);
            inward[i] = (across - across.dot(along) * along).normalized();
        }
    return inward;
}

void paint_band(Painter& painter, const Tile& tile, const Points3& positions, int first_edge) {
    const std::vector<Vec3> inward = inward_of(tile, positions);
    const Eigen::RowVector3d middle = positions.colwise().mean();
    const double width = 0.07 * (positions.rowwise() - middle).rowwise().norm().maxCoeff();
    const std::size_t count = tile.boundary.size();
    const auto outer = [&](std::size_t i) { return Vec3(positions.row(tile.boundary[i % count])); };
    const auto inner = [&](std::size_t i) {
        return Vec3(outer(i) + width * (inward[i % count] + inward[(i + count - 1) % count]).normalized());
    };
    for (std::size_t i = 0; i < count; ++i)
        painter.band({outer(i), outer(i + 1), inner(i + 1), inner(i)}, first_edge + static_cast<int>(i));
}

}  // namespace

EnvelopeShape envelope_shape(const CutPlan& plan, bool is_inflated) {
    Eigen::AlignedBox3d box;  // as drawn: the up direction does not change in flight
    for (const FlatTile& tile : plan.tiles)
        for (const auto& row : tile.tile.mesh.positions.rowwise()) box.extend(Vec3(row));
    EnvelopeShape shape;
    if (box.isEmpty()) return shape;
    const Vec3 size = box.sizes();
    shape.is_y_up = size.y() > 1.3 * size.z() && size.y() > 1.3 * size.x();
    shape.centre = shape.turned(box.center());
    double radius = 0;
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        Points3 positions = is_inflated ? plan.inflated->tiles[i].positions : plan.tiles[i].tile.mesh.positions;
        for (Eigen::Index v = 0; v < positions.rows(); ++v) {
            positions.row(v) = shape.turned(positions.row(v)).transpose();
            radius = std::max(radius, (Vec3(positions.row(v)) - shape.centre).norm());
        }
        shape.positions.push_back(std::move(positions));
    }
    if (radius > 0) shape.radius = radius;
    return shape;
}

Vec3 EnvelopeView::at(const Vec3& point) const {
    const Vec3 p = point - centre;
    const double half = side / 2.0;
    return {half + pixels_per_metre * p.dot(right), half - pixels_per_metre * p.dot(up), p.dot(towards)};
}

EnvelopeView aimed_view(const EnvelopeShape& shape, const Vec3& direction, int side) {
    constexpr double filled = 0.97;  // share of the square; leaves space for the width of lines
    EnvelopeView view;
    view.side = side;
    view.towards = direction.normalized();
    view.right = Vec3::UnitY().cross(view.towards).normalized();
    view.up = view.towards.cross(view.right);
    Eigen::AlignedBox2d box;
    for (const Points3& positions : shape.positions)
        for (const auto& row : positions.rowwise()) box.extend(Vec2(Vec3(row).dot(view.right), Vec3(row).dot(view.up)));
    if (box.isEmpty()) return view;
    view.centre = box.center().x() * view.right + box.center().y() * view.up;
    view.pixels_per_metre = filled * side / std::max(box.sizes().maxCoeff(), 1e-9);
    return view;
}

void paint_envelope(EnvelopeView& view, const CutPlan& plan, const EnvelopeShape& shape, double line_width) {
    Painter painter(view, shape.radius);
    int number = 0, edge = 0;
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        const Triangles& triangles = plan.tiles[i].tile.mesh.triangles;
        for (Eigen::Index t = 0; t < triangles.rows(); ++t)
            painter.triangle(
                {Vec3(shape.positions[i].row(triangles(t, 0))), Vec3(shape.positions[i].row(triangles(t, 1))),
                 Vec3(shape.positions[i].row(triangles(t, 2)))},
                number++);
    }
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        paint_band(painter, plan.tiles[i].tile, shape.positions[i], edge);
        edge += static_cast<int>(plan.tiles[i].tile.boundary.size());
    }
    for (const Line& line : lines_of(plan, shape, line_width)) painter.line(line);
}

Pixels coloured(const EnvelopeView& view, const CutPlan& plan, const MapView& map) {
    std::vector<std::uint16_t> of_cloth, of_edges;
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        const std::vector<std::uint16_t> cloth = cloth_places(plan, map, i), edges = edge_places(map, i);
        of_cloth.insert(of_cloth.end(), cloth.begin(), cloth.end());
        of_edges.insert(of_edges.end(), edges.begin(), edges.end());
    }
    Pixels pixels{view.side, view.side, std::vector<std::uint32_t>(view.cloth.size(), 0xffffff)};
    for (std::size_t i = 0; i < view.cloth.size(); ++i) {
        std::uint32_t& colour = pixels.colours[i];
        if (view.lines[i] != EnvelopeView::no_line)
            colour = view.lines[i];
        else if (view.band[i] >= 0 && !of_edges.empty())
            colour = page_colours()[of_edges[static_cast<std::size_t>(view.band[i])]];
        else if (view.cloth[i] >= 0)
            colour = page_colours()[of_cloth[static_cast<std::size_t>(view.cloth[i])]];
    }
    return pixels;
}

}  // namespace ripstop
