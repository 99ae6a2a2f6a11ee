#include "ripstop/report/page/packed_arrays.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ripstop {
namespace packed_arrays_test {

int byte_at(const PackedArrays& arrays, std::size_t i) {
    return static_cast<unsigned char>(arrays.bytes()[i]);
}

TEST(PackedArrays, HoldEqualArraysOnce) {
    PackedArrays arrays;
    const int first = arrays.add({1, 2, 3});
    const int second = arrays.add({1, 2});
    EXPECT_NE(first, second);
    EXPECT_EQ(arrays.add({1, 2, 3}), first);
    EXPECT_EQ(arrays.places().size(), 2u);
}

TEST(PackedArrays, StartAtMultiplesOfFourBytes) {
    PackedArrays arrays;
    arrays.add({1, 2, 3});
    arrays.add({4});
    EXPECT_EQ(arrays.places()[1].start, 8u);
    EXPECT_EQ(arrays.places()[1].length, 2u);
    EXPECT_EQ(arrays.bytes().size(), 12u);
}

TEST(PackedArrays, AreLittleEndianInTwosComplement) {
    PackedArrays arrays;
    arrays.add({-2, 258});
    EXPECT_EQ(byte_at(arrays, 0), 0xfe);
    EXPECT_EQ(byte_at(arrays, 1), 0xff);
    EXPECT_EQ(byte_at(arrays, 2), 2);
    EXPECT_EQ(byte_at(arrays, 3), 1);
}

TEST(PackedArrays, HoldStepsFromRowToRowAroundTheEnd) {
    PackedArrays arrays;
    arrays.add_steps(std::vector<std::uint16_t>{5, 65535, 7, 1}, 2);  // 5 65535, then +2 and +2 modulo 65536
    EXPECT_EQ(byte_at(arrays, 0), 5);
    EXPECT_EQ(byte_at(arrays, 2), 0xff);
    EXPECT_EQ(byte_at(arrays, 4), 2);
    EXPECT_EQ(byte_at(arrays, 6), 2);
    EXPECT_EQ(byte_at(arrays, 7), 0);
}

TEST(SteppedValues, AreWithinHalfAStepAndTellWhatIsNoNumber) {
    Eigen::VectorXd values(4);
    values << 0.5, -0.25, std::numeric_limits<double>::quiet_NaN(), 1e-6;
    const SteppedValues map = stepped(values, 1e-6);
    EXPECT_LE(map.step, 2 * 0.5 / 32767);
    for (const Eigen::Index i : {0, 1, 3})
        EXPECT_NEAR(map.values[static_cast<std::size_t>(i)] * map.step, values[i], map.step / 2);
    EXPECT_EQ(map.values[2], std::numeric_limits<std::int16_t>::min());
}

TEST(SteppedValues, HaveTheSameStepForNearlyTheSameValues) {
    const Eigen::VectorXd values = Eigen::VectorXd::LinSpaced(9, -0.01, 0.013);
    EXPECT_EQ(stepped(values, 1e-6).step, stepped(values * (1 + 1e-12), 1e-6).step);
    EXPECT_EQ(stepped(Eigen::VectorXd::Zero(3), 1e-6).step, 1e-6);
}

TEST(GridPoints, AreWithinHalfAStepOfThePoints) {
    Eigen::MatrixXd points(3, 3);
    points << -1, 2, 30, 4, 2, 30.5, 1.2345678, 2, 30.25;
    const GridPoints grid = on_grid(points);
    EXPECT_NEAR(grid.step, 5.0 / 65535, 1e-15);
    for (Eigen::Index i = 0; i < 3; ++i)
        for (Eigen::Index k = 0; k < 3; ++k)
            EXPECT_NEAR(grid.lower[k] + grid.step * grid.values[static_cast<std::size_t>(3 * i + k)], points(i, k),
                        0.500001 * grid.step);
}

TEST(GridPoints, StandASinglePlace) {
    const GridPoints grid = on_grid(Eigen::MatrixXd::Constant(2, 2, 7));
    EXPECT_EQ(grid.values, (std::vector<std::uint16_t>{0, 0, 0, 0}));
    EXPECT_EQ(grid.lower[0], 7);
}

}  // namespace packed_arrays_test
}  // namespace ripstop
