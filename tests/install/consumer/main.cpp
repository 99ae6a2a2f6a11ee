#include "ripstop/ripstop.h"

int main() {
    using namespace ripstop;
    const Envelope envelope = make_envelope(design_natural({.gores = 6, .panels = 1, .volume = 10}), {});
    const CutPlan plan = flatten_envelope(envelope, {.fabric = fabric_named("nylon")});
    return version[0] != '\0' && plan.tiles.size() == 6 && plan.seams.size() == 6 ? 0 : 1;
}
