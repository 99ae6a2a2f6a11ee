#include "borders.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepLProp_CLProps.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace ripstop::cad {
namespace {

constexpr int samples = 96;
constexpr int fewest_of_closed = 6, fewest_of_bent = 3, fewest_spokes = 5;
constexpr double mismatch = 5e-3;               // of edges that meet, relative to the face's extent in u and v
constexpr double straight_enough = 0.8;         // ratio of the distance between its ends to its length
constexpr double spoke = std::numbers::pi / 3;  // angle between neighbouring edges at a pole

Vec3 vec(const gp_Pnt& p) {
    return {p.X(), p.Y(), p.Z()};
}

/// The place of an edge in u and v of a face, by the parameter of its curve in space.
class OnFace {
  public:
    OnFace(const TopoDS_Edge& edge, const TopoDS_Face& face) {
        BRep_Tool::Range(edge, first_, last_);
        curve_ = BRep_Tool::CurveOnSurface(edge, face, first_on_, last_on_);
    }
    bool is_known() const { return !curve_.IsNull(); }
    Vec2 at(double parameter) const {
        const double share = last_ > first_ ? (parameter - first_) / (last_ - first_) : 0;
        const gp_Pnt2d p = curve_->Value(first_on_ + share * (last_on_ - first_on_));
        return {p.X(), p.Y()};
    }
    double first() const { return first_; }
    double last() const { return last_; }

  private:
    Handle(Geom2d_Curve) curve_;
    double first_ = 0, last_ = 1, first_on_ = 0, last_on_ = 1;
};

/// Parameters that divide a curve into pieces with equal shares of `density`, which is 1 per length asked for.
std::vector<double> shares(const std::vector<double>& parameters, const std::vector<double>& lengths,
                           const std::vector<double>& densities, int fewest) {
    std::vector<double> sums{0};
    for (std::size_t i = 0; i < lengths.size(); ++i)
        sums.push_back(sums.back() + lengths[i] * (densities[i] + densities[i + 1]) / 2);
    const int pieces = std::max(fewest, static_cast<int>(std::ceil(sums.back() - 1e-3)));
    std::vector<double> result{parameters.front()};
    std::size_t i = 0;
    for (int n = 1; n < pieces; ++n) {
        const double wanted = sums.back() * n / pieces;
        while (i + 2 < sums.size() && sums[i + 1] < wanted) ++i;
        const double share = sums[i + 1] > sums[i] ? (wanted - sums[i]) / (sums[i + 1] - sums[i]) : 0.5;
        result.push_back(parameters[i] + std::clamp(share, 0.0, 1.0) * (parameters[i + 1] - parameters[i]));
    }
    result.push_back(parameters.back());
    return result;
}

/// The number of straight pieces for a pole in u and v, chosen so that the edges at it spread evenly.
int pieces_of_pole(const TopoDS_Face& face, const Vec2& from, const Vec2& to, const FaceSizes& sizes) {
    const BRepAdaptor_Surface surface(face);
    const Vec2 along = to - from;
    const Vec2 size = sizes.high() - sizes.low();
    Vec2 inward(-along[1] / size[1], along[0] / size[0]);  // to the left, in shares of the face's extent
    if (inward.norm() == 0) return 1;
    inward = inward.normalized().cwiseProduct(size) * 0.02;
    const Vec3 pole = vec(surface.Value(from[0], from[1]));
    double angle = 0;
    constexpr int steps = 24;
    Vec3 first(0, 0, 0), last(0, 0, 0);
    for (int i = 0; i <= steps; ++i) {
        const Vec2 uv = from + along * i / steps + inward;
        const Vec3 ray = vec(surface.Value(std::clamp(uv[0], sizes.low()[0], sizes.high()[0]),
                                           std::clamp(uv[1], sizes.low()[1], sizes.high()[1]))) -
                         pole;
        if (ray.norm() == 0) return 1;
        if (i > 0) angle += (ray.normalized() - last).norm();
        last = ray.normalized();
        if (i == 0) first = last;
    }
    const bool all_around = (last - first).norm() < 0.01 * angle;
    return std::max(all_around ? fewest_spokes : 1, static_cast<int>(std::lround(angle / spoke)));
}

/// Joins lines of edges into loops. Each continues with the line that starts at the same vertex, closest to its
/// end in u and v: an edge that is sewn to itself occurs twice, in different places.
std::vector<BorderLoop> chained(std::vector<BorderLoop> lines, const FaceSizes& sizes) {
    const Vec2 size = sizes.high() - sizes.low();
    const auto gap = [&size](const BorderNode& a, const BorderNode& b) {
        return a.vertex == b.vertex ? (b.uv - a.uv).cwiseQuotient(size).norm()
                                    : std::numeric_limits<double>::infinity();
    };
    std::vector<BorderLoop> loops;
    while (!lines.empty()) {
        BorderLoop loop = std::move(lines.front());
        lines.erase(lines.begin());
        for (;;) {
            double nearest = gap(loop.back(), loop.front());
            std::size_t next = lines.size();
            for (std::size_t i = 0; i < lines.size(); ++i)
                if (const double here = gap(loop.back(), lines[i].front()); here < nearest) {
                    nearest = here;
                    next = i;
                }
            if (next == lines.size()) break;
            loop.insert(loop.end(), lines[next].begin(), lines[next].end());
            lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(next));
        }
        loops.push_back(std::move(loop));
    }
    return loops;
}

