#include "ripstop/assembly/faults/faults.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "ripstop/assembly/faults/loose_edges.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/base/union_find.h"
#include "ripstop/mesh/boundary.h"
#include "ripstop/tile/seam_sheets.h"

namespace ripstop {
namespace {

constexpr std::size_t shown_names = 6;
constexpr double slit = 0.003;  // as openness: a circle has 0.08, a square 0.06, the hole of a missing gore 0.008
constexpr double corner_on_cloth = 40 * degree;
constexpr double hole_corner_reach =
    4;  // in tolerances: how far from a corner of a hole the corners of its tiles may lie

std::string name_of(const std::vector<Tile>& tiles, int tile) {
    return tiles[at(tile)].name;
}

std::vector<std::string> names_of(const std::vector<Tile>& tiles, const std::vector<int>& members) {
    std::vector<std::string> names;
    for (const int tile : members) names.push_back(name_of(tiles, tile));
    return names;
}

/// Removes repeated names and keeps the order.
std::vector<std::string> each_once(std::vector<std::string> names) {
    std::vector<std::string> once;
    for (std::string& name : names)
        if (std::find(once.begin(), once.end(), name) == once.end()) once.push_back(std::move(name));
    return once;
}

double outline_length(const Tile& tile) {
    return edge_lengths(tile.mesh.positions, closed(tile.boundary)).sum();
}

/// The most specific description of edges that miss each other.
std::string what_is_wrong(const std::vector<const NearMiss*>& misses) {
    double open = 0, overlapping = 0;
    for (const NearMiss* miss : misses) (miss->overlap > 0 ? overlapping : open) += miss->length;
    if (overlapping == 0) return "close the gap";
    return open == 0 ? "there the tiles overlap; trim the overlap"
                     : "some overlap; close the gaps and trim the overlaps";
}

EnvelopeIssue gap_issue(const std::vector<Tile>& tiles, const std::vector<const NearMiss*>& misses, double tolerance) {
    const NearMiss& worst = **std::max_element(
        misses.begin(), misses.end(), [](const NearMiss* p, const NearMiss* q) { return p->distance < q->distance; });
    EnvelopeIssue issue{"gap", {}, {}, worst.place, worst.distance};
    double length = 0;
    std::set<std::pair<int, int>> pairs;
    for (const NearMiss* miss : misses) {
        length += miss->length;
        pairs.insert(std::minmax(miss->tile_a, miss->tile_b));
        issue.tiles.push_back(name_of(tiles, miss->tile_a));
        issue.tiles.push_back(name_of(tiles, miss->tile_b));
    }
    issue.tiles = each_once(issue.tiles);
    const std::string between =
        pairs.size() == 1 && worst.tile_a == worst.tile_b ? "two edges of tile " + name_of(tiles, worst.tile_a) + " lie"
        : pairs.size() == 1
            ? "tiles " + name_of(tiles, worst.tile_a) + " and " + name_of(tiles, worst.tile_b) + " lie"
            : "the edges of " + std::to_string(pairs.size()) + " pairs of tiles (" + names_text(issue.tiles) + ") lie";
    issue.message = between + " beside each other over " + length_text(length) + " but " + length_text(worst.distance) +
                    " apart at " + place_text(worst.place) + ", more than the seam tolerance of " +
                    length_text(tolerance) + ": they are not sewn; " + what_is_wrong(misses) +
                    ", or give a larger --seam-tolerance";
    return issue;
}

}  // namespace

std::string length_text(double length) {
    if (length < 0.1) return format_fixed(length / millimetre, length < 0.01 ? 2 : 1) + " mm";
    return format_fixed(length, 2) + " m";
}

std::string place_text(const Vec3& place) {
    return "(" + format_fixed(place.x(), 2) + ", " + format_fixed(place.y(), 2) + ", " + format_fixed(place.z(), 2) +
           ") m";
}

std::string names_text(const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), shown_names); ++i) text += (i ? ", " : "") + names[i];
    if (names.size() > shown_names) text += " and " + std::to_string(names.size() - shown_names) + " more";
    return text;
}

std::vector<int> sewn_groups(int tiles, const std::vector<Seam>& seams) {
    UnionFind groups(at(tiles));
    for (const Seam& seam : seams) groups.join(seam.a.tile, seam.b.tile);
    std::vector<int> number(static_cast<std::size_t>(tiles), -1);
    int count = 0;
    for (int t = 0; t < tiles; ++t) {
        int& first = number[at(groups.root(t))];
        if (first < 0) first = count++;
        number[at(t)] = first;
    }
    return number;
}

