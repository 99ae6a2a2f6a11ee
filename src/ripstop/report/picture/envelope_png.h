#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/report/view/envelope_view.h"

namespace ripstop {

/// The envelope from the front, as report.html opens it, and from the back.
struct EnvelopeSights {
    EnvelopeShape shape;
    std::array<EnvelopeView, 2> views;
};
/// As drawn, or as inflated, which needs `plan.inflated`.
EnvelopeSights see_envelope(const CutPlan& plan, int threads, bool is_inflated = false);

/// A PNG picture, 1600 wide: the verdict in words as report.html says it, both views in the colours of a map
/// (`map_view`), in the scale it is shown in, what fails outlined red and the first of it named, proposed seams dashed,
/// the legend with its numbers, a scale bar.
std::string envelope_png(const CutPlan& plan, const EnvelopeSights& sights, const MapView& map);

}  // namespace ripstop
