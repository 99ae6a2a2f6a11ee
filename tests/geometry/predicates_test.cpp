#include "ripstop/geometry/predicates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace ripstop {
namespace predicates_test {

/// The sign in integer arithmetic: coordinates that are multiples of 2^-40 below 2^10 fit 50 bits, their products
/// 128.
int by_whole_numbers(const Vec2& a, const Vec2& b, const Vec2& c) {
    __extension__ using Wide = __int128;
    const auto whole = [](double x) { return static_cast<Wide>(std::ldexp(x, 40)); };
    const Wide det = (whole(a.x()) - whole(c.x())) * (whole(b.y()) - whole(c.y())) -
                     (whole(a.y()) - whole(c.y())) * (whole(b.x()) - whole(c.x()));
    return (det > 0) - (det < 0);
}

TEST(Orient2d, KnowsLeftRightAndOn) {
    EXPECT_EQ(orient2d({0, 0}, {1, 0}, {0.5, 1}), 1);
    EXPECT_EQ(orient2d({0, 0}, {1, 0}, {0.5, -1}), -1);
    EXPECT_EQ(orient2d({0, 0}, {1, 0}, {7, 0}), 0);
    EXPECT_EQ(orient2d({0.1, 0.1}, {0.2, 0.2}, {0.7, 0.7}), 0);
}

TEST(Orient2d, IsRightWhereRoundingDecides) {
    // A grid of adjacent doubles around (0.5, 0.5) and the line through (12, 12) and (24, 24): the textbook case
    // in which plain arithmetic gives wrong signs in patches.
    int wrong_if_plain = 0;
    const Vec2 b(12, 12), c(24, 24);
    for (int i = 0; i < 64; ++i)
        for (int j = 0; j < 64; ++j) {
            // multiples of 2^-53 exceed the integer oracle, but the answer is known: below the diagonal turns
            // right
            const Vec2 a(0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53);
            const int expected = (a.y() > a.x()) - (a.y() < a.x());
            EXPECT_EQ(orient2d(a, b, c), expected) << i << ' ' << j;
            const double plain = (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
            wrong_if_plain += ((plain > 0) - (plain < 0)) != expected;
        }
    EXPECT_GT(wrong_if_plain, 0) << "the case has become too easy to prove anything";
}

TEST(Orient2d, AgreesWithWholeNumberArithmeticOnNearlyCollinearPoints) {
    std::mt19937_64 random(5);
    std::uniform_int_distribution<long> coordinate(-(1L << 49), 1L << 49);
    std::uniform_int_distribution<long> nudge(-2, 2);
    int on_the_line = 0;
    for (int n = 0; n < 20000; ++n) {
        const auto point = [&](long x, long y) { return Vec2(std::ldexp(double(x), -40), std::ldexp(double(y), -40)); };
        const long ax = coordinate(random) / 4, ay = coordinate(random) / 4;
        const long dx = coordinate(random) >> 20, dy = coordinate(random) >> 20;
        const Vec2 a = point(ax, ay);
        const Vec2 b = point(ax + 3 * dx, ay + 3 * dy);
        const Vec2 c = point(ax + 7 * dx + nudge(random), ay + 7 * dy + nudge(random));
        const int expected = by_whole_numbers(a, b, c);
        ASSERT_EQ(orient2d(a, b, c), expected) << n;
        ASSERT_EQ(orient2d(b, c, a), expected) << n;
        ASSERT_EQ(orient2d(b, a, c), -expected) << n;
        on_the_line += expected == 0;
    }
    EXPECT_GT(on_the_line, 100);
}

}  // namespace predicates_test
}  // namespace ripstop
