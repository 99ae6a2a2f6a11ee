#include "ripstop/pipeline/read/name_tiles.h"

#include <gmock/gmock.h>

#include <sstream>

#include "ripstop/base/error.h"
#include "ripstop/io/json/project_json.h"
#include "support/refusal.h"
#include "support/shapes.h"

namespace ripstop {
namespace name_tiles_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Four sheets side by side along x, 1 m each.
CadModel sheets() {
    CadModel model;
    for (int i = 0; i < 4; ++i) {
        TriangleMesh mesh = testing::rectangle(1, 1, 3, 3);
        mesh.positions.col(0).array() += i;
        model.surfaces.push_back({"envelope_0" + std::to_string(i), std::move(mesh)});
    }
    return model;
}

Project project_of(const std::string& tiles) {
    std::istringstream in(R"({"tiles": )" + tiles + "}");
    return read_project(in, "plan.json");
}

std::vector<std::string> named(const std::string& tiles) {
    CadModel model = sheets();
    name_tiles(model, project_of(tiles));
    std::vector<std::string> names;
    for (const NamedMesh& surface : model.surfaces) names.push_back(surface.name);
    return names;
}

std::string refusal(const std::string& tiles) {
    return testing::refusal([&] { named(tiles); });
}

TEST(NameTiles, CallsSurfacesByTheirNameInTheFileOrAPointOnThem) {
    EXPECT_THAT(named(R"([{"name": "A", "source": "envelope_02"}, {"name": "B", "at": [0.5, 0.4, 0]}, {"name": "*"}])"),
                ElementsAre("B", "envelope_01", "A", "envelope_03"));
    EXPECT_THAT(named(R"([{"name": "A", "at": [3.5, 0.5, 0.1]}, {"name": "B", "at": [2.01, -0.05, 0.02]}])"),
                ElementsAre("envelope_00", "envelope_01", "B", "A"))
        << "a point beside the surface means it too";
}

TEST(NameTiles, ExchangesNames) {
    EXPECT_THAT(
        named(
            R"([{"name": "envelope_01", "source": "envelope_00"}, {"name": "envelope_00", "source": "envelope_01"}])"),
        ElementsAre("envelope_01", "envelope_00", "envelope_02", "envelope_03"));
}

TEST(NameTiles, RefusesASourceThatIsNotThere) {
    EXPECT_THAT(refusal(R"([{"name": "A", "source": "envelope_2"}])"),
                HasSubstr("plan.json: tile \"A\": no surface of the file is called \"envelope_2\", expected a name"));
    CadModel model = sheets();
    model.unread.push_back({"shell", "SubD", "mesh it first"});
    try {
        name_tiles(model, project_of(R"([{"name": "A", "source": "shell"}])"));
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_THAT(
            error.what(),
            HasSubstr("no surface of the file is called \"shell\", only an object that cannot be read: mesh it first"));
    }
}

TEST(NameTiles, RefusesASourceThatIsThereTwice) {
    CadModel model = sheets();
    model.surfaces[1].name = model.surfaces[0].name;
    EXPECT_THROW(name_tiles(model, project_of(R"([{"name": "A", "source": "envelope_00"}])")), InputError);
    EXPECT_NO_THROW(name_tiles(model, project_of(R"([{"name": "A", "at": [0.5, 0.5, 0]}])")));
}

TEST(NameTiles, RefusesAPointFarFromEverySurfaceOrAsNearToTwo) {
    EXPECT_THAT(refusal(R"([{"name": "A", "at": [500, 500, 0]}])"),
                HasSubstr("away from the nearest surface, \"envelope_03\", expected a point on a surface"));
    EXPECT_THAT(refusal(R"([{"name": "A", "at": [1, 0.5, 0]}])"),
                HasSubstr("is as near to \"envelope_00\" as to \"envelope_01\""));
    EXPECT_THAT(refusal(R"([{"name": "A", "at": [1e300, 0, 0]}])"), HasSubstr("away from the nearest surface"));
}

TEST(NameTiles, RefusesTwoNamesForASurfaceAndANameForTwo) {
    EXPECT_THAT(refusal(R"([{"name": "A", "source": "envelope_00"}, {"name": "B", "at": [0.5, 0.5, 0]}])"),
                HasSubstr("the surface \"envelope_00\" is called \"A\" by another entry"));
    EXPECT_THAT(refusal(R"([{"name": "envelope_01", "source": "envelope_00"}])"),
                HasSubstr("tile \"envelope_01\": another surface of the file has the same name"));
}

}  // namespace name_tiles_test
}  // namespace ripstop
