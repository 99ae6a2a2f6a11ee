#include "ripstop/pipeline/read/surface_lines.h"

#include <algorithm>
#include <limits>

#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"
#include "ripstop/mesh/surface_finder.h"
#include "ripstop/pipeline/read/grain_lines.h"

namespace ripstop {
namespace {

constexpr double reach = 0.010;         // a curve is drawn on the surface, and a tile is only a mesh of it [m]
constexpr double lookup_step = 0.020;   // distance between the points that are looked up [m]
constexpr double crossing = 1e-5;       // accuracy of the place where a curve crosses a seam [m]
constexpr double along_edge = 0.002;    // a run closer to the boundary than this is the seam [m]
constexpr double narrowest = 0.001;     // width of the narrowest tile that is never skipped [m]
constexpr double worth_saying = 0.005;  // shortest lost length of a curve that is reported [m]
constexpr int nowhere = -1;

/// Finds the tile that a point lies on.
class Tiles {
  public:
    explicit Tiles(const Envelope& envelope) {
        for (const Tile& tile : envelope.tiles) finders_.emplace_back(tile.mesh);
    }
    int at(const Vec3& point) {
        int best = nowhere;
        double least = reach;
        for (std::size_t i = 0; i < finders_.size(); ++i)
            if (const auto found = finders_[i].nearest(point, least)) {
                if (best != nowhere && !(found->distance < least)) continue;  // the first wins a tie
                least = found->distance;
                best = static_cast<int>(i);
            }
        return best;
    }

  private:
    std::vector<SurfaceFinder> finders_;
};

std::vector<Vec3> densified(const Points3& points) {
    std::vector<Vec3> dense{Vec3(points.row(0))};
    for (Eigen::Index i = 1; i < points.rows(); ++i) {
        const Vec3 from = points.row(i - 1), to = points.row(i);
        const int parts = std::max(1, static_cast<int>(std::ceil((to - from).norm() / lookup_step)));
        for (int k = 1; k <= parts; ++k) dense.push_back(from + (to - from) * k / parts);
    }
    return dense;
}

/// The place between two points where the curve leaves the tile at `a`.
Vec3 crossing_between(Tiles& tiles, Vec3 a, Vec3 b, int tile) {
    while ((b - a).norm() > crossing) {
        const Vec3 middle = (a + b) / 2;
        (tiles.at(middle) == tile ? a : b) = middle;
    }
    return a;
}

double distance_to_boundary(const Tile& tile, const Vec3& point) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < tile.boundary.size(); ++i) {
        const Vec3 a = tile.mesh.positions.row(tile.boundary[i]);
        const Vec3 way = Vec3(tile.mesh.positions.row(tile.boundary[(i + 1) % tile.boundary.size()])) - a;
        const double t = std::clamp((point - a).dot(way) / way.squaredNorm(), 0.0, 1.0);
        least = std::min(least, (a + t * way - point).norm());
    }
    return least;
}

bool is_seam(const Tile& tile, const std::vector<Vec3>& run) {
    return std::all_of(run.begin(), run.end(),
                       [&tile](const Vec3& point) { return distance_to_boundary(tile, point) < along_edge; });
}

void add_run(Envelope& envelope, int tile, const std::vector<Vec3>& run, const std::string& name) {
    if (tile == nowhere || run.size() < 2) return;
    Tile& on = envelope.tiles[static_cast<std::size_t>(tile)];
    if (is_seam(on, run)) return;
    SurfaceLine line{name, Points3(static_cast<Eigen::Index>(run.size()), 3)};
    for (std::size_t i = 0; i < run.size(); ++i) line.points.row(static_cast<Eigen::Index>(i)) = run[i];
    on.lines.push_back(std::move(line));
}

/// Adds points between two that lie on different tiles, until no tile is skipped.
void add_between(Tiles& tiles, const Vec3& from, const Vec3& to, int tile_from, int tile_to,
                 std::vector<Vec3>& points) {
    if (tile_from == tile_to || (to - from).norm() < narrowest) return;
    const Vec3 middle = (from + to) / 2;
    const int tile = tiles.at(middle);
    add_between(tiles, from, middle, tile_from, tile, points);
    points.push_back(middle);
    add_between(tiles, middle, to, tile, tile_to, points);
}

/// Whether no tile wider than `narrowest` lies between the two points.
std::vector<Vec3> points_to_look_up(Tiles& tiles, const Points3& curve) {
    std::vector<Vec3> points;
    int before = nowhere;
    for (const Vec3& point : densified(curve)) {
        const int here = tiles.at(point);
        if (!points.empty()) {
            const Vec3 last = points.back();
            add_between(tiles, last, point, before, here, points);
        }
        points.push_back(point);
        before = here;
    }
    return points;
}

/// The length of a curve on tiles and off all tiles [m].
struct LaidLine {
    double on = 0, off = 0;
};

LaidLine lay_line(Tiles& tiles, const NamedCurve& curve, const std::string& name, Envelope& envelope) {
    const std::vector<Vec3> points = points_to_look_up(tiles, curve.points);
    LaidLine laid;
    std::vector<Vec3> run{points.front()};
    int tile = tiles.at(points.front());
    for (std::size_t i = 1; i < points.size(); ++i) {
        const int next = tiles.at(points[i]);
        if (next != tile) {
            if (tile != nowhere) run.push_back(crossing_between(tiles, points[i - 1], points[i], tile));
            add_run(envelope, tile, run, name);
            run.clear();
            if (next != nowhere) run.push_back(crossing_between(tiles, points[i], points[i - 1], next));
        }
        (tile == nowhere || next == nowhere ? laid.off : laid.on) += (points[i] - points[i - 1]).norm();
        tile = next;
        run.push_back(points[i]);
    }
    add_run(envelope, tile, run, name);
    return laid;
}

std::string name_of(const NamedCurve& curve) {
    if (!curve.name.empty()) return curve.name;
    const auto layer = curve.attributes.find("layer");
    return layer != curve.attributes.end() ? layer->second : "line";
}

}  // namespace

std::vector<std::string> lay_lines(const CadModel& model, Envelope& envelope,
                                   const std::vector<std::string>& grain_layers) {
    Tiles tiles(envelope);
    std::vector<std::string> remarks;
    int off = 0;
    std::string first;
    for (const NamedCurve& curve : model.curves) {
        if (is_grain_line(curve, grain_layers)) continue;
        const std::string name = name_of(curve);
        const LaidLine laid = lay_line(tiles, curve, name, envelope);
        if (laid.on == 0) {
            if (off++ == 0) first = name;
        } else if (laid.off > worth_saying) {
            remarks.push_back("curve " + name + ": " + format_fixed(laid.off / millimetre, 0) +
                              " mm of it are more than 10 mm off every tile and left out");
        }
    }
    if (off == 1) remarks.push_back("curve " + first + " left out: it lies on no tile");
    if (off > 1)
        remarks.push_back(std::to_string(off) + " curves left out, the first is " + first + ": they lie on no tile");
    return remarks;
}

}  // namespace ripstop
