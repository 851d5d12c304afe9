// SPDX-License-Identifier: Apache-2.0
#include "core/base/MemoryReserve.h"

#include <atomic>
#include <cstdio>

#include <sys/mman.h>
#include <unistd.h>

namespace core {

namespace {

/// For messages, a dialog, and what closing a session takes; SQLite's cache is 2 MB.
constexpr std::size_t reserveBytes = std::size_t(16) << 20;
/// As much as a library takes at a time when it is about to give up.
constexpr std::size_t someBytes = std::size_t(32) << 20;

std::atomic<void*> reserve = nullptr;
std::atomic<bool> refused = false;

void* take(std::size_t bytes)
{
    void* place =
        ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    return place == MAP_FAILED ? nullptr : place;
}

} // namespace

void keepMemoryReserve() noexcept
{
    void* none = nullptr;
    if (reserve.load() != nullptr)
        return;
    void* place = take(reserveBytes);
    if (place && !reserve.compare_exchange_strong(none, place))
        ::munmap(place, reserveBytes);
    refused = false;
}

void giveUpMemoryReserve() noexcept
{
    refused = true;
    if (void* place = reserve.exchange(nullptr))
        ::munmap(place, reserveBytes);
}

bool memoryWasRefused() noexcept
{
    return refused;
}

bool isMemoryShort() noexcept
{
    void* place = take(someBytes);
    if (place)
        ::munmap(place, someBytes);
    return place == nullptr;
}

std::size_t addressSpaceBytes() noexcept
{
    std::size_t pages = 0;
    if (std::FILE* file = std::fopen("/proc/self/statm", "re")) {
        if (std::fscanf(file, "%zu", &pages) != 1)
            pages = 0;
        std::fclose(file);
    }
    return pages * std::size_t(::sysconf(_SC_PAGESIZE));
}

} // namespace core
