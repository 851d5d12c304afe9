// SPDX-License-Identifier: Apache-2.0
#include "core/base/LargePages.h"

#include <cstdint>
#include <sys/mman.h>
#include <unistd.h>

namespace core {

namespace {

void advise(void* memory, std::size_t bytes, int advice)
{
    const auto page = std::uintptr_t(sysconf(_SC_PAGESIZE));
    const std::uintptr_t begin = (std::uintptr_t(memory) + page - 1) / page * page;
    const std::uintptr_t end = (std::uintptr_t(memory) + bytes) / page * page;
    // A wish: a kernel that does not do so says no, and nothing is lost.
    if (begin < end)
        (void)madvise(reinterpret_cast<void*>(begin), end - begin, advice);
}

} // namespace

void useLargePages(void* memory, std::size_t bytes)
{
    constexpr std::size_t least = 4u << 20;
    if (bytes >= least)
        advise(memory, bytes, MADV_HUGEPAGE);
}

void giveBackPages(void* memory, std::size_t bytes)
{
    advise(memory, bytes, MADV_DONTNEED);
}

} // namespace core
