#include "ripstop/pipeline/remesh_envelope.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <set>
#include <tuple>

#include "ripstop/assembly/find_seams.h"
#include "ripstop/base/error.h"
#include "ripstop/base/number_text.h"
#include "ripstop/base/parallel.h"
#include "ripstop/measure/equal_tiles.h"
#include "ripstop/pipeline/copied_mesh.h"
#include "ripstop/pipeline/new_boundaries.h"
#include "ripstop/remesh/mesh_state.h"
#include "ripstop/remesh/remesh_tile.h"

namespace ripstop {
namespace {

constexpr double most_triangles = 5e6;   // of the envelope, by length
constexpr double fewest_triangles = 24;  // of a tile, by length
constexpr int most_rounds = 4;

/// What is to become of a tile, and what became of it.
struct Job {
    double edge_length = 0;  ///< 0: it stays
    std::optional<MeshFault> fault;
    double turn_max = 0;
    std::string failure;
    NewBoundary boundary;
    std::optional<Tile> made;
};

/// Triangles a tile: a thousand, fewer where the tiles are so many that sewing and inflating them would take minutes.
double fewest_of(std::size_t tiles) {
    return std::clamp(100000 / static_cast<double>(tiles), 250.0, 1000.0);
}

std::vector<Job> find_jobs(const std::vector<Tile>& tiles, const RemeshOptions& options) {
    std::vector<Job> jobs(tiles.size());
    const double fewest = fewest_of(tiles.size());
    parallel_for(static_cast<int>(tiles.size()), options.threads, [&](int t) {
        const MeshState state = measure_mesh(tiles[static_cast<std::size_t>(t)]);
        Job& job = jobs[static_cast<std::size_t>(t)];
        job.turn_max = state.turn_max;
        if (options.mode == RemeshMode::by_length) {
            job.edge_length = std::min(options.edge_length, edge_of(state.area, fewest_triangles));
            return;
        }
        job.fault = find_fault(state, options.length_tolerance, fewest);
        if (job.fault) job.edge_length = needed_edge(state, fewest);
    });
    return jobs;
}

void require_length(const std::vector<Tile>& tiles, const RemeshOptions& options) {
    if (options.mode != RemeshMode::by_length) return;
    const std::string length = format_shortest(options.edge_length / millimetre) + " mm";
    if (!can_remesh())
        throw InputError("--remesh " + length +
                         ": this program was built without CGAL, which meshes tiles anew; give "
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

/// Makes the meshes that are not there yet. A tile whose mesh does not come out stays as it was.
void make_meshes(const std::vector<Tile>& tiles, const std::vector<Likeness>& likeness, std::vector<Job>& jobs,
                 int threads) {
    std::vector<int> firsts, copies;
    for (std::size_t t = 0; t < jobs.size(); ++t) {
        if (jobs[t].edge_length == 0 || jobs[t].made) continue;
        const Likeness& like = likeness[t];
        const bool copy = !like.vertex.empty() && jobs[static_cast<std::size_t>(like.to)].edge_length > 0;
        (copy ? copies : firsts).push_back(static_cast<int>(t));
    }
    const auto make = [&](int t) {
        Job& job = jobs[static_cast<std::size_t>(t)];
        const Tile& tile = tiles[static_cast<std::size_t>(t)];
        try {
            const Likeness& like = likeness[static_cast<std::size_t>(t)];
            const Job* first = like.vertex.empty() ? nullptr : &jobs[static_cast<std::size_t>(like.to)];
            if (first && first->made) job.made = copied_mesh(tile, job.boundary, *first->made, first->boundary, like);
            if (!job.made) job.made = remesh_tile(tile, job.boundary, job.edge_length);
        } catch (const std::exception& error) {
            job.failure = error.what();
        }
    };
    for (const std::vector<int>* list : {&firsts, &copies})
        parallel_for(static_cast<int>(list->size()), threads,
                     [&](int k) { make((*list)[static_cast<std::size_t>(k)]); });
}

using SeamPlace = std::tuple<int, int, int, int>;
SeamPlace place_of(const Seam& seam) {
    return {seam.a.tile, seam.a.chain, seam.b.tile, seam.b.chain};
}

/// The tiles whose seams are not found again.
std::set<int> tiles_with_other_seams(const std::vector<Tile>& tiles, const std::vector<Seam>& seams, double tolerance) {
    std::map<SeamPlace, std::vector<double>> missing;
    for (const Seam& seam : seams) missing[place_of(seam)].push_back(seam.length);
    std::set<int> concerned;
    const auto add = [&](const SeamPlace& place) { concerned.insert({std::get<0>(place), std::get<2>(place)}); };
    for (const Seam& seam : find_seams(tiles, {tolerance}).seams) {
        std::vector<double>& lengths = missing[place_of(seam)];
        const auto same = std::find_if(lengths.begin(), lengths.end(), [&](double length) {
            return std::abs(length - seam.length) < std::max(4 * tolerance, 0.01 * length);
        });
        if (same == lengths.end())
            add(place_of(seam));
        else
            lengths.erase(same);
    }
    for (const auto& [place, lengths] : missing)
        if (!lengths.empty()) add(place);
    return concerned;
}

void give_up(Job& job) {
    job.edge_length = 0;
    job.made.reset();
}

/// True: a tile failed, and what its neighbours are to look like has changed.
bool give_up_failed(std::vector<Job>& jobs) {
    bool any = false;
    for (Job& job : jobs) {
        if (job.edge_length == 0 || job.failure.empty()) continue;
        give_up(job);
        any = true;
    }
    return any;
}

bool any_left(const std::vector<Job>& jobs) {
    return std::any_of(jobs.begin(), jobs.end(), [](const Job& job) { return job.edge_length > 0; });
}

/// Divides, meshes and looks whether the seams are still the same, with fewer tiles each time until they are.
void remesh(Envelope& envelope, const FoundSeams& found, std::vector<Job>& jobs, const RemeshOptions& options) {
    const std::vector<Likeness> likeness = find_equal_tiles(envelope.tiles);
    for (int round = 0; any_left(jobs); ++round) {
        std::vector<double> edge_lengths;
        for (const Job& job : jobs) edge_lengths.push_back(job.edge_length);
        NewBoundaries plan =
            divide_boundaries(envelope.tiles, found, edge_lengths, options.length_tolerance, options.seam_tolerance);
        for (std::size_t t = 0; t < jobs.size(); ++t) {
            if (!same_boundary(jobs[t].boundary, plan.tiles[t])) jobs[t].made.reset();
            jobs[t].boundary = std::move(plan.tiles[t]);
        }
        make_meshes(envelope.tiles, likeness, jobs, options.threads);
        if (give_up_failed(jobs)) continue;
        std::vector<Tile> tiles = envelope.tiles;
        for (std::size_t t = 0; t < jobs.size(); ++t)
            if (jobs[t].made) tiles[t] = *jobs[t].made;
        std::set<int> lost = tiles_with_other_seams(tiles, plan.seams, options.seam_tolerance);
        if (lost.empty()) {
            envelope.tiles = std::move(tiles);
            envelope.seams = std::move(plan.seams);
            return;
        }
        std::erase_if(lost, [&](int t) { return !jobs[static_cast<std::size_t>(t)].made; });
        for (std::size_t t = 0; t < jobs.size(); ++t) {
            if (!jobs[t].made || (round < most_rounds && !lost.empty() && !lost.contains(static_cast<int>(t))))
                continue;
            jobs[t].failure = "the seams were not found again";
        }
        give_up_failed(jobs);
    }
}

std::string tiles_text(const std::vector<std::string>& names) {
    return names.size() == 1 ? "tile " + names.front() : std::to_string(names.size()) + " tiles";
}

/// A sentence for each kind of fault and outcome.
std::vector<std::string> remarks_of(const std::vector<Tile>& tiles, const std::vector<Job>& jobs) {
    struct Group {
        std::vector<std::string> names;
        double shortest = 0, longest = 0;
        std::optional<MeshFault> fault;
    };
    std::map<std::tuple<std::string, int>, Group> groups;
    for (std::size_t t = 0; t < jobs.size(); ++t) {
        const Job& job = jobs[t];
        if (!job.made && job.failure.empty()) continue;
        Group& group = groups[{job.failure, job.fault ? job.fault->kind : -1}];
        group.shortest = group.names.empty() ? job.edge_length : std::min(group.shortest, job.edge_length);
        group.longest = std::max(group.longest, job.edge_length);
        if (job.fault && (!group.fault || group.fault->value < job.fault->value)) group.fault = job.fault;
        group.names.push_back(tiles[t].name);
    }
    std::vector<std::string> remarks;
    for (const auto& [key, group] : groups) {
        const std::string& failure = std::get<0>(key);
        const std::string low = format_fixed(group.shortest / millimetre, 0);
        const std::string high = format_fixed(group.longest / millimetre, 0);
        const std::string why = group.fault ? ": " + group.fault->text() : std::string(", as asked");
        if (failure.empty())
            remarks.push_back(tiles_text(group.names) + " remeshed at " + (low == high ? "" : low + " to ") + high +
                              " mm" + why);
        else
            remarks.push_back(tiles_text(group.names) + " not remeshed" + why + ", but " + failure);
    }
    return remarks;
}

}  // namespace

std::vector<std::string> remesh_envelope(Envelope& envelope, const RemeshOptions& options) {
    if (options.mode == RemeshMode::never) return {};
    require_length(envelope.tiles, options);
    std::vector<Job> jobs = find_jobs(envelope.tiles, options);
    if (!any_left(jobs)) return {};
    if (!can_remesh()) {
        for (Job& job : jobs)
            if (job.edge_length > 0) job.failure = "this program was built without CGAL";
        return remarks_of(envelope.tiles, jobs);
    }
    FoundSeams found;
    try {
        found = find_seams(envelope.tiles, {options.seam_tolerance});
    } catch (
        const InputError&) {  // the tiles are too small to have seams: `check_envelope` names the unit that is meant
        return {};
    }
    std::vector<int> before;
    for (const Tile& tile : envelope.tiles) before.push_back(tile.mesh.triangle_count());
    remesh(envelope, found, jobs, options);
    for (std::size_t t = 0; t < jobs.size(); ++t)
        if (jobs[t].made)
            envelope.tiles[t].remeshed = {jobs[t].fault ? jobs[t].fault->text() : "asked for", before[t],
                                          jobs[t].edge_length, jobs[t].turn_max};
    return remarks_of(envelope.tiles, jobs);
}

}  // namespace ripstop
