// SPDX-License-Identifier: Apache-2.0
#include "core/base/ParallelFor.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

namespace core {

namespace {

/// Fewer than @p count where no more can be had.
std::vector<std::thread> startHelpers(int count, const std::function<void()>& drain)
{
    std::vector<std::thread> threads;
    try {
        threads.reserve(std::size_t(count));
        for (int helper = 0; helper < count; ++helper)
            threads.emplace_back(std::cref(drain));
    } catch (const std::system_error&) {
    } catch (const std::bad_alloc&) {
    }
    return threads;
}

} // namespace

void parallelFor(int count, const std::function<void(int)>& work, int threads)
{
    std::atomic<int> next = 0;
    std::mutex mutex;
    std::exception_ptr first; // under mutex
    const std::function<void()> drain = [&] {
        try {
            for (int index = next++; index < count; index = next++)
                work(index);
        } catch (...) {
            next = count;
            const std::lock_guard lock(mutex);
            if (!first)
                first = std::current_exception();
        }
    };
    if (threads <= 0)
        threads = std::max(1, int(std::thread::hardware_concurrency()));
    std::vector<std::thread> helpers =
        startHelpers(std::max(0, std::min(count, threads) - 1), drain);
    drain();
    for (std::thread& helper : helpers)
        helper.join();
    if (first)
        std::rethrow_exception(first);
}

} // namespace core
