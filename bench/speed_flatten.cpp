/// Measures a whole envelope, 360 tiles of about 1,000 triangles, by every method, on one thread and on all.
#include <benchmark/benchmark.h>

#include "ripstop/base/parallel.h"
#include "ripstop/design/natural/gores.h"
#include "ripstop/flatten/method.h"
#include "ripstop/io/json/fabric_json.h"
#include "ripstop/pipeline/flatten/flatten_envelope.h"
#include "ripstop/pipeline/read/read_envelope.h"
#include "support/sewn.h"

namespace ripstop {
namespace {

const Envelope& balloon() {
    static const Envelope envelope = [] {
        EnvelopeDesign design;
        design.edge_length = edge_length_for(design, 1000);
        Envelope all = make_envelope(design_natural(design), {});
        all.seams = testing::conforming_seams(all.tiles);
        return all;
    }();
    return envelope;
}

void flatten(benchmark::State& state, const std::string& method) {
    FlattenOptions options;
    options.method = method;
    options.fabric = fabric_named("nylon");
    options.threads = static_cast<int>(state.range(0));
    double factorizations = 0, iterations = 0;
    for (auto _ : state) {
        const CutPlan plan = flatten_envelope(balloon(), options);
        factorizations = iterations = 0;
        for (const FlatTile& tile : plan.tiles) {
            factorizations += tile.flattening.summary.factorizations;
            iterations += tile.flattening.summary.iterations;
        }
    }
    const double tiles = static_cast<double>(balloon().tiles.size());
    state.counters["tiles"] = tiles;
    state.counters["iterations_a_tile"] = iterations / tiles;
    state.counters["factorizations_a_tile"] = factorizations / tiles;
}

[[maybe_unused]] const bool registered = [] {
    for (const Method& method : methods())
        for (const int threads : {1, available_threads()})
            benchmark::RegisterBenchmark((std::string("envelope of 360 tiles/") + method.name).c_str(), flatten,
                                         std::string(method.name))
                ->Arg(threads)
                ->ArgName("threads")
                ->Unit(benchmark::kSecond)
                ->UseRealTime()
                ->Iterations(1);
    return true;
}();

}  // namespace
}  // namespace ripstop

BENCHMARK_MAIN();
