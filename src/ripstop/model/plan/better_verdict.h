#pragma once

#include "ripstop/model/plan/verdict.h"

namespace ripstop {

/// Whether half of a tile is closer to manufacturable than the whole: it has no kind of finding that the whole lacks,
/// and the worst of each kind is smaller, relative to the limit (to 1 if the limit is 0). The number of edges with a
/// length error does not count, because the halves have different edges. O(findings).
bool is_better(const Verdict& half, const Verdict& whole);

}  // namespace ripstop
