#include "ripstop/pipeline/remesh/remesh_envelope.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <set>
#include <tuple>

#include "ripstop/assembly/seams/find_seams.h"
#include "ripstop/base/error.h"
#include "ripstop/base/index.h"
#include "ripstop/base/parallel.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/measure/equal_tiles.h"
#include "ripstop/mesh/boundary.h"
#include "ripstop/pipeline/remesh/copied_mesh.h"
#include "ripstop/pipeline/remesh/new_boundaries.h"
#include "ripstop/remesh/facet_row.h"
#include "ripstop/remesh/mesh_state.h"
#include "ripstop/remesh/remesh_tile.h"
#include "ripstop/tile/seam_sheets.h"

namespace ripstop {
namespace {

constexpr double most_triangles = 5e6;   // of the envelope, for a given edge length
constexpr double fewest_triangles = 24;  // of a tile, for a given edge length
constexpr int most_rounds = 4;
constexpr int most_meshings = 3;  // of a tile whose neighbours fail; then it keeps its mesh as they do

/// The plan for a tile, and the result.
struct TileJob {
    double edge_length = 0;  ///< 0: unchanged
    std::optional<MeshFault> fault;
    double turn_max = 0;
    double area = 0;       ///< of the input's triangles [m2]
    double perimeter = 0;  ///< of the input's boundary edges [m]
    std::string failure;
    NewBoundary boundary;
    std::optional<Tile> made;
    double distance_max = 0;  ///< from the new mesh to the input's triangles [m]
};

/// Triangles per tile: a thousand, or fewer if there are so many tiles that sewing and inflating would take minutes.
double fewest_of(std::size_t tiles) {
    return std::clamp(100000 / static_cast<double>(tiles), 250.0, 1000.0);
}

/// A row of facets with a fine boundary needs no other mesh: it unrolls without strain, however long and narrow its
/// triangles are, and its creases are straight on the cloth too.
bool unrolls_as_drawn(const Tile& tile, const MeshState& state, const MeshFault& fault, double length_tolerance) {
    return fault.kind != MeshFault::too_fine && !state.has_coarse_boundary(length_tolerance) &&
           FacetRow::find(tile, Adjacency(tile.mesh.triangles, tile.mesh.vertex_count()), {}).has_value();
}

std::vector<TileJob> find_jobs(const std::vector<Tile>& tiles, const RemeshOptions& options) {
    std::vector<TileJob> jobs(tiles.size());
    const double fewest = fewest_of(tiles.size());
    parallel_for(static_cast<int>(tiles.size()), options.threads, [&](int t) {
        const Tile& tile = tiles[at(t)];
        const MeshState state = measure_mesh(tile);
        TileJob& job = jobs[at(t)];
        job.turn_max = state.turn_max;
        job.area = state.area;
        job.perimeter = edge_lengths(tile.mesh.positions, closed(tile.boundary)).sum();
        if (options.mode == RemeshMode::by_length) {
            job.edge_length = std::min(options.edge_length, edge_of(state.area, fewest_triangles));
            return;
        }
        job.fault = find_fault(state, options.length_tolerance, fewest);
        if (job.fault && unrolls_as_drawn(tile, state, *job.fault, options.length_tolerance)) job.fault.reset();
        if (!job.fault) return;
        if (job.fault->kind != MeshFault::too_fine && state.is_jagged())
            job.failure = "the boundary was cut along the edges of a mesh, with a corner at every few vertices";
        else
            job.edge_length = needed_edge(state, fewest);
    });
    return jobs;
}

/// Gives equal tiles that need remeshing one edge length: that of the first of them.
void treat_alike(const std::vector<Tile>& tiles, const std::vector<Likeness>& likeness, std::vector<TileJob>& jobs) {
    for (std::size_t t = 0; t < jobs.size(); ++t) {
        if (likeness[t].to < 0) continue;
        const TileJob& first = jobs[at(likeness[t].to)];
        const TriangleMesh &one = tiles[at(likeness[t].to)].mesh, &other = tiles[t].mesh;
        const bool same_mesh =
            one.vertex_count() == other.vertex_count() && one.triangle_count() == other.triangle_count();
        if (!same_mesh && (first.edge_length == 0 || jobs[t].edge_length == 0)) continue;
        jobs[t].edge_length = first.edge_length;
        jobs[t].fault = first.fault;
    }
}

bool leaves_open(const Seam& seam, const RemeshOptions& options) {
    return seam.uncertainty > options.length_tolerance * seam.length;
}
bool leaves_any_open(const std::vector<Seam>& seams, const RemeshOptions& options) {
    return std::any_of(seams.begin(), seams.end(), [&](const Seam& seam) { return leaves_open(seam, options); });
}

/// Remeshes a tile that would be unchanged, such as a flat one, together with its neighbours if their seam is a
/// polyline too coarse to tell whether it or the curve through it is meant: both sides take the curve.
void take_coarse_neighbours(const std::vector<Tile>& tiles, const FoundSeams& found, const RemeshOptions& options,
                            std::vector<TileJob>& jobs) {
    if (options.mode != RemeshMode::automatic) return;
    const std::vector<bool> coarse = find_coarse_seams(tiles, found, options.length_tolerance);
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t s = 0; s < coarse.size(); ++s) {
            auto one = static_cast<std::size_t>(found.seams[s].a.tile);
            auto other = static_cast<std::size_t>(found.seams[s].b.tile);
            if (jobs[one].edge_length > 0) std::swap(one, other);
            if (!jobs[one].failure.empty()) continue;
            const bool is_open = leaves_open(found.seams[s], options);
            if (!coarse[s] || jobs[one].edge_length > 0 || (jobs[other].edge_length == 0 && !is_open)) continue;
            const MeshState state = measure_mesh(tiles[one]);
            jobs[one].edge_length = needed_edge(state, fewest_of(tiles.size()));
            jobs[one].fault = MeshFault{MeshFault::turns, state.turn_max};
            changed = true;
        }
    }
}

