#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/model/plan/strain_map.h"
#include "ripstop/report/view/envelope_view.h"

namespace ripstop {

/// The envelope from the front, as report.html opens it, and from the back.
struct EnvelopeSights {
    std::array<EnvelopeView, 2> views;
};
EnvelopeSights see_envelope(const CutPlan& plan, int threads);

/// A PNG picture, 1600 wide: the verdict in words as report.html says it, both views in the colours of a map
/// (`page_maps`), what fails outlined red and the first of it named, proposed seams dashed, the legend with its
/// numbers, a scale bar.
std::string envelope_png(const CutPlan& plan, const EnvelopeSights& sights, const std::vector<StrainMap>& strains,
                         const PageMap& map);

}  // namespace ripstop