std::vector<EnvelopeIssue> name_gaps(const std::vector<Tile>& tiles, const FoundSeams& found, double tolerance) {
    const std::vector<NearMiss>& misses = found.near_misses;
    std::vector<std::vector<int>> near(tiles.size()), misses_of(tiles.size());  // a tile and its neighbours; its misses
    for (std::size_t t = 0; t < tiles.size(); ++t) near[t].push_back(static_cast<int>(t));
    for (const Seam& seam : found.seams) {
        near[at(seam.a.tile)].push_back(seam.b.tile);
        near[at(seam.b.tile)].push_back(seam.a.tile);
    }
    for (std::size_t i = 0; i < misses.size(); ++i) {
        misses_of[at(misses[i].tile_a)].push_back(static_cast<int>(i));
        misses_of[at(misses[i].tile_b)].push_back(static_cast<int>(i));
    }
    UnionFind groups(misses.size());
    for (std::size_t i = 0; i < misses.size(); ++i) {
        const std::vector<int>& beside = near[at(misses[i].tile_b)];
        for (const int tile : near[at(misses[i].tile_a)])
            for (const int j : misses_of[at(tile)]) {
                const NearMiss& other = misses[at(j)];
                const int across = other.tile_a == tile ? other.tile_b : other.tile_a;
                if (std::find(beside.begin(), beside.end(), across) != beside.end())
                    groups.join(static_cast<int>(i), j);
            }
    }
    std::map<int, std::vector<const NearMiss*>> together;
    for (std::size_t i = 0; i < misses.size(); ++i) together[groups.root(static_cast<int>(i))].push_back(&misses[i]);
    std::vector<EnvelopeIssue> issues;
    for (const auto& [first, members] : together) issues.push_back(gap_issue(tiles, members, tolerance));
    return issues;
}

namespace {

bool passes_a_miss(const LooseLoop& loop, const std::vector<NearMiss>& misses) {
    const auto passes = [&](int tile) {
        return std::find(loop.tiles.begin(), loop.tiles.end(), tile) != loop.tiles.end();
    };
    return std::any_of(misses.begin(), misses.end(),
                       [&](const NearMiss& miss) { return passes(miss.tile_a) && passes(miss.tile_b); });
}

/// The tiles of the skin. Further sheets are left out, because their loose edges lie around the openings of the
/// skin.
std::vector<Tile> skin_without_sheets(const std::vector<Tile>& tiles, const std::vector<Seam>& seams,
                                      std::vector<int>& numbers) {
    const std::vector<char> is_inner = find_inner_sheets(static_cast<int>(tiles.size()), seams);
    std::vector<Tile> skin;
    for (std::size_t t = 0; t < tiles.size(); ++t) {
        if (is_inner[t] != 0) continue;
        skin.push_back(tiles[t]);
        numbers.push_back(static_cast<int>(t));
    }
    return skin;
}

/// True for the end of a tube or a tent: it passes every tile of the skin once. The hole of a missing tile passes
/// some of them, the hole of a missing gore passes each twice.
bool goes_round_all(const LooseLoop& loop, std::vector<int> skin) {
    std::vector<int> passed = loop.tiles;
    std::sort(passed.begin(), passed.end());
    std::sort(skin.begin(), skin.end());
    return passed == skin;
}

}  // namespace

