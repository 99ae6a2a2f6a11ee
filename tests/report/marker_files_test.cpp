#include "ripstop/plan_folder/marker_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "ripstop/base/text/units.h"
#include "ripstop/nest/nest_pieces.h"
#include "support/loose_pieces.h"
#include "support/outside.h"

namespace ripstop {
namespace marker_files_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Json = nlohmann::json;

PieceSet two_colours() {
    PieceSet set = testing::loose_set(testing::gore_like_pieces(6));
    for (std::size_t i = 0; i < set.pieces.size(); ++i) set.pieces[i].colour = i < 3 ? "red" : "blue/white";
    set.pieces[0].quantity = 2;
    set.pieces[1].quantity_mirrored = 1;
    return set;
}

Markers laid(const PieceSet& set) {
    NestOptions options;
    options.rounds = 1;
    return nest_pieces(set, options);
}

TEST(MarkerFiles, AreOneOfEachFormatForEachCloth) {
    const PieceSet set = two_colours();
    const Markers markers = laid(set);
    EXPECT_THAT(marker_stems(markers), ElementsAre("marker-isotropic-blue_white", "marker-isotropic-red"));
    const testing::ScratchDirectory scratch;
    write_marker_files(scratch.path(), set, markers, {"dxf", "svg"});
    for (const char* name : {"marker-isotropic-red.dxf", "marker-isotropic-red.svg", "marker-isotropic-blue_white.dxf"})
        EXPECT_TRUE(std::filesystem::exists(scratch.path(name))) << name;
    const std::string svg = testing::content(scratch.path("marker-isotropic-red.svg"));
    EXPECT_THAT(svg, HasSubstr("data-name=\"P1 2/2\""));
    EXPECT_THAT(svg, HasSubstr("data-name=\"P2 mirrored "));
    EXPECT_THAT(svg, HasSubstr("data-name=\"roll\""));
    EXPECT_THAT(testing::content(scratch.path("bom.csv")), HasSubstr("cloth,,isotropic,red,5,"));
    Markers one = markers;
    one.markers.resize(1);
    EXPECT_THAT(marker_stems(one), ElementsAre("marker"));
}

TEST(MarkerJson, PlacesThePiecesWhereTheyWereLaid) {
    const PieceSet set = two_colours();
    const Markers markers = laid(set);
    const Json json = Json::parse(marker_json(set, markers, {"dxf"}));
    const Json& red = json["markers"][1];
    ASSERT_EQ(red["placements"].size(), 5u);
    EXPECT_EQ(red["files"], Json::array({"marker-isotropic-red.dxf"}));
    EXPECT_NEAR(red["gross_m2"], red["length_mm"].get<double>() * 1.5e-3, 1e-9);
    EXPECT_NEAR(red["utilisation_pct"], 100 * red["net_m2"].get<double>() / red["gross_m2"].get<double>(), 1e-9);
    for (std::size_t i = 0; i < 5; ++i) {
        const Json& at = red["placements"][i];
        const Placement& placement = markers.markers[1].placements[i];
        const PatternPiece& piece = set.pieces[placement.piece];
        EXPECT_EQ(at["piece"], piece.name);
        // As in the schema: mirrored, turned, shifted.
        const double turn = at["turn_deg"].get<double>() * degree;
        const double sign = at["mirrored"] != at["face_down"] ? -1 : 1;
        const Vec2 p = piece.sew_line.row(7), m(p.x(), sign * p.y());
        const Vec2 q(std::cos(turn) * m.x() - std::sin(turn) * m.y() + at["x_mm"].get<double>() * millimetre,
                     std::sin(turn) * m.x() + std::cos(turn) * m.y() + at["y_mm"].get<double>() * millimetre);
        EXPECT_NEAR((q - Vec2(placement.placed(piece.sew_line).row(7))).norm(), 0, 1e-9);
    }
}

TEST(MarkerSchema, HoldsForWhatIsWritten) {
    const std::string python = testing::python_with("jsonschema");
    if (python.empty()) GTEST_SKIP() << "no Python with jsonschema here";
    PieceSet set = two_colours();
    set.pieces.push_back(testing::rectangle_piece("too wide", 1, 2));
    const testing::ScratchDirectory scratch;
    testing::write_text(scratch.path("marker.json"), marker_json(set, laid(set), {"dxf", "svg"}));
    testing::write_text(scratch.path("validate.py"), R"(import json, sys, jsonschema
schema, marker = (json.load(open(name)) for name in sys.argv[1:])
jsonschema.Draft202012Validator.check_schema(schema)
for error in jsonschema.Draft202012Validator(schema).iter_errors(marker): print(error.message)
)");
    EXPECT_EQ(testing::run_command(python + " " + scratch.path("validate.py") +
                                   " " RIPSTOP_SOURCE_DIR "/docs/marker.schema.json " + scratch.path("marker.json"))
                  .output,
              "");
}

TEST(MarkerTable, TellsClothAndRefusals) {
    PieceSet set = two_colours();
    set.pieces.push_back(testing::rectangle_piece("too wide", 1, 2));
    set.pieces.back().quantity = 3;
    set.pieces.back().quantity_mirrored = 1;
    set.pieces.push_back(testing::rectangle_piece("too wide as well", 1, 2));
    const std::string text = marker_table(laid(set));
    EXPECT_THAT(text, HasSubstr("isotropic  blue/white     1500       3"));
    EXPECT_THAT(text, HasSubstr("not laid: 4 x too wide is 2000 mm wide across the warp, the roll is 1500 mm"));
    EXPECT_THAT(text, HasSubstr("not laid: 1 x too wide as well is 2000 mm"));
    EXPECT_THAT(text, HasSubstr("\nnot laid in total: 5 of 13 pieces\n"));
    const Json json = Json::parse(marker_json(set, laid(set), {}));
    ASSERT_EQ(json["refused"].size(), 2u);
    EXPECT_EQ(json["refused"][0]["quantity"], 4);
}

}  // namespace marker_files_test
}  // namespace ripstop
