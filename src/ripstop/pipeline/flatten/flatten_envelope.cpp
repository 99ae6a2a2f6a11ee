#include "ripstop/pipeline/flatten/flatten_envelope.h"

#include <chrono>
#include <utility>

#include "ripstop/base/error.h"
#include "ripstop/base/index.h"
#include "ripstop/base/parallel.h"
#include "ripstop/base/progress.h"
#include "ripstop/flatten/method.h"
#include "ripstop/measure/judge.h"
#include "ripstop/measure/judge_seams.h"
#include "ripstop/measure/judge_zigzags.h"
#include "ripstop/measure/measure_accuracy.h"
#include "ripstop/measure/walk_seams.h"
#include "ripstop/pipeline/flatten/equal_pieces.h"

namespace ripstop {
namespace {

Flattening given_flattening(const Tile& tile) {
    if (!tile.drawn)
        throw InputError("tile " + tile.name +
                         ": came without flat positions to judge; write one texture coordinate (vt) for each vertex");
    Flattening flat{*tile.drawn, {}};
    flat.summary = {Termination::converged, 0, 0, "came with the input"};
    return flat;
}

constexpr double together_share = 0.9;  ///< share of the progress for methods that solve all tiles before judging them

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

std::vector<Flattening> flatten_together(const Method& method, const Envelope& envelope,
                                         const FlattenOptions& options) {
    Progress progress;
    if (options.progress)
        progress = [&](double fraction, const std::string& what) { options.progress(together_share * fraction, what); };
    return method.flatten_together(envelope, options.fabric, options.threads, progress);
}

}  // namespace

CutPlan flatten_envelope(const Envelope& envelope, const FlattenOptions& options) {
    const Method* method = options.method == "given" ? nullptr : &method_named(options.method);
    CutPlan plan;
    plan.fabric = options.fabric;
    plan.tolerances = options.tolerances;
    plan.tiles.resize(envelope.tiles.size());
    const int count = static_cast<int>(envelope.tiles.size());
    const bool at_once = method && method->flatten_together;
    const auto begun = Clock::now();
    std::vector<Flattening> flats;
    if (at_once) flats = flatten_together(*method, envelope, options);
    const double seconds_each = seconds_since(begun) / count;
    StepCounter counter(count, options.progress, at_once ? together_share : 0);
    const std::vector<Likeness> likeness = find_equal_tiles(envelope.tiles);
    const bool copies = method && !at_once;
    std::vector<int> solved, copied;
    for (int i = 0; i < count; ++i) (copies && !likeness[at(i)].vertex.empty() ? copied : solved).push_back(i);
    const auto flatten_and_judge = [&](int i, const Likeness* copy) {
        const Tile& tile = envelope.tiles[at(i)];
        const Fabric& fabric = plan.fabric_of(tile);
        FlatTile& result = plan.tiles[at(i)];
        const auto start = Clock::now();
        if (copy) {
            const FlatTile& first = plan.tiles[at(copy->to)];
            result.bounds = moved_bounds(first.bounds, *copy);
            result.flattening = copied_flattening(first, tile, *copy);
        } else {
            result.bounds = measure_bounds(tile);
            result.flattening = at_once  ? std::move(flats[at(i)])
                                : method ? method->flatten(tile, fabric)
                                         : given_flattening(tile);
        }
        result.seconds = seconds_since(start) + (at_once ? seconds_each : 0);
        result.tile = tile;
        result.method = options.method;
        result.accuracy = measure_accuracy(tile, result.flattening.positions, fabric, result.flattening.edges_on_curve);
        result.verdict = judge(tile, result.bounds, result.flattening, result.accuracy, plan.tolerances_of(tile));
        counter.done(tile.name);
    };
    const auto nth = [](const std::vector<int>& list, int k) { return list[at(k)]; };
    parallel_for(static_cast<int>(solved.size()), options.threads,
                 [&](int k) { flatten_and_judge(nth(solved, k), nullptr); });
    parallel_for(static_cast<int>(copied.size()), options.threads,
                 [&](int k) { flatten_and_judge(nth(copied, k), &likeness[at(nth(copied, k))]); });
    plan.seams = envelope.seams;
    list_equal_pieces(plan, likeness);
    plan.walks = walk_seams(plan.tiles, plan.seams, plan.tolerances);
    judge_seams(plan);
    judge_zigzags(plan);
    return plan;
}

}  // namespace ripstop
