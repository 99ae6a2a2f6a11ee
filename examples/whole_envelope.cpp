/// The main job: a whole envelope from its file to the folder of its cut plan, as `ripstop flatten` does it.
#include <cstdio>
#include <filesystem>

#include "ripstop/base/error.h"
#include "ripstop/pipeline/plan.h"
#include "ripstop/report/tables/tables.h"

int main(int count, char** arguments) try {
    using namespace ripstop;
    if (count != 4) return std::fputs("usage: whole_envelope FILE FABRIC FOLDER\n", stderr), 2;
    PlanWatch watch;
    watch.message = [](const PlanMessage& message) { std::printf("%s\n", message.text.c_str()); };
    const Plan plan = plan_envelope(std::filesystem::path(arguments[1]), {.fabric_name = arguments[2]}, watch);
    std::printf("%s\n", plan_summary(plan.cut).c_str());

    const std::filesystem::path folder = arguments[3];
    for (const std::string& warning : write_plan(folder, plan, {.force = true, .formats = {"dxf", "svg"}}))
        std::printf("%s\n", warning.c_str());
    std::printf("open %s\n", (folder / "report.html").c_str());
    return plan.is_good() && std::filesystem::exists(folder / "cut" / "envelope.dxf") ? 0 : 1;
} catch (const ripstop::InputError& error) {
    return std::fprintf(stderr, "%s\n", error.what()), 3;
}
