#include "ripstop/pipeline/read/own_meshes.h"

#include <algorithm>
#include <utility>

#include "ripstop/base/index.h"

namespace ripstop {
namespace {

bool seam_fails(const SeamWalk& walk) {
    return !walk.ok || !walk.is_certain();
}

bool is_in_question(const CutPlan& plan) {
    const auto is_remeshed = [&](int tile) { return plan.tiles[at(tile)].tile.remeshed.has_value(); };
    for (const FlatTile& tile : plan.tiles)
        if (tile.tile.remeshed && !tile.verdict.manufacturable()) return true;
    for (std::size_t s = 0; s < plan.walks.size(); ++s)
        if (seam_fails(plan.walks[s]) && (is_remeshed(plan.seams[s].a.tile) || is_remeshed(plan.seams[s].b.tile)))
            return true;
    return false;
}

std::string failing_text(const Failing& failing) {
    return std::to_string(failing.tiles) + (failing.tiles == 1 ? " tile and " : " tiles and ") +
           std::to_string(failing.seams) + (failing.seams == 1 ? " seam" : " seams");
}

}  // namespace

Failing count_failing(const CutPlan& plan) {
    return {static_cast<int>(std::count_if(plan.tiles.begin(), plan.tiles.end(),
                                           [](const FlatTile& tile) { return !tile.verdict.manufacturable(); })),
            static_cast<int>(std::count_if(plan.walks.begin(), plan.walks.end(), seam_fails))};
}

bool prefer_own_meshes(CutPlan& plan, EnvelopeInput& input, const FlattenOptions& options) {
    if (!input.drawn || !is_in_question(plan)) return false;
    CutPlan own = flatten_envelope(input.drawn->envelope, options);
    const Failing here = count_failing(plan), there = count_failing(own);
    if (!(there < here)) return false;
    input.envelope = std::move(input.drawn->envelope);
    input.remarks = std::move(input.drawn->remarks);
    input.drawn.reset();
    input.remarks.push_back("all tiles keep their drawn meshes, because fewer fail on them: " + failing_text(there) +
                            " instead of " + failing_text(here));
    plan = std::move(own);
    return true;
}

}  // namespace ripstop
