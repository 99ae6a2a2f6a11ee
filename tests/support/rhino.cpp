#include "support/rhino.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "support/outside.h"

namespace ripstop::testing {
namespace {

const std::string tool = "node " RIPSTOP_SOURCE_DIR "/tests/rhino/rhino.mjs ";

}  // namespace

bool has_rhino() {
    static const bool here = std::filesystem::exists(RIPSTOP_SOURCE_DIR "/apps/rhino/node_modules/rhino3dm") &&
                             run_command("node --version").code == 0;
    return here;
}

nlohmann::json described_by_rhino(const std::string& file) {
    const CommandResult says = run_command(tool + "describe '" + file + "'");
    EXPECT_EQ(says.code, 0) << says.output;
    return says.code == 0 ? nlohmann::json::parse(says.output) : nlohmann::json();
}

void write_by_rhino(const nlohmann::json& scene, const std::string& scene_file, const std::vector<int>& versions) {
    write_text(scene_file, scene.dump());
    const std::string stem = scene_file.substr(0, scene_file.rfind('.'));
    for (const int version : versions) {
        const CommandResult result = run_command(tool + "write '" + scene_file + "' '" + stem + "_v" +
                                                 std::to_string(version) + ".3dm' " + std::to_string(version));
        EXPECT_EQ(result.code, 0) << result.output;
    }
}

}  // namespace ripstop::testing
