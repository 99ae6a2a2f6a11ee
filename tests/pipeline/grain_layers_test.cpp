/// Grain lines on layers that the project names.
#include <gtest/gtest.h>

#include "ripstop/pipeline/read/grain_lines.h"
#include "support/shapes.h"

namespace ripstop {
namespace grain_layers_test {

NamedCurve line_on(const std::string& layer) {
    NamedCurve curve;
    curve.points.resize(2, 3);
    curve.points << 0.2, 0.2, 0, 0.2, 0.8, 0;
    curve.attributes["layer"] = layer;
    return curve;
}

TEST(GrainLines, LieOnTheLayersTheProjectNamesToo) {
    EXPECT_FALSE(is_grain_line(line_on("marks::yarn")));
    EXPECT_TRUE(is_grain_line(line_on("marks::yarn"), {"Yarn"}));
    EXPECT_TRUE(is_grain_line(line_on("marks::yarn"), {"other", "marks::yarn"}));
    EXPECT_FALSE(is_grain_line(line_on("marks::yarns"), {"yarn"}));
    EXPECT_TRUE(is_grain_line(line_on("marks::grain"), {"yarn"}));
    CadModel model;
    model.surfaces.push_back({"sheet", testing::rectangle(1, 1, 2, 2)});
    model.curves.push_back(line_on("marks::yarn"));
    EXPECT_TRUE(lay_grain_lines(model, {"YARN"}).empty());
    EXPECT_EQ(model.surfaces[0].attributes.count("warp"), 1U);
}

}  // namespace grain_layers_test
}  // namespace ripstop