void require_length(const std::vector<Tile>& tiles, const RemeshOptions& options) {
    if (options.mode != RemeshMode::by_length) return;
    const std::string length = format_shortest(options.edge_length / millimetre) + " mm";
    if (!can_remesh())
        throw InputError("--remesh " + length +
                         ": this program was built without CGAL, which remeshes tiles; give "
                         "--remesh never, or build with -DRIPSTOP_CGAL=ON");
    if (!(options.edge_length > 0) || !std::isfinite(options.edge_length))
        throw InputError("--remesh " + length + ": give a length above 0");
    double area = 0;
    for (const Tile& tile : tiles) area += surface_area(tile.mesh);
    const double triangles = area / (std::sqrt(3.0) / 4 * options.edge_length * options.edge_length);
    if (triangles > most_triangles)
        throw InputError("--remesh " + length + ": that makes about " + format_fixed(triangles / 1e6, 0) +
                         " million triangles; give a length above " +
                         format_fixed(std::ceil(edge_of(area, most_triangles) / millimetre), 0) + " mm");
}

bool same_boundary(const NewBoundary& a, const NewBoundary& b) {
    return std::equal(a.nodes.begin(), a.nodes.end(), b.nodes.begin(), b.nodes.end(),
                      [](const BoundaryNode& p, const BoundaryNode& q) {
                          return p.position == q.position && p.length == q.length && p.place.edge == q.place.edge &&
                                 p.place.share == q.place.share;
                      });
}

/// Makes the missing meshes. A tile whose mesh fails is unchanged.
void make_meshes(const std::vector<Tile>& tiles, const std::vector<Likeness>& likeness, std::vector<TileJob>& jobs,
                 int threads) {
    std::vector<int> firsts, copies;
    for (std::size_t t = 0; t < jobs.size(); ++t) {
        if (jobs[t].edge_length == 0 || jobs[t].made) continue;
        const Likeness& like = likeness[t];
        const bool copy = like.to >= 0 && jobs[at(like.to)].edge_length > 0;
        (copy ? copies : firsts).push_back(static_cast<int>(t));
    }
    const auto make = [&](int t) {
        TileJob& job = jobs[at(t)];
        const Tile& tile = tiles[at(t)];
        try {
            const Likeness& like = likeness[at(t)];
            const TileJob* first = like.to < 0 ? nullptr : &jobs[at(like.to)];
            if (first && first->made) job.made = copied_mesh(tile, job.boundary, *first->made, first->boundary, like);
            if (job.made) job.distance_max = first->distance_max;
            if (job.made) return;
            RemeshedTile made = remesh_tile(tile, job.boundary, job.edge_length);
            job.made = std::move(made.tile);
            job.distance_max = made.distance_max;
        } catch (const std::exception& error) {
            job.failure = error.what();
        }
    };
    for (const std::vector<int>* list : {&firsts, &copies})
        parallel_for(static_cast<int>(list->size()), threads, [&](int k) { make((*list)[at(k)]); });
}

/// The chains of all sheets of a seam, by tile: outlines do not tell which of several sheets on an edge is the skin.
using SeamPlace = std::vector<std::pair<int, int>>;

std::vector<std::pair<SeamPlace, double>> places_of(const std::vector<Seam>& seams) {
    std::vector<std::pair<SeamPlace, double>> places;
    for (const std::vector<SeamSheet>& sheets : sheets_of_seams(seams)) {
        if (sheets.empty()) continue;
        SeamPlace place;
        for (const SeamSheet& sheet : sheets) place.emplace_back(sheet.side->tile, sheet.side->chain);
        std::sort(place.begin(), place.end());
        places.emplace_back(std::move(place), sheets.front().record->length);
    }
    return places;
}

