#include "ripstop/pipeline/flatten_envelope.h"

#include <chrono>
#include <mutex>

#include "ripstop/base/error.h"
#include "ripstop/base/parallel.h"
#include "ripstop/flatten/method.h"
#include "ripstop/measure/accuracy.h"
#include "ripstop/measure/judge.h"
#include "ripstop/measure/judge_seams.h"
#include "ripstop/measure/seam_walk.h"

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

/// Reports the tiles done, one call at a time.
class Counter {
  public:
    Counter(int count, const Progress& progress) : count_(count), progress_(progress) {}
    void done(const std::string& tile) {
        if (!progress_) return;
        const std::lock_guard lock(guard_);
        progress_(static_cast<double>(++done_) / count_, tile);
    }

  private:
    int count_, done_ = 0;
    const Progress& progress_;
    std::mutex guard_;
};

}  // namespace

CutPlan flatten_envelope(const Envelope& envelope, const FlattenOptions& options) {
    const Method* method = options.method == "given" ? nullptr : &method_named(options.method);
    CutPlan plan;
    plan.fabric = options.fabric;
    plan.tolerances = options.tolerances;
    plan.tiles.resize(envelope.tiles.size());
    const int count = static_cast<int>(envelope.tiles.size());
    Counter counter(count, options.progress);
    parallel_for(count, options.threads, [&](int i) {
        const Tile& tile = envelope.tiles[static_cast<std::size_t>(i)];
        FlatTile& result = plan.tiles[static_cast<std::size_t>(i)];
        const auto start = std::chrono::steady_clock::now();
        result.bounds = measure_bounds(tile);
        result.flattening = method ? method->flatten(tile, options.fabric) : given_flattening(tile);
        result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        result.tile = tile;
        result.method = options.method;
        result.accuracy =
            measure_accuracy(tile, result.flattening.positions, options.fabric, result.flattening.edges_on_curve);
        result.verdict = judge(tile, result.bounds, result.flattening, result.accuracy, options.tolerances);
        counter.done(tile.name);
    });
    plan.seams = envelope.seams;
    plan.walks = walk_seams(plan.tiles, plan.seams, plan.tolerances);
    judge_seams(plan);
    return plan;
}

}  // namespace ripstop
