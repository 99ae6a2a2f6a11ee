#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace ripstop::testing {

/// Whether openNURBS is here to ask: node, and rhino3dm in apps/rhino/node_modules.
bool has_rhino();

/// What openNURBS says of a file: `tests/rhino/rhino.mjs describe`.
nlohmann::json described_by_rhino(const std::string& file);

/// Has openNURBS write a file in each of the versions (2 to 8) of a scene, as `tests/rhino/rhino.mjs` reads it, beside
/// `scene_file`, where the scene itself goes: `envelope.json` gives `envelope_v3.3dm`, … Fails the test where it does not.
void write_by_rhino(const nlohmann::json& scene, const std::string& scene_file, const std::vector<int>& versions);

}  // namespace ripstop::testing

/// Skips the test where openNURBS is not here to ask.
#define RIPSTOP_REQUIRE_RHINO() \
    if (!::ripstop::testing::has_rhino()) GTEST_SKIP() << "no node with rhino3dm here: npm ci in apps/rhino"
