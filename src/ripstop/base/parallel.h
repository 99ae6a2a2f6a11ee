#pragma once

#include <functional>

namespace ripstop {

/// Calls `task(0) … task(count - 1)`, each once, on up to `threads` threads (0: one per core). Tasks must not depend
/// on one another, so the result is the same on any number of threads. If tasks throw, the exception of the
/// lowest-numbered one is rethrown after all running tasks have ended.
void parallel_for(int count, int threads, const std::function<void(int)>& task);

/// The number of threads that `threads` = 0 stands for on this machine.
int available_threads();

}  // namespace ripstop
