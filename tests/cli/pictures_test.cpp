#include <gmock/gmock.h>

#include <map>
#include <nlohmann/json.hpp>

#include "support/program.h"
#include "support/raster.h"
#include "support/sanitized.h"
#include "support/shared_data.h"

namespace ripstop {
namespace pictures_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::ProgramRun;
using testing::Workshop;

std::vector<std::string> png_names(const Workshop& workshop, const std::string& plan) {
    std::vector<std::string> names;
    for (const auto& [name, bytes] : workshop.files(plan))
        if (name.ends_with(".png")) names.push_back(name);
    return names;
}

TEST(PicturesOfFlatten, AreWrittenOnlyWhereAsked) {
    const Workshop workshop;
    workshop.write_tiles("envelope.obj", {testing::flat_tile("dráček"), testing::curved_tile()});
    ASSERT_EQ(workshop.ripstop("flatten envelope.obj --unit m -o plain --reproducible").code, 1);
    ASSERT_EQ(workshop.ripstop("flatten envelope.obj --unit m -o plan --reproducible --pictures").code, 1);
    EXPECT_THAT(png_names(workshop, "plain"), ElementsAre());
    EXPECT_THAT(
        png_names(workshop, "plan"),
        ElementsAre("pictures/dracek.png", "pictures/envelope-area.png", "pictures/envelope-edges.png",
                    "pictures/envelope-shear.png", "pictures/envelope-tension.png", "pictures/envelope-warp.png",
                    "pictures/envelope-weft.png", "pictures/envelope.png", "pictures/sphere.png"));
    std::map<std::string, std::string> others = workshop.files("plan");
    std::erase_if(others, [](const auto& file) { return file.first.ends_with(".png"); });
    EXPECT_EQ(others, workshop.files("plain")) << "nothing else differs";
}

TEST(PicturesOfFlatten, OfOneTileHaveTheSameBytesOnAnyNumberOfThreads) {
    const Workshop workshop;
    workshop.write_tiles("tile.obj", {testing::bent_tile()});
    ASSERT_EQ(workshop.ripstop("flatten tile.obj --unit m -o a --reproducible --pictures -j 1").code, 0);
    ASSERT_EQ(workshop.ripstop("flatten tile.obj --unit m -o b --reproducible --pictures -j 3").code, 0);
    EXPECT_EQ(workshop.files("a"), workshop.files("b"));
    for (const std::string& name : png_names(workshop, "a"))
        EXPECT_GT(testing::read_png(workshop.read("a/" + name)).height, 300) << name;
}

TEST(PicturesOfFlatten, OfADressShowEachPanelAndTheWorstSeams) {
    RIPSTOP_TOO_LONG_SANITIZED();
    RIPSTOP_REQUIRE_SHARED(dress, "dress/dress_knife_drape_3d.obj");
    const Workshop workshop;
    const ProgramRun run =
        workshop.ripstop("flatten '" + dress.string() + "' --unit m --method lscm --propose none -o plan --pictures");
    ASSERT_EQ(run.code, 1) << run.err;
    const nlohmann::json report = nlohmann::json::parse(workshop.read("plan/report.json"));
    std::size_t seams = 0, panels = 0;
    for (const std::string& name : png_names(workshop, "plan")) {
        seams += name.starts_with("pictures/seam-");
        panels += name.starts_with("pictures/panel_");
        EXPECT_GT(testing::read_png(workshop.read("plan/" + name)).height, 300) << name;
    }
    EXPECT_EQ(seams, 24u);
    EXPECT_THAT(run.err, HasSubstr("Pictures of the 24 worst of "));
    EXPECT_EQ(panels, report["tiles"].size());
}

}  // namespace pictures_test
}  // namespace ripstop
