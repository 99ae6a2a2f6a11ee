#include "ripstop/inflate/joints.h"

#include <gtest/gtest.h>

namespace ripstop {
namespace joints_test {

void expect_place(const SewnPoint& found, const SewnPoint& expected) {
    ASSERT_EQ(found.shares.size(), expected.shares.size());
    for (std::size_t i = 0; i < found.shares.size(); ++i) {
        EXPECT_EQ(found.shares[i].node, expected.shares[i].node);
        EXPECT_EQ(found.shares[i].turns, expected.shares[i].turns);
        EXPECT_NEAR(found.shares[i].weight, expected.shares[i].weight, 1e-15);
    }
}

TEST(Joints, TheLaterPointHangsOnTheEarlierTurnedBack) {
    // 7 rotated by two sectors is 3, so 7 is 3 rotated by six of eight.
    Joints joints(10, 8);
    EXPECT_TRUE(joints.join({{{3, 1, 0}}}, {{{7, 1, 2}}}));
    EXPECT_TRUE(joints.is_free(3));
    EXPECT_FALSE(joints.is_free(7));
    expect_place(joints.resolved({{{7, 1, 0}}}), {{{3, 1, 6}}});
    expect_place(joints.resolved({{{7, 1, 2}}}), {{{3, 1, 0}}});
    // The same in the other order.
    Joints other(10, 8);
    EXPECT_TRUE(other.join({{{7, 1, 2}}}, {{{3, 1, 0}}}));
    expect_place(other.resolved({{{7, 1, 0}}}), {{{3, 1, 6}}});
}

TEST(Joints, WeightsAndTurnsAreCarriedThrough) {
    Joints joints(10, 8);
    EXPECT_TRUE(joints.join({{{8, 1, 1}}}, {{{1, 0.25, 0}, {2, 0.75, 3}}}));
    expect_place(joints.resolved({{{8, 1, 0}}}), {{{1, 0.25, 7}, {2, 0.75, 2}}});
    EXPECT_TRUE(joints.join({{{2, 1, 0}}}, {{{0, 1, 5}}}));
    expect_place(joints.resolved({{{8, 1, 1}}}), {{{0, 0.75, 0}, {1, 0.25, 0}}});
}

TEST(Joints, WhatHangsOffAChordKeepsItsWayOffIt) {
    // 8, rotated by a quarter turn, hangs 10 mm outside of the midpoint between 1 and 2.
    Joints joints(10, 4);
    const SewnPoint chord{{{1, 0.5, 0}, {2, 0.5, 0}}, Vec3(0, 0.01, 0.002)};
    EXPECT_TRUE(joints.join({{{8, 1, 1}}}, chord));
    const SewnPoint turned_on = joints.resolved({{{8, 1, 1}}}), first = joints.resolved({{{8, 1, 0}}});
    EXPECT_LT((turned_on.offset - chord.offset).norm(), 1e-15);
    EXPECT_LT((first.offset - Vec3(0.01, 0, 0.002)).norm(), 1e-15);
    // The midpoint between 8 and 9 is half as far off.
    EXPECT_LT((joints.resolved({{{8, 0.5, 0}, {9, 0.5, 0}}}).offset - Vec3(0.005, 0, 0.001)).norm(), 1e-15);
}

TEST(Joints, NothingComesToHangOnItself) {
    Joints joints(10, 1);
    EXPECT_TRUE(joints.join({{{4, 1, 0}}}, {{{2, 0.5, 0}, {3, 0.5, 0}}}));
    // 2 would be the midpoint between 4, which hangs on it, and 5.
    EXPECT_FALSE(joints.join({{{2, 1, 0}}}, {{{4, 0.5, 0}, {5, 0.5, 0}}}));
    EXPECT_TRUE(joints.is_free(2));
    EXPECT_TRUE(joints.join({{{4, 1, 0}}}, {{{5, 1, 0}}}));  // 5 is free to follow
    expect_place(joints.resolved({{{5, 1, 0}}}), {{{2, 0.5, 0}, {3, 0.5, 0}}});
}

TEST(Joints, APointThatIsItselfTurnedIsOnTheAxis) {
    Joints joints(10, 8);
    EXPECT_TRUE(joints.join({{{6, 1, 0}}}, {{{6, 1, 1}}}));
    EXPECT_EQ(joints.on_axis(), std::set<int>{6});
    EXPECT_TRUE(joints.join({{{6, 1, 2}}}, {{{6, 1, 2}}}));
    EXPECT_EQ(joints.on_axis().size(), 1u);
}

}  // namespace joints_test
}  // namespace ripstop
