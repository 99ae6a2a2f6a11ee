/// Measures remeshing: seconds per tile, and new triangles per second.
#include <benchmark/benchmark.h>

#include "ripstop/assembly/seams/find_seams.h"
#include "ripstop/pipeline/remesh/remesh_envelope.h"
#include "ripstop/tile/make_tile.h"
#include "support/shapes.h"

namespace ripstop {
namespace {

void remesh_octant(benchmark::State& state, int subdivisions) {
    Envelope input{{make_tile("octant", testing::octant(subdivisions), {.warp = Vec3(-1, 1, 0)})}};
    add_seams(input);
    // The edge length for about 1,500 triangles.
    const RemeshOptions options{.mode = RemeshMode::by_length, .edge_length = 0.049, .threads = 1};
    int triangles = 0;
    for (auto step : state) {
        Envelope envelope = input;
        remesh_envelope(envelope, options);
        triangles = envelope.tiles[0].mesh.triangle_count();
    }
    state.counters["triangles_before"] = subdivisions * subdivisions;
    state.counters["triangles"] = triangles;
    state.counters["seconds_per_1000"] = benchmark::Counter(
        triangles / 1000.0, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

BENCHMARK_CAPTURE(remesh_octant, from_100_triangles, 10)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(remesh_octant, from_3600_triangles, 60)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(remesh_octant, from_62500_triangles, 250)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace ripstop
