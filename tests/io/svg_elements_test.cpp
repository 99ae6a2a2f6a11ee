/// Elements of SVG as browsers treat them: units, viewports, uses, styles, text.
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "ripstop/base/error.h"
#include "ripstop/geometry/polygon.h"
#include "ripstop/io/svg/svg_read.h"
#include "ripstop/pattern/drawing/check_drawing.h"

namespace ripstop {
namespace svg_elements_test {

using ::testing::HasSubstr;

PatternDrawing read(const std::string& text) {
    std::istringstream in(text);
    return read_svg(in, "a.svg");
}

PatternDrawing read_body(const std::string& body) {
    return read("<svg width='200mm' height='100mm' viewBox='0 0 200 100'>" + body + "</svg>");
}

/// Left, top, right and bottom of the only line, y down.
Eigen::RowVector4d box_of(const PatternDrawing& drawing) {
    EXPECT_EQ(drawing.paths.size(), 1U);
    if (drawing.paths.size() != 1) return Eigen::RowVector4d::Zero();
    const Points2& points = drawing.paths[0].points;
    return {points.col(0).minCoeff(), -points.col(1).maxCoeff(), points.col(0).maxCoeff(), -points.col(1).minCoeff()};
}

void expect_box(const PatternDrawing& drawing, const Eigen::RowVector4d& wanted) {
    EXPECT_LT((box_of(drawing) - wanted).norm(), 1e-9) << box_of(drawing) << " instead of " << wanted;
}

/// The sentence on the only entity that is not read.
std::string unread_of(const PatternDrawing& drawing) {
    return drawing.unread.size() == 1 ? unread_text(drawing.unread[0], 1e-3)
                                      : std::to_string(drawing.unread.size()) + " unread";
}

TEST(SvgElements, TakeTheUnitOfEachAttribute) {
    const double mm = 96 / 25.4;
    const std::string page = "<svg width='210mm' height='297mm'>";
    const PatternDrawing found = read(page + "<rect x='10mm' y='1cm' width='100mm' height='1in'/></svg>");
    expect_box(found, {10 * mm, 10 * mm, 110 * mm, 10 * mm + 96});
    EXPECT_DOUBLE_EQ(found.units.at(0).unit.metres, 0.0254 / 96);
    expect_box(read(page + "<rect x='1pc' y='9pt' width='40Q' height='2PX'/></svg>"), {16, 12, 16 + 10 * mm, 14});
    expect_box(read("<svg font-size='10'><g style='font-size:200%'><rect width='2em' height='2rem'/></g></svg>"),
               {0, 0, 40, 20});
}

TEST(SvgElements, SayThatAUserUnitIsAPixelWhereALengthIsInMillimetres) {
    const PatternDrawing found = read("<svg><circle r='50mm'/></svg>");
    ASSERT_EQ(found.units.size(), 1U);
    EXPECT_EQ(found.units[0].where, "r of its circle");
    EXPECT_NEAR(found.units[0].unit.metres * found.paths.at(0).points.col(0).maxCoeff(), 0.05, 1e-12);
    EXPECT_TRUE(read("<svg viewBox='0 0 9 9'><circle r='50mm'/></svg>").units.empty()) << "in a window of any size";
}

TEST(SvgElements, TakePerCentOfTheViewport) {
    expect_box(read_body("<rect x='10%' y='10%' width='50%' height='50%'/>"), {20, 10, 120, 60});
    const double both = std::hypot(200, 100) / std::sqrt(2.0);
    expect_box(read_body("<circle r='10%' cx='50%'/>"), {100 - both / 10, -both / 10, 100 + both / 10, both / 10});
    expect_box(read_body("<svg width='50%' height='20'><rect width='50%' height='50%'/></svg>"), {0, 0, 50, 10});
    const PatternDrawing unknown = read("<svg width='100%'><rect width='50%' height='9'/></svg>");
    EXPECT_TRUE(unknown.paths.empty());
    EXPECT_THAT(unread_of(unknown), HasSubstr("rect has width=\"50%\", which cannot be computed"));
    EXPECT_FALSE(check_drawing(unknown).sound());
}

TEST(SvgElements, LieInViewportsWithinEachOther) {
    expect_box(read_body("<svg x='10' y='5' width='40' height='20' viewBox='1 1 2 2'><rect x='1' y='1' width='2' "
                         "height='2'/></svg>"),
               {20, 5, 40, 25});
    expect_box(read_body("<svg width='40' height='20' viewBox='0 0 2 2' preserveAspectRatio='xMinYMax'><rect width='2' "
                         "height='2'/></svg>"),
               {0, 0, 20, 20});
    expect_box(read_body("<svg width='40' height='20' viewBox='0 0 2 2' preserveAspectRatio='none'><rect width='2' "
                         "height='2'/></svg>"),
               {0, 0, 40, 20});
    expect_box(read_body("<svg width='40' height='20' viewBox='0 0 2 2' preserveAspectRatio='xMidYMid slice' "
                         "overflow='visible'><rect width='2' height='2'/></svg>"),
               {0, -10, 40, 30});
}

TEST(SvgElements, AreStretchedWithThePage) {
    const PatternDrawing found = read(
        "<svg width='100mm' height='100mm' viewBox='0 0 50 100' preserveAspectRatio='none'><rect width='50' "
        "height='100'/></svg>");
    ASSERT_EQ(found.units.size(), 1U) << "two scales are no conflict here";
    EXPECT_DOUBLE_EQ(found.units[0].unit.metres, 2e-3);
    expect_box(found, {0, 0, 50, 50});
}

TEST(SvgElements, AreRoundWhereRadiiSaySo) {
    const PatternDrawing found = read_body("<rect width='20' height='10' ry='50%'/>");
    expect_box(found, {0, 0, 20, 10});
    // ry is 50, rx defaults to it, and they are clamped to 10 and 5: an ellipse. Chords within 0.01 lose 2/3 of
    // that along a perimeter of 48 from its area.
    EXPECT_NEAR(signed_area(found.paths[0].points), -std::numbers::pi * 50, 0.4);
    EXPECT_GT(found.paths[0].points.rows(), 40);
}

TEST(SvgElements, AreDrawnAgainWhereverTheyAreUsed) {
    const std::string defs =
        "<defs><path id='p' class='cut' d='M0 0h4v2z'/><g id='g' transform='scale(2)'><use href='#p' x='1'/></g>"
        "<symbol id='s' viewBox='0 0 4 2'><use xlink:href='#p'/></symbol></defs>";
    const PatternDrawing found = read_body(defs + "<use href='#p' x='10' y='5mm' transform='translate(1 0)'/>");
    const double y = 5 * 96 / 25.4;
    expect_box(found, {11, y, 15, y + 2});
    EXPECT_EQ(found.paths[0].layer, "cut");
    expect_box(read_body(defs + "<use id='P7' href=' #g '/>"), {2, 0, 10, 4});
    EXPECT_EQ(read_body(defs + "<use id='P7' href='#p'/>").groups.at(0).name, "P7");
    expect_box(read_body(defs + "<use href='#s' x='3' width='40' height='40'/>"), {3, 10, 43, 30});
    expect_box(read_body(defs + "<use href='#s' width='50%' height='100%' visibility='visible'/>"), {0, 25, 100, 75});
    EXPECT_TRUE(read_body(defs + "<use href='#p' visibility='hidden'/>").paths.empty());
}

TEST(SvgElements, NameUsesThatLeadNowhereOrRoundInACircle) {
    const PatternDrawing found =
        read_body("<g id='a'><use href='#b'/></g><g id='b'><use href='#a'/></g><use href='other.svg#c'/>");
    EXPECT_TRUE(found.paths.empty());
    std::string all;
    for (const UnreadEntity& entity : found.unread) all += unread_text(entity, 1e-3) + "\n";
    EXPECT_THAT(all, HasSubstr("use refers to an element that contains it"));
    EXPECT_THAT(all, HasSubstr("use refers to \"other.svg#c\", which is not in the file"));
    EXPECT_FALSE(check_drawing(found).sound());
    // Ten levels with ten uses each would be 10^10 elements.
    std::string bomb = "<svg><defs><path id='l0' d='M0 0h1'/>";
    for (int i = 1; i <= 10; ++i) {
        bomb += "<g id='l" + std::to_string(i) + "'>";
        for (int k = 0; k < 10; ++k) bomb += "<use href='#l" + std::to_string(i - 1) + "'/>";
        bomb += "</g>";
    }
    EXPECT_THROW(read(bomb + "</defs><use href='#l10'/></svg>"), InputError);
}

TEST(SvgElements, FollowStyleSheetsByTheCascade) {
    const std::string sheet =
        "<style type='text/css'><![CDATA[ /* a { } */ @import 'no.css'; path.cut, #b > rect:first-child { display:none "
        "}"
        "#b rect { display: inline } g [data-x~=\"two\"] { visibility: hidden } @media print { * { display: none } }"
        "circle { r: 5mm; transform: translate(3px, 4px) rotate(90deg) } rect:hover { display: none } ]]></style>";
    const double r = 5 * 96 / 25.4;
    expect_box(read_body(sheet + "<path class='cut' d='M0 0h9'/><circle r='1'/>"), {3 - r, 4 - r, 3 + r, 4 + r});
    EXPECT_EQ(read_body(sheet + "<g id='b'><rect width='1' height='1'/><rect width='2' height='1'/></g>").paths.size(),
              1U)
        << "#b > rect:first-child is more specific than #b rect";
    EXPECT_TRUE(read_body(sheet + "<g><path data-x='one two' d='M0 0h9'/></g>").paths.empty());
    EXPECT_THAT(unread_of(read_body(sheet)), HasSubstr("style rule (@import 'no.css') is not understood"));
    EXPECT_THAT(unread_of(read_body("<style>path:nth-child(2) { display: none }</style>")),
                HasSubstr("line 1: style rule (path:nth-child(2)) is not understood, and may hide or move lines"));
    EXPECT_TRUE(read_body("<style>path:nth-child(2) { stroke: red }</style>").unread.empty())
        << "its colour moves nothing";
}

TEST(SvgElements, FollowStyleSheetsOfManyLines) {
    const PatternDrawing found = read_body(
        "<style>\n  .a\n{\n display\n:\n none\n}\n\n#b,\n.c { visibility: hidden;\n }\n</style>\n<path class='x\na' "
        "d='M0 0h1'/>"
        "<path id='b' d='M0 0h2'/><path style='\ndisplay:\nnone' d='M0 0h3'/><path "
        "transform='\ntranslate(1\n2)\nscale(2)\n' d='M0 0h4'/>");
    expect_box(found, {1, 2, 9, 2});
    EXPECT_TRUE(found.unread.empty());
}

TEST(SvgElements, TakeWordsOfCssInAnyCaseOfLetters) {
    EXPECT_TRUE(read_body("<path d='M0 0h9' style='DISPLAY: None'/><path d='M0 0h9' display='NONE'/>").paths.empty());
    EXPECT_TRUE(read_body("<path d='M0 0h9' style='visibility:HIDDEN'/>").paths.empty());
    EXPECT_DOUBLE_EQ(read_body("<text style='font-size:X-Large'>a</text>").texts.at(0).height, 24);
}

TEST(SvgElements, LeaveOutDeclarationsThatABrowserDoesNotUnderstand) {
    expect_box(read_body("<style>rect { width: 9; height: -2px; x: 0 }</style><rect x='5' width='3' height='4'/>"),
               {0, 0, 3, 4});
    expect_box(read_body("<rect style='transform: translate(5 10)' transform='scale(2)' width='3' height='4'/>"),
               {0, 0, 6, 8});
    expect_box(read_body("<rect style='transform: rotate(90)' width='3' height='4'/>"), {0, 0, 3, 4});
    expect_box(read_body("<rect style='transform: translate(5px, 0) scale(2, 1)' width='3' height='4'/>"),
               {5, 0, 11, 4});
    EXPECT_EQ(read_body("<path d='M0 0h9' visibility='never'/>").paths.size(), 1U);
    EXPECT_EQ(read_body("<g visibility='hidden'><path d='M0 0h9' visibility='initial'/></g>").paths.size(), 1U);
    EXPECT_TRUE(read_body("<g visibility='hidden'><path d='M0 0h9' style='visibility:unset'/></g>").paths.empty());
}

TEST(SvgElements, WithoutTheirGroupStandWhereItDoesNotMoveThem) {
    expect_box(read_body("<g display='contents' transform='scale(2)'><rect width='3' height='4'/></g>"), {0, 0, 3, 4});
    EXPECT_TRUE(read_body("<rect display='contents' width='3' height='4'/>").paths.empty());
    EXPECT_THAT(unread_of(read_body("<svg display='contents'><rect width='3' height='4'/></svg>")),
                HasSubstr("svg has display: contents, which is not supported here; ungroup it"));
}

TEST(SvgElements, TurnAboutTheirOrigin) {
    const std::string turned = "<rect x='10' width='40' height='20' style='transform:rotate(90deg);transform-origin:";
    expect_box(read_body(turned + "10px 0'/>"), {-10, 0, 10, 40});
    expect_box(read_body(turned + "50% 25%'/>"), {105, -65, 125, -25});
    expect_box(read_body(turned + "top left'/>"), {-20, 10, 0, 50});
    expect_box(read_body(turned + "center;transform-box:fill-box'/>"), {20, -10, 40, 30});
    expect_box(read_body(turned + "right;transform-box:fill-box'/>"), {40, -30, 60, 10});
    EXPECT_THAT(unread_of(read_body(turned + "2ex'/>")), HasSubstr("has a transform origin that is not supported"));
}

TEST(SvgElements, WithoutAreaOfTheirViewBoxAreNotDrawn) {
    const std::string line = "<path d='M0 0h4'/>";
    EXPECT_TRUE(read_body("<svg viewBox='0 0 0 9'>" + line + "</svg>").paths.empty());
    EXPECT_EQ(read_body("<svg viewBox='0 0 9'>" + line + "</svg>").paths.size(), 1U) << "that is none";
    EXPECT_TRUE(read_body("<polygon points='1,2'/><polyline points='3'/>").paths.empty());
}

TEST(SvgElements, OfASymbolStandAtItsPlace) {
    const std::string symbol = "<symbol id='s' x='3' y='4' width='1' overflow='visible'><path d='M0 0h5v5'/></symbol>";
    expect_box(read_body(symbol + "<use href='#s' x='10'/>"), {13, 4, 18, 9});
}

TEST(SvgElements, WithStylesThatAreNotFollowedAreNamed) {
    EXPECT_THAT(unread_of(read_body("<path d='M0 0h9' style='display:var(--k)'/>")),
                HasSubstr("path has display=\"var(--k)\", which is not supported"));
    EXPECT_THAT(unread_of(read_body("<style>g { &amp; path { display: none } }</style>")),
                HasSubstr("style rule (& path) is not understood"));
    EXPECT_THAT(unread_of(read_body("<a><a><path d='M0 0h9'/></a></a>")), HasSubstr("a is inside another a"));
}

TEST(SvgElements, OfASwitchAreThoseThatABrowserTakes) {
    const PatternDrawing found = read_body(
        "<switch><foreignObject requiredExtensions='&ns_ai;'/><circle systemLanguage='fr' r='1'/><rect width='3' "
        "height='1'/>"
        "<ellipse rx='1' ry='2'/></switch>");
    expect_box(found, {0, 0, 3, 1});
    EXPECT_TRUE(found.unread.empty());
}

TEST(SvgElements, OfOtherNamespacesAreNotDrawn) {
    const PatternDrawing found = read(
        "<!DOCTYPE svg [<!ENTITY far '5'>]><s:svg xmlns:s='http://www.w3.org/2000/svg' xmlns:i='http://ns.adobe.com/x'>"
        "<i:pgf/><s:rect x='&far;' width='3' height='1'/></s:svg>");
    expect_box(found, {5, 0, 8, 1});
    EXPECT_TRUE(found.unread.empty());
}

TEST(SvgElements, ThatAreCutOffByAClipAreNamed) {
    const std::string defs = "<clipPath id='c'><rect width='10' height='10'/></clipPath>";
    EXPECT_EQ(read_body(defs + "<g clip-path='url(#c)'><path d='M1 1h9v9z'/></g>").paths.size(), 1U) << "all is seen";
    const PatternDrawing apart = read_body(defs + "<path clip-path='url(#c)' d='M11 1h9v9z'/>");
    EXPECT_TRUE(apart.paths.empty() && apart.unread.empty()) << "nothing is seen";
    const PatternDrawing part = read_body(defs + "<path clip-path='url(#c)' d='M5 1h9v9z'/>");
    EXPECT_TRUE(part.paths.empty());
    EXPECT_THAT(unread_of(part), HasSubstr("path is cut off by a clip"));
    EXPECT_FALSE(check_drawing(part).sound());
    EXPECT_THAT(unread_of(read_body("<svg width='9' height='9'><path d='M5 1h9v9z'/></svg>")),
                HasSubstr("cut off by a clip"));
}

TEST(SvgElements, ThatCannotBeCarriedAreNamedWithTheirPlace) {
    const PatternDrawing found = read_body(
        "\n<image class='photo' x='1' y='2' width='9' height='9'/>\n<text><textPath href='#p'>round</textPath></text>"
        "<foreignObject/><path d='M0 0h9' stroke='red' stroke-dasharray='4 2'/><path d='M0 0h9' filter='url(#f)'/>"
        "<path d='M0 0h8' marker-end='url(#m)'/><path d='M0 0h7' fill='none'/><path d='M0 0h7' style='rotate: "
        "30deg'/>");
    std::string all;
    for (const UnreadEntity& entity : found.unread) all += unread_text(entity, 1e-3) + "\n";
    EXPECT_THAT(all, HasSubstr("line 2: 1 image on layer photo at (1.00, -2.00) mm not checked"));
    EXPECT_THAT(all, HasSubstr("line 3: 1 textPath not checked"));
    EXPECT_THAT(all, HasSubstr("1 foreignObject not checked"));
    EXPECT_THAT(all, HasSubstr("path with dashes is read as a whole line"));
    EXPECT_THAT(all, HasSubstr("path is read without its filter"));
    EXPECT_THAT(all, HasSubstr("path is read without its markers"));
    EXPECT_THAT(all, HasSubstr("path is read although it is invisible"));
    EXPECT_THAT(all, HasSubstr("path is moved by the style rotate, which is not supported"));
    EXPECT_EQ(found.paths.size(), 4U) << "all but the one that is moved";
}

TEST(SvgElements, OfTextStandWhereTheyAreWrittenAndAreAsHighAsTheyAre) {
    const PatternDrawing found = read_body(
        "<g transform='scale(2)'><text x='1 2 3' y='50%' font-size='large'>a  <tspan "
        "font-weight='bold'>b</tspan></text></g>"
        "<text style='font: italic 12px/1.5 serif'><tspan x='10' y='20'>G01</tspan><tspan x='10' "
        "dy='1.5em'>WARP</tspan></text>"
        "<text font-size='1em'>c</text><text font-size='3vw'>d</text><text visibility='hidden'>e</text>");
    ASSERT_EQ(found.texts.size(), 5U);
    EXPECT_EQ(found.texts[0].text, "a b");
    EXPECT_EQ(found.texts[0].at, Vec2(2, -100));
    EXPECT_DOUBLE_EQ(found.texts[0].height, 36);
    EXPECT_EQ(found.texts[1].text, "G01");
    EXPECT_DOUBLE_EQ(found.texts[1].height, 12);
    EXPECT_EQ(found.texts[2].at, Vec2(10, -38));
    EXPECT_DOUBLE_EQ(found.texts[3].height, 16);
    EXPECT_DOUBLE_EQ(found.texts[4].height, 0) << "not known";
}

TEST(SvgElements, OfOldProgramsAreInTheirPixels) {
    const auto units = [](const std::string& text) { return read(text + "<path d='M0 0h1'/></svg>").units; };
    const auto inkscape = units("<svg inkscape:version='0.91 r13725' width='100mm' height='100mm'>");
    ASSERT_EQ(inkscape.size(), 2U);
    EXPECT_DOUBLE_EQ(inkscape[0].unit.metres, 0.0254 / 90);
    EXPECT_EQ(inkscape[0].where, "Inkscape 0.91 (90 px to the inch)");
    EXPECT_DOUBLE_EQ(inkscape[1].unit.metres, 0.0254 / 96);
    EXPECT_EQ(units("<svg inkscape:version='0.48.4 r9939' width='744' height='1052'>").size(), 2U);
    EXPECT_EQ(units("<svg inkscape:version='0.92.3' width='100mm' height='100mm'>").size(), 1U);
    EXPECT_EQ(units("<svg inkscape:version='0.91' width='100mm' height='50mm' viewBox='0 0 100 50'>").size(), 1U)
        << "its viewBox says how long a unit is";
    const auto illustrator = units("<!-- Generator: Adobe Illustrator 23 --><svg viewBox='0 0 595 842'>");
    ASSERT_EQ(illustrator.size(), 2U);
    EXPECT_DOUBLE_EQ(illustrator[0].unit.metres, 0.0254 / 72);
    EXPECT_THAT(
        check_drawing(read("<svg inkscape:version='0.91' width='9mm'/>")).issues.front().message,
        HasSubstr("Inkscape 0.91 (90 px to the inch) says 0.282222 mm and CSS (96 px to the inch) says 0.264583 mm"));
}

}  // namespace svg_elements_test
}  // namespace ripstop