/// Closes a loop where one edge ends and the next begins. If both ends coincide in u and v, they become one node.
/// If they coincide in space only, they are a pole, which gets pieces of its own.
std::optional<BorderLoop> closed(const BorderLoop& all, const TopoDS_Face& face, const FaceSizes& sizes) {
    const Vec2 size = sizes.high() - sizes.low();
    BorderLoop loop;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const BorderNode &here = all[i], &after = all[(i + 1) % all.size()];
        loop.push_back(here);
        if (here.vertex != after.vertex) {
            if (i + 1 == all.size()) return {};
            continue;
        }
        if ((after.uv - here.uv).cwiseQuotient(size).norm() < mismatch) {
            loop.pop_back();
            continue;
        }
        const BRepAdaptor_Surface surface(face);
        const Vec2 middle = (here.uv + after.uv) / 2;
        const double away =
            (vec(surface.Value(middle[0], middle[1])) - vec(surface.Value(here.uv[0], here.uv[1]))).norm();
        if (away > 1e-4 * size.cwiseProduct(sizes.stretch()).norm()) return {};
        loop.back().pole = true;
        const int pieces = pieces_of_pole(face, here.uv, after.uv, sizes);
        for (int n = 1; n < pieces; ++n)
            loop.push_back({here.uv + (after.uv - here.uv) * n / pieces, here.vertex, true});
    }
    for (std::size_t i = 0; i < loop.size(); ++i)
        if (loop[i].vertex == loop[(i + 1) % loop.size()].vertex)
            loop[i].pole = loop[(i + 1) % loop.size()].pole = true;
    if (loop.size() < 3) return {};
    return loop;
}

}  // namespace

Borders::Borders(const std::vector<TopoDS_Face>& faces, const std::vector<std::optional<FaceSizes>>& sizes,
                 const EdgeSizes& asked, const std::vector<double>& finer) {
    std::vector<std::vector<std::size_t>> around;
    for (std::size_t f = 0; f < faces.size(); ++f)
        for (TopExp_Explorer explorer(faces[f], TopAbs_EDGE); !faces[f].IsNull() && explorer.More(); explorer.Next()) {
            const std::size_t i = static_cast<std::size_t>(edges_.Add(explorer.Current())) - 1;
            if (i == around.size()) around.emplace_back();
            if (around[i].empty() || around[i].back() != f) around[i].push_back(f);
        }
    for (std::size_t i = 0; i < around.size(); ++i)
        divide(TopoDS::Edge(edges_(static_cast<int>(i) + 1)), around[i], faces, sizes, asked, finer);
}

int Borders::vertex(const TopoDS_Shape& shape) {
    const std::size_t i = static_cast<std::size_t>(corners_.Add(shape)) - 1;
    if (i == corner_vertices_.size()) {
        corner_vertices_.push_back(static_cast<int>(points_.size()));
        points_.push_back(vec(BRep_Tool::Pnt(TopoDS::Vertex(shape))));
    }
    return corner_vertices_[i];
}

