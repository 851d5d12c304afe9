// SPDX-License-Identifier: Apache-2.0
#include "core/base/LargePages.h"

#include <cstdint>
#include <sys/mman.h>
#include <unistd.h>

namespace core {

void useLargePages(void* memory, std::size_t bytes)
{
    constexpr std::size_t least = 4u << 20;
    if (bytes < least)
        return;
    const auto page = std::uintptr_t(sysconf(_SC_PAGESIZE));
    const std::uintptr_t begin = (std::uintptr_t(memory) + page - 1) / page * page;
    const std::uintptr_t end = (std::uintptr_t(memory) + bytes) / page * page;
    // A wish: a kernel without them says no, and nothing is lost.
    (void)madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
}

} // namespace core
