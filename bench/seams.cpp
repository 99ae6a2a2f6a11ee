/// Measures the time to find and check the seams of large envelopes: `ripstop-bench-seams`.
#include <fmt/format.h>

#include <chrono>

#include "ripstop/assembly/faults/check_envelope.h"
#include "support/envelopes.h"

namespace ripstop {
namespace {

template <class Work>
double seconds_of(Work&& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void time_envelope(const char* name, const EnvelopeDesign& design, const std::vector<NamedMesh>& meshes) {
    const Envelope envelope = testing::tiles_of(meshes);
    std::size_t edges = 0;
    for (const Tile& tile : envelope.tiles) edges += tile.boundary.size();
    FoundSeams found;
    EnvelopeCheck check;
    const double finding = seconds_of([&] { found = find_seams(envelope.tiles); });
    const double checking = seconds_of([&] { check = check_envelope(envelope); });
    fmt::print("| {} | {} | {} | {} | {} | {} | {:.2f} | {:.2f} |\n", name, check.tiles, edges, found.seams.size(),
               testing::seam_count(design), check.issues.size(), finding, checking);
}

}  // namespace
}  // namespace ripstop

int main() {
    using namespace ripstop;
    fmt::print("| envelope | tiles | boundary edges | seams found | seams there | issues | find s | check s |\n");
    fmt::print("| --- | --- | --- | --- | --- | --- | --- | --- |\n");
    EnvelopeDesign design;
    time_envelope("24 x 15, one mesh", design, design_natural(design));
    time_envelope("24 x 15, meshed apart", design, testing::meshed_apart(design, 1, 2));
    design.gores = 100;
    design.panels = 50;
    design.volume = 20000;
    time_envelope("100 x 50, one mesh", design, design_natural(design));
    time_envelope("100 x 50, meshed apart", design, testing::meshed_apart(design, 1, 2));
}