std::vector<EnvelopeIssue> name_holes(const std::vector<Tile>& tiles, const FoundSeams& found, double tolerance) {
    if (found.seams.empty()) return {};
    std::vector<double> outlines;
    for (const Tile& tile : tiles) outlines.push_back(outline_length(tile));
    const auto longest = std::max_element(outlines.begin(), outlines.end());
    std::vector<int> numbers;
    const std::vector<Tile> skin = skin_without_sheets(tiles, found.seams, numbers);
    std::vector<EnvelopeIssue> issues;
    std::vector<std::vector<Vec3>> corners;
    const std::vector<LooseLoop> loops =
        find_loops(tiles, place_chains(tiles), found.loose, tolerance, nullptr, &corners);
    for (std::size_t l = 0; l < loops.size(); ++l) {
        const LooseLoop& loop = loops[l];
        if (!loop.closed || loop.outline || loop.openness < slit || loop.corners < 2) continue;
        if (passes_a_miss(loop, found.near_misses)) continue;  // its corners are where the gap begins
        if (goes_round_all(loop, numbers)) continue;
        const auto on_cloth = std::count_if(corners[l].begin(), corners[l].end(), [&](const Vec3& corner) {
            return std::abs(turn_on_cloth(skin, corner, hole_corner_reach * tolerance)) > corner_on_cloth;
        });
        if (on_cloth < 2) continue;  // the rim of a tube with flat sides
        const std::vector<std::string> around = each_once(names_of(tiles, loop.tiles));
        const bool lobed = loop.corners > 8 && loop.corners >= static_cast<int>(loop.tiles.size());
        if (lobed) continue;  // a mouth or crown of lobes, with a corner between neighbouring tiles
        const bool at_an_edge = static_cast<int>(around.size()) > 2 * loop.corners;
        const bool several = loop.corners > 4 || loop.length > 1.5 * *longest;
        EnvelopeIssue issue{"missing_tile", {}, around, loop.centre, 0};
        if (at_an_edge)
            issue.fact = "a tile may be missing at the open edge round " + place_text(loop.centre) + ": it has " +
                         std::to_string(loop.corners) + " corners, whereas a mouth or crown has none; it runs along " +
                         names_text(around);
        else
            issue.fact = (several ? "one or more tiles are missing at " : "a tile is missing at ") +
                         place_text(loop.centre) + ": the loose edges of " + names_text(around) +
                         " go round a hole of " + std::to_string(loop.corners) + " corners and " +
                         length_text(loop.length) + " of edge";
        issue.message = issue.fact + "; add " + (several && !at_an_edge ? "them" : "the tile") +
                        "; if the opening is intended, give --accept missing_tile";
        issues.push_back(std::move(issue));
    }
    return issues;
}

namespace {

EnvelopeIssue unsewn_issue(std::size_t tiles, bool sewn_as_given) {
    EnvelopeIssue issue{"unsewn", {}, {}, Vec3::Zero(), 0};
    issue.fact = "no two of the " + std::to_string(tiles) + " tiles have an edge in common" +
                 (sewn_as_given ? " after the faults are corrected" : ": there are no seams");
    issue.message = issue.fact +
                    "; if they are to be sewn, place them in space as they meet, not laid out flat, or give a larger "
                    "--seam-tolerance";
    return issue;
}

/// One issue for all groups that are apart: a vent, pockets, a second envelope in the file.
EnvelopeIssue apart_issue(const std::vector<Tile>& tiles, const std::vector<std::vector<int>>& parts) {
    std::vector<int> members;
    for (const std::vector<int>& part : parts) members.insert(members.end(), part.begin(), part.end());
    const Vec3 at = centroid(tiles[static_cast<std::size_t>(members.front())].mesh);
    EnvelopeIssue issue{"apart", {}, names_of(tiles, members), at, 0};
    const std::string count = std::to_string(members.size()), names = names_text(issue.tiles);
    if (members.size() == 1)
        issue.fact = "tile " + names + " at " + place_text(at) + " is sewn to nothing";
    else if (parts.size() == 1)
        issue.fact = count + " tiles (" + names + ") are sewn to one another but to nothing else";
    else
        issue.fact = count + " tiles (" + names + ") are in " + std::to_string(parts.size()) +
                     " parts that are sewn to nothing else";
    issue.message = issue.fact + "; if that is not intended, move " +
                    (members.size() == 1 ? "it to its place" : "them to their place");
    return issue;
}

}  // namespace

std::vector<EnvelopeIssue> name_strays(const std::vector<Tile>& tiles, const FoundSeams& found, bool sewn_as_given) {
    const int count = static_cast<int>(tiles.size());
    if (count < 2) return {};
    if (found.seams.empty() && found.near_misses.empty()) return {unsewn_issue(tiles.size(), sewn_as_given)};
    const std::vector<int> group = sewn_groups(count, found.seams);
    std::vector<std::vector<int>> members(static_cast<std::size_t>(*std::max_element(group.begin(), group.end()) + 1));
    for (int t = 0; t < count; ++t) members[at(group[at(t)])].push_back(t);
    const auto largest = std::max_element(members.begin(), members.end(),
                                          [](const auto& p, const auto& q) { return p.size() < q.size(); });
    UnionFind near(tiles.size());  // groups that a gap already names are not reported again
    for (const NearMiss& miss : found.near_misses) near.join(miss.tile_a, miss.tile_b);
    for (const Seam& seam : found.seams) near.join(seam.a.tile, seam.b.tile);
    std::vector<std::vector<int>> parts;
    for (const std::vector<int>& some : members)
        if (&some != &*largest && near.root(some.front()) != near.root(largest->front())) parts.push_back(some);
    if (parts.empty()) return {};
    return {apart_issue(tiles, parts)};
}

}  // namespace ripstop
