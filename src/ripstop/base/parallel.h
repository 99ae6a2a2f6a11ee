#pragma once

#include <functional>

namespace ripstop {

/// Calls `task(0) … task(count - 1)`, each once, on up to `threads` threads (0: one a core). Tasks must not depend on
/// one another, so the result is the same on any number of threads. The exception of the lowest-numbered failing task
/// is rethrown after all running ones have ended.
void parallel_for(int count, int threads, const std::function<void(int)>& task);

/// What `threads` = 0 stands for here.
int available_threads();

}  // namespace ripstop
