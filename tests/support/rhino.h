#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace ripstop::testing {

/// True if openNURBS is available: node, and rhino3dm in apps/rhino/node_modules.
bool has_rhino();

/// What openNURBS says about a file: `tests/rhino/rhino.mjs describe`.
nlohmann::json described_by_rhino(const std::string& file);

/// Lets openNURBS write a scene (as `tests/rhino/rhino.mjs` reads it) in each of these versions (2 to 8), beside
/// `scene_file`, which gets the scene itself: `envelope.json` gives `envelope_v3.3dm`, … Fails the test on an
/// error.
void write_by_rhino(const nlohmann::json& scene, const std::string& scene_file, const std::vector<int>& versions);

}  // namespace ripstop::testing

/// Skips the test if openNURBS is not available.
#define RIPSTOP_REQUIRE_RHINO() \
    if (!::ripstop::testing::has_rhino()) GTEST_SKIP() << "no node with rhino3dm here: npm ci in apps/rhino"