void Borders::divide(const TopoDS_Edge& any, const std::vector<std::size_t>& around,
                     const std::vector<TopoDS_Face>& faces, const std::vector<std::optional<FaceSizes>>& sizes,
                     const EdgeSizes& asked, const std::vector<double>& finer) {
    const TopoDS_Edge edge = TopoDS::Edge(any.Oriented(TopAbs_FORWARD));
    Divided& result = divided_.emplace_back();
    TopoDS_Vertex from, to;
    TopExp::Vertices(edge, from, to);
    if (from.IsNull() || to.IsNull()) return;
    double first = 0, last = 0;
    BRep_Tool::Range(edge, first, last);
    if (BRep_Tool::Degenerated(edge)) {
        result = {{first, last}, {vertex(from), vertex(to)}};
        return;
    }
    const BRepAdaptor_Curve curve(edge);
    std::vector<double> parameters, lengths, densities;
    std::vector<OnFace> places;
    double scale = asked.border;
    for (const std::size_t f : around) {
        places.emplace_back(edge, faces[f]);
        if (!finer.empty()) scale = std::min(scale, asked.border * finer[f]);
    }
    gp_Pnt before;
    for (int i = 0; i <= samples; ++i) {
        const double t = first + (last - first) * i / samples;
        BRepLProp_CLProps properties(curve, t, 2, 1e-9);
        const double bend = properties.IsTangentDefined() ? properties.Curvature() : 0;
        double size = asked.at(bend);
        for (std::size_t k = 0; k < around.size(); ++k)
            if (places[k].is_known()) size = std::min(size, sizes[around[k]]->at(places[k].at(t)));
        parameters.push_back(t);
        densities.push_back(1 / (scale * size));
        const gp_Pnt here = curve.Value(t);
        if (i > 0) lengths.push_back(before.Distance(here));
        before = here;
    }
    const double length = std::accumulate(lengths.begin(), lengths.end(), 0.0);
    const bool bent = BRep_Tool::Pnt(from).Distance(BRep_Tool::Pnt(to)) < straight_enough * length;
    result.parameters =
        shares(parameters, lengths, densities, from.IsSame(to) ? fewest_of_closed : (bent ? fewest_of_bent : 1));
    result.vertices.push_back(vertex(from));
    for (std::size_t i = 1; i + 1 < result.parameters.size(); ++i) {
        result.vertices.push_back(static_cast<int>(points_.size()));
        points_.push_back(vec(curve.Value(result.parameters[i])));
    }
    result.vertices.push_back(vertex(to));
}

bool Borders::add_edge(const TopoDS_Edge& edge, const TopoDS_Face& face, BorderLoop& loop) const {
    const int found = edges_.FindIndex(edge);
    const OnFace place(edge, face);
    if (found == 0 || !place.is_known()) return false;
    const Divided& divided = divided_[static_cast<std::size_t>(found) - 1];
    const std::size_t count = divided.parameters.size();
    if (count < 2) return false;
    const bool backward = edge.Orientation() == TopAbs_REVERSED;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t n = backward ? count - 1 - i : i;
        loop.push_back({place.at(divided.parameters[n]), divided.vertices[n]});
    }
    return true;
}

double Borders::pieces(const TopoDS_Face& face) const {
    double sum = 0;
    for (TopExp_Explorer explorer(face, TopAbs_EDGE); explorer.More(); explorer.Next())
        if (const int found = edges_.FindIndex(explorer.Current()); found > 0)
            sum +=
                std::max(0.0, static_cast<double>(divided_[static_cast<std::size_t>(found) - 1].vertices.size()) - 1);
    return sum;
}

double Borders::pieces() const {
    double sum = 0;
    for (const Divided& edge : divided_) sum += std::max(0.0, static_cast<double>(edge.vertices.size()) - 1);
    return sum;
}

std::optional<std::vector<BorderLoop>> Borders::loops(const TopoDS_Face& any, const FaceSizes& sizes) const {
    const TopoDS_Face face = TopoDS::Face(any.Oriented(TopAbs_FORWARD));
    std::vector<BorderLoop> lines;
    for (TopoDS_Iterator wires(face); wires.More(); wires.Next())
        if (wires.Value().ShapeType() == TopAbs_WIRE)
            for (TopoDS_Iterator edges(wires.Value()); edges.More(); edges.Next()) {
                const TopAbs_Orientation way = edges.Value().Orientation();
                if (way != TopAbs_FORWARD && way != TopAbs_REVERSED) continue;
                if (!add_edge(TopoDS::Edge(edges.Value()), face, lines.emplace_back())) return {};
            }
    std::vector<BorderLoop> result;
    for (const BorderLoop& line : chained(std::move(lines), sizes)) {
        std::optional<BorderLoop> loop = closed(line, face, sizes);
        if (!loop) return {};
        result.push_back(std::move(*loop));
    }
    if (result.empty()) return {};
    return result;
}

}  // namespace ripstop::cad
