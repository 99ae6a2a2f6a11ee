/// Sews the pieces of a cut plan, fills them with hot air, and adds to its folder what came out.
#include <cmath>
#include <cstdio>

#include "ripstop/base/error.h"
#include "ripstop/base/text/units.h"
#include "ripstop/pipeline/flight/inflate_plan.h"
#include "ripstop/pipeline/flight/tape_seams.h"
#include "ripstop/pipeline/plan.h"

int main(int count, char** arguments) try {
    using namespace ripstop;
    if (count != 2) return std::fputs("usage: inflate FOLDER\n", stderr), 2;
    Plan plan = read_plan(arguments[1]);
    plan.cut.flight = Flight{};
    plan.cut.flight->load.air.inside = 90;  // Celsius
    plan.cut.flight->tapes = TapedSeams::meridians;
    tape_seams(plan.cut, plan.cut.flight->tapes);

    const Inflated inflated = inflate_plan(plan.cut, {.load = plan.cut.flight->load, .find_causes = false});
    std::printf("%s; one of %d sectors computed\n", inflated.summary.text().c_str(), inflated.sectors);
    std::printf("%.2f m high (drawn %.2f), %.1f m3 (drawn %.1f)\n", inflated.height, inflated.drawn_height,
                inflated.volume, inflated.drawn_volume);
    std::printf("%.1f mm off the drawn surface at most, %.1f in the mean\n", inflated.off.max / millimetre,
                inflated.off.rms / millimetre);
    std::printf("carries %.0f N; cloth up to %.0f N/m, load tapes up to %.0f N\n", inflated.lift, inflated.tension_max,
                inflated.load_tape_max);
    for (const SafetyFactor& part : inflated.safety)
        std::printf("%s: safety factor %.1f, %.1f required\n", part.part.c_str(), part.factor, part.required);

    plan.cut.inflated = inflated;
    update_plan(arguments[1], plan);
    return inflated.stands() && std::abs(inflated.volume / inflated.drawn_volume - 1) < 0.1 ? 0 : 1;
} catch (const ripstop::InputError& error) {
    return std::fprintf(stderr, "%s\n", error.what()), 3;
}