/// The tiles whose seams are not found again. An additional seam within a tile is ignored: it lies at a tip, where the
/// sides of an outline have no cloth between them.
std::set<int> tiles_with_other_seams(const std::vector<Tile>& tiles, const std::vector<Seam>& seams, double tolerance) {
    std::map<SeamPlace, std::vector<double>> missing;
    for (const auto& [place, length] : places_of(seams)) missing[place].push_back(length);
    std::set<int> concerned;
    const auto add = [&](const SeamPlace& place) {
        for (const auto& [tile, chain] : place) concerned.insert(tile);
    };
    for (const auto& [place, found] : places_of(find_seams(tiles, {tolerance}).seams)) {
        std::vector<double>& lengths = missing[place];
        const auto same = std::find_if(lengths.begin(), lengths.end(), [&, found = found](double length) {
            return std::abs(length - found) < std::max(4 * tolerance, 0.01 * length);
        });
        if (same != lengths.end())
            lengths.erase(same);
        else if (place.front().first != place.back().first)
            add(place);
    }
    for (const auto& [place, lengths] : missing)
        if (!lengths.empty()) add(place);
    return concerned;
}

void give_up(TileJob& job) {
    job.edge_length = 0;
    job.made.reset();
}

/// Returns true if a tile failed, so the boundaries of its neighbours must change.
bool give_up_failed(std::vector<TileJob>& jobs) {
    bool any = false;
    for (TileJob& job : jobs) {
        if (job.edge_length == 0 || job.failure.empty()) continue;
        give_up(job);
        any = true;
    }
    return any;
}

bool any_left(const std::vector<TileJob>& jobs) {
    return std::any_of(jobs.begin(), jobs.end(), [](const TileJob& job) { return job.edge_length > 0; });
}

/// The tiles of `lost` that are to be remeshed; if there are none, the neighbours of the lost ones; failing that, all.
std::set<int> concerned_jobs(const std::vector<TileJob>& jobs, const std::vector<Seam>& seams,
                             const std::set<int>& lost) {
    std::set<int> jobs_lost, beside, all;
    for (std::size_t t = 0; t < jobs.size(); ++t) {
        if (jobs[t].edge_length == 0) continue;
        all.insert(static_cast<int>(t));
        if (lost.contains(static_cast<int>(t))) jobs_lost.insert(static_cast<int>(t));
    }
    for (const Seam& seam : seams)
        for (const auto& [one, other] : {std::pair(seam.a.tile, seam.b.tile), std::pair(seam.b.tile, seam.a.tile)})
            if (lost.contains(one) && all.contains(other)) beside.insert(other);
    return !jobs_lost.empty() ? jobs_lost : !beside.empty() ? beside : all;
}

/// Divides the boundaries and checks that the seams between them are unchanged, with fewer tiles each time until they
/// are. Seams follow from the boundaries alone, so nothing needs to be meshed.
NewBoundaries settle_boundaries(const std::vector<Tile>& tiles, const FoundSeams& found, std::vector<TileJob>& jobs,
                                const RemeshOptions& options) {
    for (int round = 0;; ++round) {
        std::vector<double> edge_lengths;
        for (const TileJob& job : jobs) edge_lengths.push_back(job.edge_length);
        NewBoundaries plan =
            divide_boundaries(tiles, found, edge_lengths, options.length_tolerance, options.seam_tolerance);
        if (!any_left(jobs)) return plan;
        std::vector<Tile> outlines;
        for (std::size_t t = 0; t < tiles.size(); ++t)
            outlines.push_back(jobs[t].edge_length > 0 ? outline_tile(tiles[t], plan.tiles[t]) : tiles[t]);
        const std::set<int> lost = tiles_with_other_seams(outlines, plan.seams, options.seam_tolerance);
        if (lost.empty()) return plan;
        const std::set<int> concerned = concerned_jobs(jobs, found.seams, round < most_rounds ? lost : std::set<int>());
        for (const int t : concerned) jobs[at(t)].failure = "the seams would not be found again";
        give_up_failed(jobs);
    }
}

/// Divides and meshes; repeats without the tiles whose mesh failed.
void remesh(Envelope& envelope, const FoundSeams& found, const std::vector<Likeness>& likeness,
            std::vector<TileJob>& jobs, const RemeshOptions& options) {
    for (int round = 0; any_left(jobs); ++round) {
        NewBoundaries plan = settle_boundaries(envelope.tiles, found, jobs, options);
        for (std::size_t t = 0; t < jobs.size(); ++t) {
            if (!same_boundary(jobs[t].boundary, plan.tiles[t])) jobs[t].made.reset();
            jobs[t].boundary = std::move(plan.tiles[t]);
            if (round >= most_meshings && jobs[t].edge_length > 0 && !jobs[t].made)
                jobs[t].failure = "its neighbours could not be remeshed";
        }
        if (give_up_failed(jobs)) continue;
        make_meshes(envelope.tiles, likeness, jobs, options.threads);
        if (give_up_failed(jobs)) continue;
        for (std::size_t t = 0; t < jobs.size(); ++t)
            if (jobs[t].made) envelope.tiles[t] = *jobs[t].made;
        if (any_left(jobs)) envelope.seams = std::move(plan.seams);
        return;
    }
}

