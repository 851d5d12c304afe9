// SPDX-License-Identifier: Apache-2.0
#include "core/base/ParallelFor.h"

#include <atomic>
#include <cstdio>
#include <thread>

/// Two threads write one number, and nothing orders them: the thread sanitizer must say so
/// (packaging/tsan.sh), or what it says of the tests is worth nothing.
int main()
{
    std::atomic<int> arrived = 0;
    int written = 0;
    core::parallelFor(
        2,
        [&](int) {
            // Nobody writes before both are here, as taking the next index would order them; looked
            // at without an order, as that would be one.
            arrived.fetch_add(1, std::memory_order_relaxed);
            while (arrived.load(std::memory_order_relaxed) < 2)
                std::this_thread::yield();
            ++written;
        },
        2);
    std::printf("%d\n", written);
    return 0;
}
