#include "ripstop/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace ripstop {

int available_threads() {
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void parallel_for(int count, int threads, const std::function<void(int)>& task) {
    std::atomic<int> next = 0;
    std::atomic<bool> stop = false;
    std::mutex guard;
    int first_failure = count;
    std::exception_ptr error;
    const auto work = [&] {
        for (int i = next++; i < count && !stop; i = next++) {
            try {
                task(i);
            } catch (...) {
                const std::lock_guard lock(guard);
                if (i < first_failure) {
                    first_failure = i;
                    error = std::current_exception();
                }
                stop = true;
            }
        }
    };
    const int workers = std::min(count, threads > 0 ? threads : available_threads());
    std::vector<std::jthread> pool;
    for (int i = 1; i < workers; ++i) pool.emplace_back(work);
    work();
    pool.clear();
    if (error) std::rethrow_exception(error);
}

}  // namespace ripstop
