// SPDX-License-Identifier: Apache-2.0
#include "core/base/ParallelFor.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace core {

void parallelFor(int count, const std::function<void(int)>& work)
{
    std::atomic<int> next = 0;
    const auto drain = [&] {
        for (int index = next++; index < count; index = next++)
            work(index);
    };
    const int helpers = std::min(count, std::max(1, int(std::thread::hardware_concurrency()))) - 1;
    std::vector<std::thread> threads;
    for (int helper = 0; helper < helpers; ++helper)
        threads.emplace_back(drain);
    drain();
    for (std::thread& thread : threads)
        thread.join();
}

} // namespace core
