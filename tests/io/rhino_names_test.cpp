#include "ripstop/io/rhino/rhino_names.h"

#include <gmock/gmock.h>

#include <deque>

namespace ripstop {
namespace rhino_names_test {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::Pair;

/// Objects without geometry, on layers that are called by their numbers.
class RhinoNames : public ::testing::Test {
  protected:
    RhinoNames() {
        for (int i = 0; i < 4; ++i) {
            RhinoLayer layer;
            layer.index = i;
            layer.name = std::string("L").append(std::to_string(i));
            layer.path = std::string("all::").append(layer.name);
            tables_.layers.push_back(layer);
        }
        tables_.groups = {{0, "crown"}, {1, ""}};
    }

    RhinoObject& object(const std::string& name, int layer) {
        objects_.push_back({0x20, {{}, RhinoBytes(archive_)}});
        objects_.back().name = name;
        objects_.back().layer = layer;
        return objects_.back();
    }

    RhinoPlaced& placed(const std::string& name, int layer, const std::string& path = "") {
        placed_.push_back({&object(name, layer), Eigen::Affine3d::Identity(), {}, path});
        return placed_.back();
    }

    std::vector<std::string> names() {
        std::vector<Attributes> attributes;
        for (const RhinoPlaced& p : placed_) attributes.push_back(rhino_attributes(p, tables_));
        return rhino_surface_names(placed_, attributes, "STEM");
    }

    RhinoTables tables_;
    std::vector<RhinoPlaced> placed_;

  private:
    RhinoArchive archive_{"a.3dm", std::string(32, ' '), 80};
    std::deque<RhinoObject> objects_;
};

TEST_F(RhinoNames, AreTheUserTextElseTheNameElseTheLayerElseNumbers) {
    placed("ignored", 0);
    const_cast<RhinoObject*>(placed_.back().object)->text["tile"] = "P1";
    placed("P2", 0);
    placed("", 1);
    placed("", 2);
    placed("", 2);
    EXPECT_THAT(names(), ElementsAre("P1", "P2", "L1", "STEM_01", "STEM_02"));
}

TEST_F(RhinoNames, BeginWithTheBlocksTheyAreIn) {
    placed("P1", 0, "gore_01");
    placed("", 0, "gore_01");
    placed("", 0, "gore_02");
    EXPECT_THAT(names(), ElementsAre("gore_01/P1", "gore_01/01", "gore_02"));
}

TEST_F(RhinoNames, NeverComeTwice) {
    placed("P", 0);
    placed("P", 1);
    placed("P", 1);
    placed("all::L1/P_2", 1);
    placed("all::L1/P", 2);
    EXPECT_THAT(names(), ElementsAre("all::L0/P", "all::L1/P", "all::L1/P_3", "all::L1/P_2", "all::L1/P_4"));
}

TEST_F(RhinoNames, CarryTheLayerTheGroupsAndTheTextOfObjectAndBlocks) {
    RhinoObject& block = object("gore", 3);
    block.text = {{"fabric", "nylon"}, {"colour", "red"}};
    block.groups = {0, 1};
    RhinoPlaced& part = placed("P", 1, "gore");
    part.instances = {&block};
    part.place = Eigen::AngleAxisd(3.14159265358979323846 / 2, Vec3::UnitZ());
    const_cast<RhinoObject*>(part.object)->text = {{"colour", "blue"}, {"warp", "2, 0, 1"}, {"layer", "lie"}};
    const Attributes said = rhino_attributes(part, tables_);
    EXPECT_THAT(said, Contains(Pair("fabric", "nylon")));
    EXPECT_THAT(said, Contains(Pair("colour", "blue"))) << "its own goes before the block's";
    EXPECT_THAT(said, Contains(Pair("layer", "all::L1"))) << "what the file says goes before what is written";
    EXPECT_THAT(said, Contains(Pair("group", "crown, 1")));
    double x = 1, y = 0, z = 0;
    ASSERT_EQ(std::sscanf(said.at("warp").c_str(), "%lf, %lf, %lf", &x, &y, &z), 3);
    EXPECT_NEAR(x, 0, 1e-15);
    EXPECT_EQ(y, 2);
    EXPECT_EQ(z, 1);
}

TEST_F(RhinoNames, GoByTheTileTextOfTheBlockThatHoldsThemAlone) {
    RhinoObject &gore = object("gore", 0), &part = object("part", 0);
    gore.text = {{"tile", "ONE"}, {"warp", "1, 0, 0"}};
    part.text = {{"tile", "TWO"}, {"warp", "0, 2, 0"}};
    const Eigen::Affine3d quarter(Eigen::AngleAxisd(3.14159265358979323846 / 2, Vec3::UnitZ()));
    RhinoPlaced& alone = placed("A", 0, "gore/part");
    const_cast<RhinoObject*>(alone.object)->text["tile"] = "own";
    alone.instances = {&gore, &part};
    alone.around = {Eigen::Affine3d::Identity(), quarter};
    alone.named_by = &gore;
    EXPECT_EQ(rhino_attributes(alone, tables_).at("tile"), "ONE");
    RhinoPlaced& inner = placed("A", 0, "gore/part");
    inner.instances = {&gore, &part};
    inner.around = {Eigen::Affine3d::Identity(), quarter};
    inner.named_by = &part;
    inner.named_in = "gore";
    placed("B", 0, "gore/part");
    EXPECT_THAT(names(), ElementsAre("ONE", "gore/TWO", "gore/part/B"));
    EXPECT_EQ(rhino_other_names(placed_, "unnamed"), names());
    double x = 1, y = 0, z = 1;
    const std::string warp = rhino_attributes(placed_[1], tables_).at("warp");
    ASSERT_EQ(std::sscanf(warp.c_str(), "%lf, %lf, %lf", &x, &y, &z), 3) << warp;
    EXPECT_EQ(x, -2) << "the inner block's own text is turned by the block around it";
    EXPECT_NEAR(y, 0, 1e-15);
}

}  // namespace rhino_names_test
}  // namespace ripstop
