#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "ripstop/nest/contact_table.h"
#include "ripstop/nest/strip.h"

namespace ripstop {

struct OrderSearch {
    int rounds = 40;         ///< over the whole strip
    std::uint32_t seed = 1;  ///< another one, another search
    std::function<void()> after_round = {};
};

/// Items, one for each of `kinds`, on a short marker, in the order they were laid in.
///
/// Begins bottom-left: kinds in a random order, each where it lies furthest to the start. Then simulated annealing
/// [KGV83] in a window of 24 items that goes over the strip `rounds` times: items change places, are turned, moved
/// across the roll or laid elsewhere. A change is judged by the moment of the window and 26 items after it about the
/// roll's start, sum of area times place, so that it costs the same however long the roll is. The same arguments, the
/// same order. O(rounds #items reach).
std::vector<PlacedItem> search_order(const Strip& strip, const ContactTable& contacts, std::vector<int> kinds,
                                     const OrderSearch& search);

}  // namespace ripstop