std::string tiles_text(const std::vector<std::string>& names) {
    return names.size() == 1 ? "tile " + names.front() : std::to_string(names.size()) + " tiles";
}

/// The largest distance from the new triangles to the input's.
std::string deviation_text(double gain, double distance) {
    return format_fixed(std::abs(gain) / percent, 3) + " % " + (gain < 0 ? "less" : "more") +
           " area than drawn, up to " + format_fixed(distance / millimetre, 1) + " mm from the drawn mesh";
}

/// One sentence for each kind of fault and outcome.
std::vector<std::string> remarks_of(const std::vector<Tile>& tiles, const std::vector<TileJob>& jobs) {
    struct Group {
        std::vector<std::string> names;
        double shortest = 0, longest = 0;
        double area_before = 0, area_after = 0, distance_max = 0;
        std::optional<MeshFault> fault;
    };
    std::map<std::tuple<std::string, int>, Group> groups;
    for (std::size_t t = 0; t < jobs.size(); ++t) {
        const TileJob& job = jobs[t];
        if (!job.made && job.failure.empty()) continue;
        Group& group = groups[{job.failure, job.fault ? job.fault->kind : -1}];
        group.shortest = group.names.empty() ? job.edge_length : std::min(group.shortest, job.edge_length);
        group.longest = std::max(group.longest, job.edge_length);
        if (job.fault && (!group.fault || group.fault->value < job.fault->value)) group.fault = job.fault;
        group.names.push_back(tiles[t].name);
        group.area_before += job.area;
        group.area_after += job.made ? surface_area(job.made->mesh) : job.area;
        group.distance_max = std::max(group.distance_max, job.distance_max);
    }
    std::vector<std::string> remarks;
    for (const auto& [key, group] : groups) {
        const std::string& failure = std::get<0>(key);
        const std::string low = format_fixed(group.shortest / millimetre, 0);
        const std::string high = format_fixed(group.longest / millimetre, 0);
        const std::string why = group.fault ? ": " + group.fault->text() : std::string(", as asked");
        if (failure.empty())
            remarks.push_back(tiles_text(group.names) + " remeshed at " + (low == high ? "" : low + " to ") + high +
                              " mm" + why + "; " +
                              deviation_text(group.area_after / group.area_before - 1, group.distance_max));
        else
            remarks.push_back(tiles_text(group.names) + " not remeshed" + why + ", but " + failure);
    }
    return remarks;
}

}  // namespace

std::vector<std::string> remesh_envelope(Envelope& envelope, const RemeshOptions& options) {
    if (options.mode == RemeshMode::never) return {};
    require_length(envelope.tiles, options);
    std::vector<TileJob> jobs = find_jobs(envelope.tiles, options);
    if (!any_left(jobs) && (options.mode != RemeshMode::automatic || !leaves_any_open(envelope.seams, options)))
        return remarks_of(envelope.tiles, jobs);
    if (!can_remesh()) {
        for (TileJob& job : jobs)
            if (job.edge_length > 0) job.failure = "this program was built without CGAL";
        return remarks_of(envelope.tiles, jobs);
    }
    FoundSeams found;
    try {
        found = find_seams(envelope.tiles, {options.seam_tolerance});
    } catch (const InputError&) {  // tiles too small to have seams: `check_envelope` names the right unit
        return {};
    }
    take_coarse_neighbours(envelope.tiles, found, options, jobs);
    std::vector<int> before;
    for (const Tile& tile : envelope.tiles) before.push_back(tile.mesh.triangle_count());
    const std::vector<Likeness> likeness = find_equal_tiles(envelope.tiles);
    treat_alike(envelope.tiles, likeness, jobs);
    remesh(envelope, found, likeness, jobs, options);
    for (std::size_t t = 0; t < jobs.size(); ++t)
        if (jobs[t].made)
            envelope.tiles[t].remeshed = {jobs[t].fault ? jobs[t].fault->text() : "asked for",
                                          before[t],
                                          jobs[t].edge_length,
                                          jobs[t].turn_max,
                                          jobs[t].area,
                                          jobs[t].perimeter,
                                          jobs[t].distance_max};
    return remarks_of(envelope.tiles, jobs);
}

}  // namespace ripstop
