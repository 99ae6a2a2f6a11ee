#include "ripstop/base/union_find.h"

#include <gmock/gmock.h>

#include <random>

namespace ripstop {
namespace {

using ::testing::ElementsAre;

TEST(UnionFind, StartsWithEveryNumberAlone) {
    UnionFind sets(3);
    EXPECT_THAT(sets.numbers(), ElementsAre(0, 1, 2));
    EXPECT_EQ(sets.add(), 3);
    EXPECT_TRUE(sets.is_root(3));
}

TEST(UnionFind, KeepsTheSmallestMemberAsRoot) {
    UnionFind sets(6);
    EXPECT_TRUE(sets.join(5, 3));
    EXPECT_TRUE(sets.join(4, 5));
    EXPECT_FALSE(sets.join(3, 4));
    EXPECT_TRUE(sets.join(1, 4));
    for (const int i : {1, 3, 4, 5}) EXPECT_EQ(sets.root(i), 1);
    EXPECT_THAT(sets.numbers(), ElementsAre(0, 1, 2, 1, 1, 1));
}

TEST(UnionFind, KeepsTheRootItIsJoinedInto) {
    UnionFind sets(4);
    sets.join_into(0, 3);
    sets.join_into(1, 0);
    EXPECT_EQ(sets.root(1), 3);
    EXPECT_FALSE(sets.is_root(0));
    EXPECT_TRUE(sets.is_root(3));
    EXPECT_THAT(sets.numbers(), ElementsAre(0, 0, 1, 0));
}

TEST(UnionFind, AgreesWithSetsMergedByHand) {
    constexpr int count = 200;
    std::mt19937 random(7);
    std::vector<int> set(count);
    std::iota(set.begin(), set.end(), 0);
    UnionFind sets(count);
    for (int step = 0; step < 150; ++step) {
        const int i = static_cast<int>(random() % count), j = static_cast<int>(random() % count);
        const int low = std::min(set[at(i)], set[at(j)]), high = std::max(set[at(i)], set[at(j)]);
        EXPECT_EQ(sets.join(i, j), low != high);
        std::replace(set.begin(), set.end(), high, low);
    }
    for (int i = 0; i < count; ++i) EXPECT_EQ(sets.root(i), set[at(i)]);
}

}  // namespace
}  // namespace ripstop
