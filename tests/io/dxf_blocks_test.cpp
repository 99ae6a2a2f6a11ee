#include "ripstop/io/dxf/dxf_blocks.h"

#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <set>

#include "support/dxf_pieces.h"

/// Checks every statement of docs/dialects.md on the dialects with blocks.
namespace ripstop {
namespace dxf_blocks_test {

using ::testing::Contains;
using testing::dxf_entities;
using testing::dxf_of;
using testing::dxf_pairs;
using testing::DxfPairs;
using ::testing::IsSupersetOf;
using ::testing::Not;
using testing::sample_piece;
using testing::sample_pieces;
using testing::value_of;

std::vector<std::string> texts(const std::string& dxf, const std::string& layer = "1") {
    std::vector<std::string> found;
    for (const DxfPairs& text : dxf_entities(dxf_pairs(dxf), "TEXT"))
        if (value_of(text, 8) == layer) found.push_back(value_of(text, 1));
    return found;
}

std::set<std::string> layers_of(const std::string& dxf, const std::string& kind) {
    std::set<std::string> layers;
    for (const DxfPairs& entity : dxf_entities(dxf_pairs(dxf), kind)) layers.insert(value_of(entity, 8));
    return layers;
}

std::vector<std::string> sections(const std::string& dxf) {
    std::vector<std::string> found;
    for (const DxfPairs& section : dxf_entities(dxf_pairs(dxf), "SECTION")) found.push_back(value_of(section, 2));
    return found;
}

TEST(DxfBlocks, PutEachPieceInABlockInsertedOnceAtTheOrigin) {
    for (const char* dialect : {"aama", "astm", "gerber", "clo", "et"}) {
        const std::vector<PatternPiece> pieces = sample_pieces();
        const DxfPairs all = dxf_pairs(dxf_of(pieces, dialect));
        const std::vector<DxfPairs> blocks = dxf_entities(all, "BLOCK"), inserts = dxf_entities(all, "INSERT");
        ASSERT_EQ(blocks.size(), pieces.size());
        ASSERT_EQ(inserts.size(), pieces.size());
        for (std::size_t i = 0; i < blocks.size(); ++i) {
            EXPECT_EQ(value_of(blocks[i], 2), value_of(inserts[i], 2));
            EXPECT_EQ(value_of(blocks[i], 70), "64");
            EXPECT_EQ(value_of(blocks[i], 8), std::string(dialect) == "et" ? "1" : "0");
            EXPECT_EQ(value_of(inserts[i], 8), "1");
            for (const int code : {10, 20}) EXPECT_EQ(std::stod(value_of(inserts[i], code)), 0);
        }
        EXPECT_EQ(value_of(blocks[0], 2), "G01P03_ONE");
    }
}

TEST(DxfBlocks, UseNumberedLayersOnlyAndNeverLayer0) {
    for (const char* dialect : {"aama", "astm", "gerber", "clo", "et"}) {
        const std::string dxf = dxf_of(sample_pieces(), dialect);
        EXPECT_EQ(layers_of(dxf, "POLYLINE"), (std::set<std::string>{"1", "8", "14"}));
        EXPECT_EQ(layers_of(dxf, "TEXT"), (std::set<std::string>{"1", "15"}));
        EXPECT_THAT(layers_of(dxf, "POINT"), IsSupersetOf({"2", "3"}));
        EXPECT_THAT(layers_of(dxf, "LINE"), Contains("7"));
        for (const char* kind : {"POLYLINE", "VERTEX", "SEQEND", "TEXT", "POINT", "LINE", "INSERT"})
            EXPECT_THAT(layers_of(dxf, kind), Not(Contains("0"))) << kind;
    }
}

/// The polylines of a layer in the first block, as corners.
std::vector<std::vector<Vec2>> lines_on(const std::string& dxf, const std::string& layer,
                                        std::string* flags = nullptr) {
    std::vector<std::vector<Vec2>> lines;
    bool is_taken = false;
    for (const DxfPairs& entity : dxf_entities(dxf_pairs(dxf))) {
        const std::string& kind = entity.front().second;
        if (kind == "ENDBLK") break;
        if (kind == "POLYLINE") {
            is_taken = value_of(entity, 8) == layer;
            if (is_taken) lines.emplace_back();
            if (is_taken && flags) *flags += value_of(entity, 70);
        }
        if (kind == "VERTEX" && is_taken)
            lines.back().emplace_back(std::stod(value_of(entity, 10)), std::stod(value_of(entity, 20)));
    }
    return lines;
}

TEST(DxfBlocks, DrawContoursAsEdgesThatTouchWhereTheDialectSaysSo) {
    for (const char* dialect : {"aama", "astm", "gerber"})
        for (const char* layer : {"1", "14"}) {
            std::string flags;
            const auto edges = lines_on(dxf_of({sample_piece("A")}, dialect), layer, &flags);
            ASSERT_EQ(edges.size(), 4U);
            EXPECT_EQ(flags, "0000");
            for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(edges[i].back(), edges[(i + 1) % 4].front());
        }
    for (const char* dialect : {"clo", "et"}) {
        std::string flags;
        EXPECT_EQ(lines_on(dxf_of({sample_piece("A")}, dialect), "1", &flags).size(), 1U);
        EXPECT_EQ(flags, "1");
    }
}

TEST(DxfBlocks, MarkCornersAndTheOtherPointsOfContours) {
    std::map<std::string, int> points;
    for (const DxfPairs& point : dxf_entities(dxf_pairs(dxf_of({sample_pieces()[3]}, "aama")), "POINT"))
        ++points[value_of(point, 8)];
    const PatternPiece gore = sample_pieces()[3];
    EXPECT_GE(points["2"], 4) << "two tips on both lines";
    EXPECT_EQ(points["2"] + points["3"], gore.sew_line.rows() + gore.cut_line.rows());
}

TEST(DxfBlocks, StateTheUnitTheStyleAndThePiece) {
    DxfOptions options;
    options.style = "balloon.obj";
    options.revision = "B";
    options.date = "2026-11-02";
    PatternPiece piece = sample_piece("G01P03");
    EXPECT_THAT(texts(dxf_of({piece}, "aama", options)),
                IsSupersetOf({"Style Name: balloon.obj rev B", "Creation Date: 11-02-2026", "Author: Ripstop",
                              "Sample Size: ONE", "Units: METRIC", "Piece Name: G01P03", "SIZE: ONE", "Quantity: 3",
                              "ANNOTATION: 2 as drawn and 1 mirrored", "CATEGORY: 03", "Fabric: nylon"}));
    EXPECT_THAT(texts(dxf_of({piece}, "astm", options)),
                IsSupersetOf({"ASTM/D13Proposal 1 Version: D 6673-04", "Quantity: 2,1", "Units: METRIC"}));
    EXPECT_THAT(texts(dxf_of({piece}, "clo", options)), IsSupersetOf({"PIECE NAME: G01P03", "SIZE: ONE", "QUANTITY: 3",
                                                                      "UNITS: METRIC", "CREATION DATE: 02-11-2026"}));
    piece.quantity = piece.quantity_mirrored = 0;
    EXPECT_THAT(texts(dxf_of({piece}, "gerber")),
                IsSupersetOf({"Quantity: 0,0", "ANNOTATION: cut by the pattern of an equal piece"}));
    EXPECT_THAT(dxf_of({piece}, "gerber"), Not(::testing::HasSubstr("Creation"))) << "no date was given";
}

TEST(DxfBlocks, MarkNotchesAsTheDialectDoes) {
    const std::vector<PatternPiece> pieces{sample_piece("A")};
    const auto notches = [&pieces](const char* dialect, const char* kind) {
        std::vector<DxfPairs> found;
        for (const DxfPairs& entity : dxf_entities(dxf_pairs(dxf_of(pieces, dialect)), kind))
            if (value_of(entity, 8) == "4") found.push_back(entity);
        return found;
    };
    struct Expected {
        const char *dialect, *depth, *width;
    };
    for (const Expected& e :
         {Expected{"aama", "0.0000", ""}, Expected{"astm", "4.0000", ""}, Expected{"gerber", "-4.0000", "3.0000"}}) {
        const std::vector<DxfPairs> found = notches(e.dialect, "POINT");
        ASSERT_EQ(found.size(), 3U) << "one single and one double";
        EXPECT_EQ(value_of(found[0], 10), "410.0000") << "on the cut line";
        EXPECT_EQ(value_of(found[0], 30), e.depth) << e.dialect;
        EXPECT_EQ(value_of(found[0], 39), e.width) << e.dialect;
        EXPECT_EQ(value_of(found[0], 50), "180.0000") << "inwards";
    }
    // The drawing is rotated, so the right edge becomes the upper one.
    EXPECT_EQ(value_of(notches("clo", "POINT").at(0), 50), "270.0000");
    const std::vector<DxfPairs> slits = notches("et", "LINE");
    ASSERT_EQ(slits.size(), 3U);
    EXPECT_EQ(value_of(slits[0], 10), "410.0000");
    EXPECT_EQ(value_of(slits[0], 11), "406.0000");
    EXPECT_TRUE(notches("et", "POINT").empty());
}

TEST(DxfBlocks, GiveGerberNothingButPieces) {
    const std::string dxf = dxf_of(sample_pieces(), "gerber");
    EXPECT_EQ(sections(dxf), (std::vector<std::string>{"HEADER", "BLOCKS", "ENTITIES"}));
    EXPECT_TRUE(dxf.starts_with("  0\r\nSECTION\r\n  2\r\nHEADER\r\n  0\r\nENDSEC\r\n"));
    std::vector<std::string> copies;
    for (const DxfPairs& line : dxf_entities(dxf_pairs(dxf), "LINE"))
        copies.push_back(value_of(line, 8) + " " + value_of(line, 10) + " " + value_of(line, 21));
    ASSERT_EQ(copies.size(), 6U) << "three pieces with a grain line";
    EXPECT_EQ(copies[0].substr(1), copies[1].substr(1));
    EXPECT_EQ(copies[0][0], '7');
    EXPECT_EQ(copies[1][0], '5');
}

TEST(DxfBlocks, GiveCloRelease10AndOldCadItsFirstLine) {
    const std::string clo = dxf_of(sample_pieces(), "clo");
    EXPECT_THAT(clo, ::testing::HasSubstr("AC1006"));
    EXPECT_EQ(sections(clo), (std::vector<std::string>{"HEADER", "BLOCKS", "ENTITIES"}));
    EXPECT_TRUE(dxf_of(sample_pieces(), "et").starts_with("999\r\nANSI/AAMA\r\n"));
}

TEST(DxfBlocks, StateUnitsInTheHeaderOnlyForCam) {
    for (const char* dialect : {"aama", "astm", "gerber", "clo", "et"})
        EXPECT_THAT(dxf_of(sample_pieces(), dialect), Not(::testing::HasSubstr("$INSUNITS"))) << dialect;
    EXPECT_THAT(dxf_of(sample_pieces(), "cam"), ::testing::HasSubstr("$INSUNITS"));
}

}  // namespace dxf_blocks_test
}  // namespace ripstop
