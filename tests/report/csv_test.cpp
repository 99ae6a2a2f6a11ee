#include "ripstop/report/tables/csv.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ripstop {
namespace csv_test {

TEST(CsvFigure, HasTheDigitsThatMeanSomething) {
    const std::pair<double, const char*> figures[] = {{0, "0"},
                                                      {7.90478793533e-12, "0"},
                                                      {-4.9e-7, "0"},
                                                      {5.1e-7, "0.000001"},
                                                      {-0.000123456789, "-0.000123"},
                                                      {0.1 + 0.2, "0.3"},
                                                      {7.000000000000001, "7"},
                                                      {9.9999999, "10"},
                                                      {33.3333333333, "33.33333"},
                                                      {1234.56789, "1234.568"},
                                                      {-1234567.89, "-1234568"},
                                                      {123456789012.0, "123456789012"}};
    for (const auto& [value, text] : figures) EXPECT_EQ(csv_figure(value), text);
}

TEST(CsvFigure, IsEmptyWhereItIsNotFinite) {
    EXPECT_EQ(csv_figure(std::nan("")), "");
    EXPECT_EQ(csv_figure(-std::numeric_limits<double>::infinity()), "");
}

}  // namespace csv_test
}  // namespace ripstop
