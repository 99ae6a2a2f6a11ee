#pragma once

#include "ripstop/model/plan/verdict.h"

namespace ripstop {

/// Is a half of a tile nearer to being made than the whole? It has no finding of a kind that the whole has not, and of
/// each kind its worst is less than the whole's, in shares of the limit (of 1 where the limit is 0). How many edges are
/// off their length does not count: a half has edges of its own. Cost: O(findings).
bool is_better(const Verdict& half, const Verdict& whole);

}  // namespace ripstop
