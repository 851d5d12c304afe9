// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/common/Bandwidth.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstring>
#include <functional>
#include <thread>
#include <vector>

namespace bench {

namespace {

constexpr std::size_t numbers = std::size_t(1) << 25; ///< of an array: 256 MiB
constexpr int turns = 5;

/// @param work on the numbers from … until
/// @return seconds
double onAllProcessors(const std::function<void(std::size_t from, std::size_t until)>& work)
{
    const std::size_t count = std::max(1u, std::thread::hardware_concurrency());
    const auto begin = std::chrono::steady_clock::now();
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < count; ++i)
        threads.emplace_back(work, numbers * i / count, numbers * (i + 1) / count);
    for (std::thread& thread : threads)
        thread.join();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

} // namespace

Bandwidth measuredBandwidth()
{
    std::vector<double> a(numbers, 0.0);
    std::vector<double> b(numbers, 1.0);
    std::vector<double> c(numbers, 2.0);
    double triad = 1e9;
    double copy = 1e9;
    for (int turn = 0; turn < turns; ++turn) {
        const double factor = 0.5 + turn;
        triad = std::min(triad, onAllProcessors([&](std::size_t from, std::size_t until) {
            for (std::size_t i = from; i < until; ++i)
                a[i] = b[i] + factor * c[i];
        }));
        copy = std::min(copy, onAllProcessors([&](std::size_t from, std::size_t until) {
            std::memcpy(b.data() + from, a.data() + from, (until - from) * sizeof(double));
        }));
    }
    constexpr auto bytes = double(numbers * sizeof(double));
    return {.triad = 3.0 * bytes / triad, .copy = 2.0 * bytes / copy};
}

} // namespace bench
