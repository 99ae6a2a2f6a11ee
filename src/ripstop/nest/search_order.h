#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "ripstop/nest/contact_table.h"
#include "ripstop/nest/roll_strip.h"

namespace ripstop {

struct OrderSearch {
    int rounds = 40;         ///< passes over the whole strip
    std::uint32_t seed = 1;  ///< a different seed gives a different search
    std::function<void()> after_round = {};
};

/// Searches a short marker of one item for each of `kinds`. Returns the items in the order they are laid.
///
/// Begins with a bottom-left fill: kinds in a random order, each as close to the start as it goes. Then simulated
/// annealing [KGV83] in a window of 24 items, which passes over the strip `rounds` times. A change swaps, turns,
/// shifts across the roll or places an item again. It is judged by the moment about the roll's start, the sum of
/// area times position, of the window and 26 items after it, so its cost does not depend on the length of the
/// roll. The same arguments give the same order. O(rounds #items reach).
std::vector<PlacedItem> search_order(const Strip& strip, const ContactTable& contacts, std::vector<int> kinds,
                                     const OrderSearch& search);

}  // namespace ripstop
