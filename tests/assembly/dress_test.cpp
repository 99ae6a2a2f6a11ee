/// A draped dress of 14 panels with known stitches: seams that were not designed for this program.
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "ripstop/assembly/seams/find_seams.h"
#include "ripstop/io/mesh/mesh_file.h"
#include "support/envelopes.h"
#include "support/shared_data.h"

namespace ripstop {
namespace dress_test {

using Json = nlohmann::json;

using Edges = std::set<std::pair<int, int>>;  // tile and boundary edge

/// Boundary edges, by tile and first vertex.
std::map<std::pair<int, int>, int> boundary_edges(const Envelope& envelope) {
    std::map<std::pair<int, int>, int> edges;
    for (int t = 0; t < static_cast<int>(envelope.tiles.size()); ++t) {
        const std::vector<int>& boundary = envelope.tiles[static_cast<std::size_t>(t)].boundary;
        for (int i = 0; i < static_cast<int>(boundary.size()); ++i)
            edges[{t, boundary[static_cast<std::size_t>(i)]}] = i;
    }
    return edges;
}

/// The boundary edges between consecutive vertices (tile, vertex), in either direction.
Edges edges_along(const Envelope& envelope, const std::vector<std::pair<int, int>>& vertices) {
    const std::map<std::pair<int, int>, int> from = boundary_edges(envelope);
    Edges edges;
    for (std::size_t k = 0; k + 1 < vertices.size(); ++k) {
        const auto v = from.find(vertices[k]), w = from.find(vertices[k + 1]);
        if (v == from.end() || w == from.end() || vertices[k].first != vertices[k + 1].first) continue;
        const int tile = vertices[k].first;
        const int count = static_cast<int>(envelope.tiles[static_cast<std::size_t>(tile)].boundary.size());
        if ((v->second + 1) % count == w->second) edges.insert({tile, v->second});
        if ((w->second + 1) % count == v->second) edges.insert({tile, w->second});
    }
    return edges;
}

/// The stitch lines of the dress: the edges of side a of each, and the edges of all sides together.
struct Stitches {
    std::vector<Edges> lines;
    Edges all;
};
Stitches stitches_of(const Json& file, const Envelope& envelope) {
    Stitches stitches;
    for (const Json& seam : file["seams"]) {
        std::vector<std::pair<int, int>> a, b;
        for (const Json& vertex : seam["a"]) a.emplace_back(vertex[0], vertex[1]);
        for (const Json& place : seam["b"]) {
            b.emplace_back(place[0], place[1]);
            b.emplace_back(place[2], place[3]);
        }
        stitches.lines.push_back(edges_along(envelope, a));
        for (const Edges& side : {stitches.lines.back(), edges_along(envelope, b)})
            stitches.all.insert(side.begin(), side.end());
    }
    return stitches;
}

/// How the seams that were found match the stitch lines.
struct Score {
    int whole = 0, in_part = 0, missed = 0, off_boundary = 0, invented = 0;
};
Score score(const Stitches& stitches, const FoundSeams& found) {
    Score score;
    Edges sewn;
    for (const Seam& seam : found.seams) {
        int stitched = 0, edges = 0;
        for (const SeamSide* side : {&seam.a, &seam.b})
            for (const SeamPart& part : side->parts) {
                sewn.insert({side->tile, part.edge});
                stitched += stitches.all.contains({side->tile, part.edge});
                ++edges;
            }
        score.invented += 2 * stitched < edges;
    }
    for (const Edges& line : stitches.lines) {
        std::size_t covered = 0;
        for (const auto& edge : line) covered += sewn.contains(edge);
        score.off_boundary += line.empty();
        score.whole += !line.empty() && covered == line.size();
        score.in_part += covered > 0 && covered < line.size();
        score.missed += !line.empty() && covered == 0;
    }
    return score;
}

TEST(Dress, HasItsStitchedSeamsFoundAndNoneInvented) {
    RIPSTOP_REQUIRE_SHARED(file, "dress/dress_knife_drape_3d.obj");
    RIPSTOP_REQUIRE_SHARED(stitch_file, "dress/dress_knife_seams.json");
    const Envelope envelope = testing::tiles_of(read_model(file).surfaces);
    std::ifstream in(stitch_file);
    const Stitches stitches = stitches_of(Json::parse(in), envelope);
    ASSERT_EQ(stitches.lines.size(), 94u);

    // Stitch lines 32, 33, 42 and 43 sew an edge into the middle of a panel, which the geometry of boundaries
    // cannot tell. The missed one is a single edge of 5 mm. Some are found in part: the cloth is folded by up to
    // 130 degrees per edge, so vertices of side b between two stitches of a are more than half a millimetre from
    // a's edge. Within 1 mm, more are found.
    const Score half = score(stitches, find_seams(envelope.tiles, {0.0005}));
    EXPECT_EQ(half.invented, 0);
    EXPECT_EQ(half.off_boundary, 4);
    EXPECT_GE(half.whole, 81);
    EXPECT_LE(half.missed, 1);
    const Score one = score(stitches, find_seams(envelope.tiles, {0.001}));
    EXPECT_EQ(one.invented, 0);
    EXPECT_GE(one.whole, 86);
    EXPECT_LE(one.missed, 2);
    std::printf("94 stitch lines: %d whole, %d in part, %d missed, %d off the boundary; within 1 mm: %d, %d, %d, %d\n",
                half.whole, half.in_part, half.missed, half.off_boundary, one.whole, one.in_part, one.missed,
                one.off_boundary);
}

TEST(Dress, LaidOutFlatHasNoSeams) {
    RIPSTOP_REQUIRE_SHARED(file, "dress/dress_knife_drape_flat_reference.obj");
    EXPECT_TRUE(find_seams(testing::tiles_of(read_model(file).surfaces).tiles).seams.empty());
}

}  // namespace dress_test
}  // namespace ripstop
