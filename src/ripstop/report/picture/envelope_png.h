#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/report/view/envelope_view.h"

namespace ripstop {

/// The envelope from the front, like the first view in report.html, and from the back.
struct EnvelopeSights {
    EnvelopeShape shape;
    std::array<EnvelopeView, 2> views;
};
/// The envelope as drawn, or as inflated (requires `plan.inflated`).
EnvelopeSights see_envelope(const CutPlan& plan, int threads, bool is_inflated = false);

/// A PNG picture, 1600 pixels wide: the verdict in the words of report.html, and both views in the colours of a map
/// (`map_view`) in its first scale. Failing tiles and seams are outlined in red, and the first of them is named.
/// Proposed seams are dashed. A legend with numbers and a scale bar are included.
std::string envelope_png(const CutPlan& plan, const EnvelopeSights& sights, const MapView& map);

}  // namespace ripstop
