/// Prints the seams of a real dress as Markdown. For each of its 94 stitch lines: the mismatch (side b minus side
/// a) of its makers' own flat pattern, the mismatch that a walk of the seams finds on that pattern, and the one
/// after `seam-exact`; or why the stitch line is not found. Reads ../shared/data/dress.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "ripstop/base/text/units.h"
#include "ripstop/mesh/boundary.h"
#include "ripstop/pipeline/flatten/flatten_envelope.h"
#include "ripstop/pipeline/read/read_envelope.h"

namespace ripstop {
namespace {

using Vertex = std::array<int, 2>;          ///< panel, vertex in it
using Side = std::pair<std::size_t, bool>;  ///< a seam, and whether its side a is meant

/// The seams and boundary edges of an envelope, by the edges' ends.
class SeamsByEdge {
  public:
    explicit SeamsByEdge(const Envelope& envelope) {
        for (int t = 0; t < static_cast<int>(envelope.tiles.size()); ++t) {
            const std::vector<int> loop = closed(envelope.tiles[static_cast<std::size_t>(t)].boundary);
            for (std::size_t e = 0; e + 1 < loop.size(); ++e) boundary_.insert({{t, loop[e]}, {t, loop[e + 1]}});
        }
        for (std::size_t s = 0; s < envelope.seams.size(); ++s)
            for (const SeamSide* side : {&envelope.seams[s].a, &envelope.seams[s].b}) {
                const Side here{s, side == &envelope.seams[s].a};
                const std::vector<int> loop = closed(envelope.tiles[static_cast<std::size_t>(side->tile)].boundary);
                for (const SeamPart& part : side->parts) {
                    const auto e = static_cast<std::size_t>(part.edge);
                    seams_[{{side->tile, loop[e]}, {side->tile, loop[e + 1]}}].insert(here);
                }
            }
    }

    bool on_boundary(const Vertex& p, const Vertex& q) const {
        return boundary_.contains({p, q}) || boundary_.contains({q, p});
    }
    std::set<Side> of(const Vertex& p, const Vertex& q) const {
        for (const auto& key : {std::pair(p, q), std::pair(q, p)})
            if (const auto found = seams_.find(key); found != seams_.end()) return found->second;
        return {};
    }

  private:
    std::set<std::pair<Vertex, Vertex>> boundary_;
    std::map<std::pair<Vertex, Vertex>, std::set<Side>> seams_;
};

/// The length of the other sides of some seams minus that of the given sides.
double mismatch(const CutPlan& plan, const std::set<Side>& sides) {
    double sum = 0;
    for (const auto& [seam, is_a] : sides) sum += (is_a ? 1 : -1) * plan.walks[seam].mismatch();
    return sum;
}

void print(const nlohmann::json& stitch, const SeamsByEdge& edges, const CutPlan& given, const CutPlan& exact) {
    const auto vertices = stitch["a"].get<std::vector<Vertex>>();
    std::set<Side> seams;
    int inside = 0, missed = 0;
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
        if (!edges.on_boundary(vertices[i], vertices[i + 1])) ++inside;
        const std::set<Side> here = edges.of(vertices[i], vertices[i + 1]);
        missed += here.empty() ? 1 : 0;
        seams.insert(here.begin(), here.end());
    }
    double length = 0;
    for (const auto& [seam, is_a] : seams) length += given.seams[seam].length;
    const double drawn = stitch["draped_len_a"];
    std::string found = seams.size() == 1 ? std::string("yes") : fmt::format("as {} seams", seams.size());
    if (missed > 0) found = fmt::format("{} of {} edges not", missed, vertices.size() - 1);
    if (inside > 0) found = "sewn into the middle of a panel, not edge to edge";
    const bool whole = missed == 0 && inside == 0 && std::abs(length / drawn - 1) < 0.02;
    if (missed == 0 && inside == 0 && !whole) found += ", going on beyond it";
    const double published = stitch["flat_len_b"].get<double>() - stitch["flat_len_a"].get<double>();
    const auto figure = [&](const CutPlan& plan) {
        return whole ? fmt::format("{:+.3f}", std::round(1e3 * mismatch(plan, seams) / millimetre) / 1e3 + 0.0)
                     : std::string("-");
    };
    fmt::print("| {} | {} | {:.1f} | {} | {:+.3f} | {} | {} |\n", stitch["seam"].get<int>(), stitch["panel_a"].dump(),
               drawn / millimetre, found, published / millimetre, figure(given), figure(exact));
}

}  // namespace
}  // namespace ripstop

int main() {
    using namespace ripstop;
    const std::filesystem::path folder = "../shared/data/dress";
    if (!std::filesystem::exists(folder)) {
        fmt::print("{} is not here\n", folder.string());
        return 0;
    }
    const Envelope envelope = read_envelope(folder / "dress_knife_drape_3d.obj", {});
    const CutPlan given = flatten_envelope(envelope, {.method = "given"}), exact = flatten_envelope(envelope, {});
    std::ifstream in(folder / "dress_knife_seams.json");
    const SeamsByEdge edges(envelope);
    fmt::print(
        "| stitch | panel a | mm | found | published b - a, mm | walked on that pattern | after seam-exact |\n"
        "|---|---|---|---|---|---|---|\n");
    const auto published = nlohmann::json::parse(in);
    for (const auto& stitch : published["seams"]) print(stitch, edges, given, exact);
}
