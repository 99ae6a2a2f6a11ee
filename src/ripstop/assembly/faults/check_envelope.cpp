#include "ripstop/assembly/faults/check_envelope.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "ripstop/assembly/faults/faults.h"
#include "ripstop/assembly/faults/loose_edges.h"
#include "ripstop/assembly/seams/seam_runs.h"
#include "ripstop/base/error.h"
#include "ripstop/base/index.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/tile/allowance.h"
#include "ripstop/tile/seam_sheets.h"

namespace ripstop {
namespace {

constexpr double length_tolerance = 0.001;  // the paper's tolerance on lengths: 1 mm per metre
constexpr double no_gap = 1e-6;             // [m] vertices in one place, up to the rounding of a file
constexpr std::size_t most_misses = 8;      // if there are more near misses, and more than seams, the tolerance is
                                            // wrong

Vec3 size_of(const std::vector<Tile>& tiles) {
    Eigen::AlignedBox3d box;
    for (const Tile& tile : tiles)
        for (Eigen::Index v = 0; v < tile.mesh.positions.rows(); ++v) box.extend(Vec3(tile.mesh.positions.row(v)));
    return box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(box.sizes());
}

/// Reports a wrong unit, which makes tolerances meaningless; returns true then. A doubtful unit is only a note.
bool names_unit(const std::vector<Tile>& tiles, const UnitRead& read, EnvelopeCheck& check) {
    std::vector<Eigen::AlignedBox3d> boxes;
    for (const Tile& tile : tiles) boxes.push_back(box_of(tile.mesh));
    const std::optional<UnitDoubt> doubt = doubt_unit(boxes, read);
    if (!doubt) return false;
    if (doubt->is_wrong)
        check.issues.push_back(unit_issue(*doubt));
    else
        check.notes.push_back(doubt->sentence);
    return doubt->is_wrong;
}

/// True for a seam within one tile that has no gap and ends where its two sides come together.
bool is_crack(const std::vector<Tile>& tiles, const Seam& seam) {
    if (seam.a.tile != seam.b.tile || seam.gap > no_gap) return false;
    const auto count = static_cast<int>(tiles[at(seam.a.tile)].boundary.size());
    const auto meet = [count](const SeamSide& before, const SeamSide& after) {
        return (before.parts.back().edge + 1) % count == after.parts.front().edge;
    };
    return meet(seam.a, seam.b) || meet(seam.b, seam.a);
}

/// Notes closed darts and vertices that nobody welded. The file does not tell which of the two they are.
void note_cracks(const std::vector<Tile>& tiles, const std::vector<Seam>& seams, EnvelopeCheck& check) {
    int cracks = 0;
    std::vector<std::string> names;
    for (const Seam& seam : seams) {
        if (!is_crack(tiles, seam)) continue;
        ++cracks;
        const std::string& name = tiles[at(seam.a.tile)].name;
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    if (cracks == 0) return;
    check.notes.push_back(std::to_string(cracks) +
                          (cracks == 1 ? " seam within a tile is a crack" : " seams within tiles are cracks") +
                          " with no gap (" + names_text(names) +
                          "): sewn as a closed dart; if no dart is intended, weld the vertices there in the CAD");
}

/// Adds notes on what is worth a look but may be right.
void add_notes(EnvelopeCheck& check) {
    const auto worst =
        std::max_element(check.sampling.begin(), check.sampling.end(),
                         [](const SeamSampling& p, const SeamSampling& q) { return p.chord_error < q.chord_error; });
    if (worst != check.sampling.end() && worst->chord_error > length_tolerance)
        check.notes.push_back("edges turn by up to " + format_fixed(worst->turn / degree, 1) + " degrees (seam " +
                              worst->id + "), so that the mesh is short by " +
                              format_fixed(worst->chord_error / millimetre, 2) +
                              " mm/m there, more than the tolerance of a seam; where neighbours are meshed separately, "
                              "lengths are measured on smooth curves, and a finer mesh makes them certain");
    if (check.odd_corners > 0)
        check.notes.push_back(
            "odd corners lie within one neighbour's edge, where nothing else meets; if they are not "
            "corners, give the right ones in the project file");
    if (check.loose_ends > 0)
        check.notes.push_back(
            "a loose end is where an open edge stops at other edges without continuing along one; look for "
            "edges that do not fit");
}

/// Which tiles are sewn into which seams, where more than two tiles meet on an edge.
std::string further_sheets_text(const std::vector<Tile>& tiles, const std::vector<Seam>& seams) {
    const auto name = [&](const SeamSheet& sheet) { return tiles[at(sheet.side->tile)].name; };
    std::vector<std::string> edges, first;
    for (const std::vector<SeamSheet>& sheets : sheets_of_seams(seams)) {
        if (sheets.size() < 3) continue;
        const std::string skin = name(sheets[0]) + " and " + name(sheets[1]);
        std::string others;
        for (std::size_t k = 2; k < sheets.size(); ++k)
            others += (k == 2 ? "" : k + 1 == sheets.size() ? " and " : ", ") + name(sheets[k]);
        edges.push_back(others + " into that of " + skin);
        constexpr std::array numbers{"three", "four", "five", "six"};
        const std::string count =
            sheets.size() - 3 < numbers.size() ? numbers[sheets.size() - 3] : std::to_string(sheets.size());
        first = {count + " tiles meet on this edge: " + skin + " are sewn, " + others +
                 (sheets.size() > 3 ? " are" : " is") + " sewn into their seam"};
    }
    if (edges.size() == 1) return first.front();
    return "three or more tiles meet on " + std::to_string(edges.size()) +
           " edges: two are sewn there, the others are sewn into their seam: " + names_text(edges);
}

/// The tiles without those that have the same surroundings on both sides, because it does not matter which side of
/// them is up.
std::vector<Tile> skin_of(const std::vector<Tile>& tiles, const std::vector<Seam>& seams) {
    const std::vector<char> is_inner = find_inner_sheets(static_cast<int>(tiles.size()), seams);
    std::vector<Tile> skin;
    for (std::size_t t = 0; t < tiles.size(); ++t)
        if (!is_inner[t]) skin.push_back(tiles[t]);
    return skin;
}

/// How finely a seam is meshed: edges per metre of seam, on its coarser side, from the lengths of its parts.
SeamSampling sampling_of(const std::vector<PlacedChain>& chains, const Seam& seam) {
    SeamSampling sampling{seam.id, seam.length, 0, 0};
    for (const SeamSide* side : {&seam.a, &seam.b}) {
        const auto placed = std::lower_bound(chains.begin(), chains.end(), std::pair(side->tile, side->chain),
                                             [](const PlacedChain& chain, const std::pair<int, int>& at) {
                                                 return std::pair(chain.tile, chain.chain) < at;
                                             });
        for (const SeamPart& part : side->parts) {
            const int local = (part.edge - placed->first_edge + placed->boundary_edges) % placed->boundary_edges;
            sampling.turn = std::max({sampling.turn, turn_of_edge(placed->curve, local), placed->curve.unseen_turn});
        }
    }
    sampling.chord_error = sampling.turn * sampling.turn / 24;
    return sampling;
}

/// The number of superfluous corners. There, both chains of the tile are sewn to one chain of one neighbour, edge
/// by edge, and no other seam ends.
int count_odd_corners(const std::vector<Tile>& tiles, const std::vector<Seam>& seams) {
    struct End {
        int tile, chain, edge;
    };
    std::map<std::pair<int, int>, End> first, last;  // by boundary edge of a tile: its mate at the edge's end
    const auto add = [&](const SeamSide& side, const SeamSide& mate) {
        first[{side.tile, side.parts.front().edge}] = {mate.tile, mate.chain, mate.parts.back().edge};
        last[{side.tile, side.parts.back().edge}] = {mate.tile, mate.chain, mate.parts.front().edge};
    };
    for (const Seam& seam : seams) {
        if (seam.into) continue;
        add(seam.a, seam.b);
        add(seam.b, seam.a);
    }
    int odd = 0;
    for (std::size_t t = 0; t < tiles.size(); ++t) {
        const Tile& tile = tiles[t];
        const int count = static_cast<int>(tile.boundary.size());
        if (tile.chains.size() < 2) continue;
        int edge = static_cast<int>(
            std::find(tile.boundary.begin(), tile.boundary.end(), tile.chains.front().vertices.front()) -
            tile.boundary.begin());
        for (const Chain& chain : tile.chains) {
            const auto before = last.find({static_cast<int>(t), (edge + count - 1) % count});
            const auto after = first.find({static_cast<int>(t), edge});
            edge = (edge + chain.edge_count()) % count;
            if (before == last.end() || after == first.end()) continue;
            const End &p = before->second, &q = after->second;
            if (p.tile != q.tile || p.chain != q.chain || p.tile == static_cast<int>(t)) continue;
            const int mate_count = static_cast<int>(tiles[at(p.tile)].boundary.size());
            odd += p.edge == q.edge || (q.edge + 1) % mate_count == p.edge;
        }
    }
    return odd;
}

/// The number of ends of seams that lie within a chain of one side.
int count_t_junctions(const std::vector<Tile>& tiles, const std::vector<Seam>& seams) {
    std::map<std::pair<int, int>, int> seams_on;
    for (const Seam& seam : seams)
        for (const SeamSide* side : seam.own_sides()) ++seams_on[{side->tile, side->chain}];
    int junctions = 0;
    for (const auto& [chain, count] : seams_on) {
        const Tile& tile = tiles[at(chain.first)];
        const bool loop = tile.chains.size() == 1;
        junctions += loop ? (count > 1 ? count : 0) : count - 1;
    }
    return junctions;
}

std::vector<std::string> grains_of(const std::vector<Tile>& tiles) {
    std::map<std::string, int> counts;
    for (const Tile& tile : tiles) ++counts[tile.grain.source];
    std::vector<std::string> texts;
    for (const auto& [source, count] : counts)
        texts.push_back(source + " (" + std::to_string(count) + (count == 1 ? " tile)" : " tiles)"));
    return texts;
}

EnvelopeCheck figures_of_tiles(const Envelope& envelope, const SeamOptions& options) {
    EnvelopeCheck check;
    check.tiles = static_cast<int>(envelope.tiles.size());
    check.parts = check.tiles;  // until seams are known
    check.seam_tolerance = options.tolerance;
    check.size = size_of(envelope.tiles);
    check.grain_sources = grains_of(envelope.tiles);
    for (const Tile& tile : envelope.tiles) {
        check.area += surface_area(tile.mesh);
        check.triangles += tile.mesh.triangle_count();
        check.chains += static_cast<int>(tile.chains.size());
        if (tile.chains.size() > 1 || tile.chains.front().vertices.front() != tile.boundary.front())
            check.corners += static_cast<int>(tile.chains.size());
    }
    return check;
}

void add_figures_of_seams(const Envelope& envelope, const FoundSeams& found, EnvelopeCheck& check) {
    const std::vector<PlacedChain> chains = place_chains(envelope.tiles);
    check.seams = static_cast<int>(found.seams.size());
    for (const Seam& seam : found.seams) {
        check.self_seams += seam.a.tile == seam.b.tile;
        check.sewn_in += seam.into.has_value();
        if (!seam.into) check.seam_length += seam.length;  // counts a seam of three sheets once
        check.gap_max = std::max(check.gap_max, seam.gap);
        check.sampling.push_back(sampling_of(chains, seam));
    }
    check.parts = 0;
    for (const int group : sewn_groups(check.tiles, found.seams)) check.parts = std::max(check.parts, group + 1);
    check.odd_corners = count_odd_corners(envelope.tiles, found.seams);
    check.t_junctions = count_t_junctions(envelope.tiles, found.seams);
    check.loops = find_loops(envelope.tiles, chains, found.loose, check.seam_tolerance);
    for (const LooseLoop& loop : check.loops) check.loose_ends += loop.closed ? 0 : 2;
}

/// The figures of the seams as the envelope stands, although its unit is in doubt: the designer may want just that
/// size.
void add_figures_if_any(const Envelope& envelope, const SeamOptions& options, EnvelopeCheck& check) {
    try {
        add_figures_of_seams(envelope, find_seams(envelope.tiles, options), check);
        check.seam_types = seam_types_used(envelope);
    } catch (const InputError&) {  // the tiles are too small, and the unit issue already says so
        check.seams_sought = false;
    }
}

void add(std::vector<EnvelopeIssue>& issues, std::vector<EnvelopeIssue> more) {
    issues.insert(issues.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

/// One issue instead of one per tile, if most edges miss their mates.
EnvelopeIssue tolerance_issue(const FoundSeams& found, const SeamOptions& options) {
    std::vector<double> distances;
    for (const NearMiss& miss : found.near_misses) distances.push_back(miss.distance);
    std::sort(distances.begin(), distances.end());
    const double median = distances[distances.size() / 2], most = distances[distances.size() * 9 / 10];
    return {"gap",
            std::to_string(distances.size()) +
                " pairs of edges run beside each other, but farther apart than the seam tolerance of " +
                length_text(options.tolerance) + " (half of them more than " + length_text(median) +
                " apart), compared with " + std::to_string(found.seams.size()) + " seams; give --seam-tolerance " +
                format_fixed(std::ceil(12 * most / millimetre) / 10, 1) + "mm if they are to be sewn",
            {},
            found.near_misses.front().place,
            median};
}

}  // namespace

EnvelopeIssue unit_issue(const UnitDoubt& doubt) {
    return {"unit", doubt.sentence, {}, Vec3::Zero(), doubt.size, doubt.limit};
}

EnvelopeCheck check_envelope(const Envelope& envelope, const SeamOptions& options, const UnitRead& unit) {
    EnvelopeCheck check = figures_of_tiles(envelope, options);
    if (names_unit(envelope.tiles, unit, check)) {
        add_figures_if_any(envelope, options, check);
        return check;
    }
    const FoundSeams as_given = find_seams(envelope.tiles, options);
    add_figures_of_seams(envelope, as_given, check);
    check.seam_types = seam_types_used(envelope);
    add_notes(check);
    note_cracks(envelope.tiles, as_given.seams, check);

    std::vector<Tile> tiles = envelope.tiles;
    add(check.issues, remove_doubled(tiles, options.tolerance));
    const bool doubled = tiles.size() < envelope.tiles.size();
    FoundSeams found = doubled ? find_seams(tiles, options) : as_given;
    std::vector<EnvelopeIssue> turned = turn_back(tiles, found);
    if (!turned.empty()) found = find_seams(tiles, options);
    add(check.issues, std::move(turned));
    add(check.issues, name_inside_out(skin_of(tiles, found.seams),
                                      find_loops(tiles, place_chains(tiles), found.loose, options.tolerance)));
    if (found.near_misses.size() >= most_misses && found.near_misses.size() > found.seams.size()) {
        check.issues.push_back(tolerance_issue(found, options));
        return check;
    }
    add(check.issues, move_back(tiles, found, options));
    add(check.issues, name_gaps(tiles, found, options.tolerance));
    add(check.issues, name_holes(tiles, found, options.tolerance));
    check.meant = name_strays(tiles, found, check.seams > 0);
    for (const EnvelopeIssue& issue : check.meant) check.notes.push_back(issue.message);
    if (std::any_of(found.seams.begin(), found.seams.end(), [](const Seam& seam) { return seam.into.has_value(); }))
        check.notes.push_back(further_sheets_text(tiles, found.seams));
    return check;
}

std::vector<FabricUse> count_fabrics(const Envelope& envelope, const Fabric& standard) {
    std::vector<FabricUse> uses;
    for (const Tile& tile : envelope.tiles) {
        const std::string& name = tile.fabric_or(standard).name;
        const auto known =
            std::find_if(uses.begin(), uses.end(), [&](const FabricUse& use) { return use.name == name; });
        ++(known != uses.end() ? *known : uses.emplace_back(FabricUse{name})).tiles;
    }
    return uses;
}

}  // namespace ripstop
